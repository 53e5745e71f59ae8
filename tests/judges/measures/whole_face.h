#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/io/project/case_file.h"
#include "tests/judges/table/outcome.h"

namespace penpose::judges {

using geometry::ModelPoint;
using geometry::ModelVector;

/// Compares all vertices of a model with what they should do.
class WholeFace {
 public:
  /// `file`: all cases of the set; the box of their curves at rest is the face's size. `model` outlives this.
  WholeFace(const document::Model& model, const io::CaseFile& file);

  [[nodiscard]] const document::Model& model() const { return model_; }
  [[nodiscard]] const std::vector<ModelPoint>& rest() const { return rest_; }
  [[nodiscard]] double size() const { return size_; }
  /// The displacement of every vertex from rest.
  [[nodiscard]] std::vector<ModelVector> moved(const rig::Pose& pose) const;

  /// Fills in error and stray, or where the truth does not move, `still`:
  ///   error  root of the sum of squares of found less true over that of true, all vertices
  ///   stray  the largest movement of a vertex that should move by at most 0.02 of the most
  void judge(const std::vector<ModelVector>& truth, const std::vector<ModelVector>& found, Outcome& outcome) const;
  /// The mean distance from the posed curves to the lines that were drawn, seen from the view, per cent of the size.
  [[nodiscard]] double left(const io::PoseCase& one, const std::vector<ModelVector>& found) const;
  /// Controls that differ from rest by more than 0.02, and what they are, for people.
  void count_controls(const rig::Pose& pose, Outcome& outcome) const;

 private:
  const document::Model& model_;
  std::vector<ModelPoint> rest_;
  rig::Pose at_rest_;
  double size_ = 0;
};

}  // namespace penpose::judges
