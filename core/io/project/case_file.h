#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::io {

/// The direction in which a line was drawn: the camera turned about +y by `yaw_degrees` (0 looks along -z, 90 along -x)
/// and raised by `pitch_degrees`.
struct CaseView {
  double yaw_degrees = 0;
  double pitch_degrees = 0;  ///< -90..90
};

/// A curve through vertices of the model and where it should go. In the points form target i belongs to vertex i; in
/// the drawn form the target is a line of any number of points.
struct CaseReference {
  std::string curve;
  std::vector<std::uint32_t> vertices;       ///< at least 2, in order along the curve
  std::vector<geometry::ModelPoint> target;  ///< at least 2, not all at one place; model units
  std::optional<CaseView> view;              ///< from where this line was drawn; else the case's own view
};

/// A curve through vertices that should stay where it is.
struct CaseConstraint {
  std::string curve;
  std::vector<std::uint32_t> vertices;
};

struct PoseCase {
  std::string name;
  std::vector<std::string> free;    ///< parameters that the solver may move; empty: the file names none
  std::vector<std::string> locked;  ///< parameters that stay whatever is free
  std::vector<CaseReference> references;
  std::vector<CaseConstraint> constraints;
  double view_yaw_degrees = 0;                          ///< camera about +y; 0 looks along -z
  std::vector<std::pair<std::string, double>> weights;  ///< the known answer by parameter name; may be empty
  std::optional<double> rest_energy;                    ///< model units
  std::optional<double> optimum_energy;                 ///< model units
};

/// A file of posing cases, as `penpose pose --cases` takes it.
struct CaseFile {
  std::string mesh;  ///< the model that the cases were made for; may be empty
  std::vector<PoseCase> cases;
};

/// How the targets of a case file are meant.
enum class TargetForm : std::uint8_t { points, drawn };

/// Reads the JSON of a case file. Keys that are not known are skipped. Errors (place: JSON pointer): no JSON, a key
/// that is missing or of another type, a curve of one point, a target without length, two cases of one name.
[[nodiscard]] base::Result<CaseFile> read_cases(base::Bytes bytes);

/// Whether the cases fit the model. Errors (place: JSON pointer in the case file): a parameter that the model does not
/// have, a vertex out of range, a curve without length; in the points form another number of targets than of vertices.
[[nodiscard]] base::Status check_cases(const CaseFile& file, const document::Model& model,
                                       TargetForm form = TargetForm::points);

}  // namespace penpose::io
