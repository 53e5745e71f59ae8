#pragma once

#include <memory>

#include "tests/judges/drawing/signs/verdict.h"
#include "tests/judges/table/outcome.h"

namespace penpose::judges::drawn {

/// Reads drawings on a rig by the feature curves that the program finds by itself, and looks at the poses.
class FaceReading {
 public:
  /// Precondition: has_face(rig).
  explicit FaceReading(const Rig& rig);
  [[nodiscard]] const JudgedFace& face() const { return *face_; }

  /// What came of a drawing; nothing where the program refuses it.
  struct Came {
    Seen seen;
    std::string refused;  ///< what the program said; empty: it read the drawing
  };
  [[nodiscard]] Came read(const portrait::Drawing& drawing, Expression meant, std::optional<Side> side);
  /// The same as a row of the table. Where the rig can show no sign of what is meant, `of` is 0.
  [[nodiscard]] Outcome outcome(const portrait::Drawing& drawing, Expression meant, std::optional<Side> side);

 private:
  std::shared_ptr<const JudgedFace> face_;
  FaceJudge judge_;
  std::vector<portrait::FeatureCurve> curves_;  ///< empty: the program found none
  std::string refused_;
};

/// The last one is kept on each thread, as face_of does.
[[nodiscard]] FaceReading& reading_of(const Rig& rig);
/// The outcome of a drawing that was read as one of a face at rest, judged as one of no face.
[[nodiscard]] Outcome as_thing(Outcome outcome);

}  // namespace penpose::judges::drawn
