#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/features/vertex_curve.h"
#include "core/document/model.h"
#include "core/intent/model/whole_model.h"
#include "core/portrait/feature_curve.h"

namespace penpose::document {

/// The feature curves of a face, and those that were looked for and are not sure enough to be used. Eyes, brows and
/// lips are used even if they are unsure.
struct FeatureCurves {
  std::vector<portrait::FeatureCurve> curves;
  std::vector<portrait::FeatureCurve> unsure;
  std::vector<std::string> doubtful;  ///< names of curves that are used and unsure
  bool found = false;                 ///< some by the shape of the face, by no name
};

/// How a feature was corrected (Model::features); null: it was not.
[[nodiscard]] const NamedCurve* find_correction(const Model& model, const std::string& name);

/// Those of a file where there are any (`named`); else those that were corrected and those that the model names, and
/// what they leave open: those of a head that is known, and those found from the shape of the face and what its
/// controls move. Errors (place: the curve): a vertex that the model does not have; nothing was found.
[[nodiscard]] base::Result<FeatureCurves> feature_curves_of(const Model& model, const intent::WholeModel& whole,
                                                            const std::vector<VertexCurve>& named);

}  // namespace penpose::document
