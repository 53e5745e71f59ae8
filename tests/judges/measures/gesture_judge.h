#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/judges/cases/gestures.h"
#include "tests/judges/measures/whole_face.h"

namespace penpose::judges {

/// Says whether a gesture was read as an artist means it:
///   right    something of each needed group moves by a tenth of what moves most, the needed is at least half of all
///            movement, all else than needed and accepted at most 0.2 of it, and no other joint turns by more than half
///            a degree; or the whole face is within 45 % of what bounded least squares with the needed and accepted
///            shapes make of the lines
///   nothing  the drawn curves go less than 0.15 of the way that they were drawn; right where no control does what was
///            drawn and no vertex moves by more than 0.2 % of the size
///   stray    the largest movement of a vertex that no needed or accepted control moves and no line is drawn along
/// Movement is that of all vertices. A control that does what a needed one does (cosine 0.99) counts as that one.
class GestureJudge {
 public:
  explicit GestureJudge(const WholeFace& face);
  /// Fills in right, nothing, of, stray and a note.
  void judge(const Gesture& gesture, const rig::Pose& pose, Outcome& outcome);

 private:
  using Names = std::vector<std::string>;
  struct Asked {
    std::vector<std::vector<geometry::PxPoint>> ways;  ///< of each vertex of each reference, px
    double asked = 0, went = 0;                        ///< sums of squares
  };
  struct Moved {
    std::string control;
    double way = 0;      ///< root of the sum of squares over all vertices
    double degrees = 0;  ///< of a joint
  };
  [[nodiscard]] const std::vector<ModelVector>& field(std::size_t parameter);
  [[nodiscard]] const std::vector<ModelVector>* shape_field(const std::string& control);
  [[nodiscard]] bool is_like(const std::string& control, const Names& group);
  [[nodiscard]] Asked asked_of(const Gesture& gesture, const std::vector<ModelVector>& found) const;
  [[nodiscard]] std::vector<Moved> moved_by(const rig::Pose& pose);
  [[nodiscard]] bool looks_meant(const Gesture& gesture, const Asked& asked, const std::vector<ModelVector>& found);
  [[nodiscard]] double stray(const Gesture& gesture, const std::vector<ModelVector>& found);
  [[nodiscard]] Names allowed(const Gesture& gesture) const;

  const WholeFace& face_;
  rig::Pose rest_;
  std::map<std::size_t, std::vector<ModelVector>> fields_;
};

}  // namespace penpose::judges
