#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/portrait/face_view.h"
#include "core/portrait/placement.h"
#include "core/portrait/reading/assignment.h"

// One drawing of a whole face: lines without labels, in any order, not quite in place.

namespace penpose::portrait {

/// A drawing has at most `k_most_drawn_lines` lines. Only drawings of at most `k_most_lines` are compared with the
/// model line by line.
inline constexpr std::size_t k_most_drawn_lines = 400;
inline constexpr std::size_t k_most_lines = 60;

/// A line of a drawing, px of the sheet, x to the right, y down. At least two points, not all at one place.
using DrawnLine = std::vector<PxPoint>;

/// What somebody said a line is: a curve of the face, or k_nothing; none: it is to be found.
using GivenLabel = std::optional<std::size_t>;

/// Lines of one sheet; a second sheet by the same hand may show the face at rest in the same view.
struct Drawing {
  std::vector<DrawnLine> lines;
  std::vector<DrawnLine> neutral = {};  ///< empty: none
  /// Both were drawn over the face, px of its camera's picture: they lie about where they are meant, unless all that is
  /// drawn fits much better elsewhere.
  bool in_view = false;
  std::vector<GivenLabel> given = {};          ///< one a line; empty: all are to be found
  std::vector<GivenLabel> given_neutral = {};  ///< the same of `neutral`
  bool traced = false;                         ///< from a picture of this model: its lines are compared with it alone
};

/// What a line was taken for: a stretch of a curve. Of a line that is drawn around something, as an eye is, that is its
/// upper half, and the lower one is another.
struct LineRead {
  std::optional<std::size_t> curve;  ///< of those of the face; none: nothing known
  double from = 0, to = 1;           ///< shares of the curve's length
  bool reversed = false;             ///< drawn from its end to its beginning
  std::optional<std::size_t> lower;  ///< the curve of the lower half of a line that is drawn around
};

/// Checks the lines of a sheet. Errors (place: the sheet and its line): no lines, more than k_most_drawn_lines, lines
/// without length, numbers that are not finite.
[[nodiscard]] base::Status check_lines(std::span<const DrawnLine> lines, const char* sheet);

struct DrawingRead {
  std::vector<double> shares;   ///< one a control of the face
  std::vector<LineRead> lines;  ///< one a line
  std::vector<LineRead> neutral;
  Placement placement;              ///< of the sheet on the face's own picture
  std::vector<double> proportions;  ///< by how much the drawing's differ, one a proportion of the face
  double energy = 0;                ///< what was minimised
  bool of_this_face = true;         ///< the lines are those of this face; otherwise nothing of them is known
};

/// Reads all lines of a drawing together: which curve each is, where the face lies on the sheet, in what proportions it
/// is drawn, and which few controls make the rest of the difference. Labels are first the likeliest ones for each line
/// under what a face may do at all (Likeness), then those of least energy together with the pose (LineSystem,
/// SparseSolver), one line or two changed at a time. Errors (place: the line): no lines, too many, lines without
/// length, numbers that are not finite; (place: "given") labels that are no curves of the face.
[[nodiscard]] base::Result<DrawingRead> read_drawing(const FaceView& face, const Drawing& drawing);

}  // namespace penpose::portrait
