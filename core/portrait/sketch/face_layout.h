#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::portrait {

using geometry::PxPoint;

/// The part of a face that a drawn line shows.
enum class FacePart : unsigned char {
  eye,    ///< the border of an eye, a lid, or all of a closed eye
  pupil,  ///< a pupil, an iris, a dot for an eye
  fold,   ///< a crease above a lid, a bag below it, lashes
  brow,
  nose,
  mouth,
  corner,   ///< a short line at a corner of the mouth
  cheek,    ///< blush, a fold beside the mouth, wrinkles
  outline,  ///< of the head, or of the jaw alone
  around,   ///< hair, ears, neck, clothes: what lies about a face
  unknown
};

/// A line of a drawing in the frame of its face: the middle between the eyes is (0, 0), the eyes are 1 apart, x points
/// to the right of the picture and y down.
struct FaceMark {
  std::vector<PxPoint> points;  ///< evenly along the line
  PxPoint low{0, 0}, high{0, 0};
  double length = 0;
  double turning = 0;   ///< mean angle between neighbouring pieces, radians
  bool closed = false;  ///< its ends meet
  FacePart part = FacePart::unknown;
  bool right = false;  ///< of parts of two sides: at the right of the picture, so on the face's left
  double cost = 0;     ///< -log of how likely it is, less a constant

  [[nodiscard]] PxPoint middle() const { return (low + high) * 0.5; }
  [[nodiscard]] PxPoint size() const { return high - low; }
};

/// The place of a face on a sheet and the part that each line shows.
struct FaceLayout {
  PxPoint middle{0, 0};                   ///< between the eyes, px of the sheet
  PxPoint along{1, 0};                    ///< from the middle of the eye at the left to that of the other, px
  double scale = 1;                       ///< the size of the face, without its eyes, as a multiple of the usual one
  std::vector<FaceMark> marks;            ///< one a line, or one for strokes that hatch together
  std::vector<std::size_t> mark_of_line;  ///< one a line: its number in `marks`
  double cost = 0;                        ///< of the lines within the face, mean
  [[nodiscard]] PxPoint in_frame(const PxPoint& p) const;
  [[nodiscard]] PxPoint on_sheet(const PxPoint& p) const;
};

/// Finds the face of a drawing from how faces are laid out: two things that are alike beside each other are its eyes,
/// and each other line is the part that is likeliest there. `eyes_cost` adds to the cost of two lines as the eyes.
/// Returns nothing if no two lines can be the eyes of a face with a mouth.
using EyesCost = std::function<double(std::size_t left, std::size_t right)>;
[[nodiscard]] std::optional<FaceLayout> find_face(std::span<const std::vector<PxPoint>> lines,
                                                  const EyesCost& eyes_cost = {});

/// Labels lines in a known frame, of a whole face or of a part of it; `middle` and `along` are those of FaceLayout.
[[nodiscard]] FaceLayout lay_out(std::span<const std::vector<PxPoint>> lines, PxPoint middle, PxPoint along);

/// Returns the name of a part, for people.
[[nodiscard]] const char* name_of(FacePart part);

}  // namespace penpose::portrait
