#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tests/judges/drawing/faces/artist.h"
#include "tests/judges/drawing/judged_face.h"

namespace penpose::judges::drawn {

/// How far a drawing may be from the model.
struct Freedom {
  double off = 0;     ///< share by which proportions differ, and place where it is drawn over the face
  bool over = false;  ///< over the face that a view shows; else anywhere on a sheet of its own
};

/// A line and the marks that it may rightly be taken for: its own, those at the same place, those that it is part of.
struct MeantLine {
  portrait::DrawnLine points;
  std::vector<std::size_t> right;
};

/// A drawing of a pose that is known.
struct KnownDrawing {
  std::vector<MeantLine> lines;
  bool over = false;
  double yaw_degrees = 0;

  [[nodiscard]] portrait::Drawing drawing() const;
};

/// The marks of a pose, drawn by an artist's pen: five to twelve lines in any order and direction. Each control that is
/// not at rest keeps a line that it moves much. Half of the drawings are from the front, others from up to 20 degrees
/// beside it; the view and the choice of lines are those of `face_seed`, everything else is that of `hand_seed`.
[[nodiscard]] KnownDrawing draw_known(const JudgedFace& face, const rig::Pose& pose, const Artist& artist,
                                      const Freedom& freedom, std::uint64_t face_seed, std::uint64_t hand_seed);

/// How many lines were taken for a mark that is right. `read`: one a line; empty: nothing was read.
[[nodiscard]] std::size_t right_labels(const KnownDrawing& drawing, std::span<const portrait::LineRead> read);

/// Whether drawn lines can show a pose: some mark moves by a hundredth of the face or more, seen from the front.
[[nodiscard]] bool is_shown_by_lines(const JudgedFace& face, const rig::Pose& pose);

}  // namespace penpose::judges::drawn
