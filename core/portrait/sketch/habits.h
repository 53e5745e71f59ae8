#pragma once

#include <array>
#include <span>

#include "core/portrait/sketch/face_layout.h"

// How people draw faces: where parts lie, and how they look at rest. Lengths in distances of the eyes.

namespace penpose::portrait {

enum class LineForm : unsigned char { any, open, closed };

/// Where a part is drawn: the middle of a line and the logarithms of its width and height are normally distributed.
struct PartHabit {
  FacePart part;
  bool sides;  ///< of both sides; x is then that of either
  double x, x_spread, y, y_spread;
  double width, width_spread, height, height_spread;  ///< spreads of logarithms
  double base;                                        ///< of how rare it is
  LineForm form = LineForm::any;
};
[[nodiscard]] std::span<const PartHabit> part_habits();

inline constexpr double k_least_size = 0.035;
inline constexpr double k_unknown_cost = 5.5;
/// A line that costs more than this is no mouth.
inline constexpr double k_most_mouth_cost = 3.25;
inline constexpr double k_around_cost = 3.5;
inline constexpr double k_face_half_width = 1.1, k_face_above = 0.9, k_face_below = 1.9;
inline constexpr double k_mouth_reach = 0.15;
inline constexpr double k_nostril_cost = 0.8;
/// The ends of a line meet if they are nearer to each other than this share of its length.
inline constexpr double k_ends_meet = 0.12;
/// The outline of a pen stroke is so many times as long as thick.
inline constexpr double k_thin_stroke = 9;
/// Without brows, eyes and mouth together cost no more than this.
inline constexpr double k_most_doubtful = 3.4;
/// A straight line for an eye that tilts at least so much is drawn for its brow.
inline constexpr double k_slanted = 0.25, k_straight_slant = 0.95;
/// What lies outside of the head.
inline constexpr double k_outside_cost = 1.0;
/// Lines this far apart touch; the cost of a pupil that touches no border of its eye.
inline constexpr double k_touch = 0.05, k_stray_pupil_cost = 2.0;
/// Hatching: strokes no longer than this share of the drawing's diagonal and straight (the distance of the ends over
/// the length), whose lengths differ by no more than the ratio, whose middles are no farther apart than so many lengths
/// and whose directions have at least the cosine; at least so many, in a row that is so many times as long as they.
inline constexpr double k_longest_hatch = 0.06, k_straight_hatch = 0.75, k_unlike_hatches = 2.5, k_hatches_apart = 1.0,
                        k_parallel_hatches = 0.7, k_row_of_hatches = 1.5;
inline constexpr std::size_t k_fewest_hatches = 4;
/// A stroke of a brow is no less likely than the likeliest one by more than this.
inline constexpr double k_less_likely = 2.0;
/// What is this far within the outline of the head is no outline.
inline constexpr double k_within_outline = 0.15;
/// Sizes of faces that are tried, in usual ones for the distance of their eyes, for so many pairs of eyes, and the cost
/// of the square of the logarithm.
inline constexpr std::array<double, 5> k_scales{1.0, 0.8, 1.25, 1.5, 1.8};
inline constexpr std::size_t k_most_scaled = 8;
inline constexpr double k_scale_cost = 2.0;
/// A line that runs to and fro is longer than this many times its width and height together; a ring is 1.6 times.
inline constexpr double k_tangled = 2.2;
/// So does one that turns more than this from one 32nd of its length to the next, radians.
inline constexpr double k_scribbled = 0.75;
/// A box is filled by this share of its width and height, and is no lower than the other share of its width; a ring
/// fills 0.79.
inline constexpr double k_box_filled = 0.91, k_box_height = 0.4;
/// The distance of a straight line's ends is more than this share of its length.
inline constexpr double k_straight = 0.995;
inline constexpr double k_longer_than_mouth = 1.1;
inline constexpr double k_lone_brow_cost = 0.3, k_no_brows_cost = 0.5;
inline constexpr double k_most_roll = 0.45, k_largest_eye = 1.05, k_smallest_eye = 0.06, k_largest_wink = 0.6,
                        k_least_alike = 0.25;
/// The cost of eyes that differ, a unit of `unlike`, and the most units that count.
inline constexpr double k_unlike_cost = 0.25, k_most_unlike = 1.0;
/// Lines of both eyes that are no more unlike than this are counterparts.
inline constexpr double k_counterpart = 0.9, k_counterpart_off = 2.0;
inline constexpr double k_refined_gain = 0.2;
/// Lines nearer than this share of a part's width are one line, drawn twice.
inline constexpr double k_doubled = 0.07;
/// Pupils whose radius is a smaller share of the opening say nothing of lids.
inline constexpr double k_small_pupil = 0.28;
/// A mouth of three lines that is higher than this share of its width is open.
inline constexpr double k_open_height = 0.4;
/// Two shut lips of equal height are at most this share of the width high.
inline constexpr double k_highest_lips = 0.65;
/// Lines of a mouth from corner to corner are at least this share of its width.
inline constexpr double k_from_corner_to_corner = 0.72, k_seam = 0.45, k_seam_inset = 0.04, k_one_seam = 0.15,
                        k_middle_of_lips = 0.25, k_flat_seam = 0.4;
/// A line beside lids that is narrower than this share of its height is a lash.
inline constexpr double k_lash = 0.3;
/// A line is wavy that strays from a bend by this share of the width of the mouth; a tongue is so upright and so wide.
inline constexpr double k_wavy = 0.035, k_tongue_upright = 0.8, k_tongue_width = 0.1;
/// Lips are drawn no higher than this share of the width.
inline constexpr double k_lip_height = 0.22;
inline constexpr double k_wrinkle_height = 0.22, k_wrinkles_above = 0.4;
/// The corners of an open mouth that laughs are this share of the gap above its middle.
inline constexpr double k_laughing = 0.3;
/// Corners of a mouth that laughs are raised at least so far, of its width.
inline constexpr double k_laughs = 0.08;
/// An open mouth narrows by no more than this.
inline constexpr double k_narrowed_open = 0.25;
/// Brows that tilt inwards more than this are angry, and not raised. Eyes that are shut this far are squeezed.
inline constexpr double k_angry_tilt = 0.2, k_squeezed = 0.3;
/// How far lids part where a face is frightened or surprised, and how far an upper lip rises in disgust, of the mouth's
/// width.
inline constexpr double k_startled = 0.4, k_sneer = 0.12;
inline constexpr double k_narrow_mouth = 0.5;
/// Lips are about as high as each other: a gap so much higher than the other one is the opening.
inline constexpr double k_uneven_lips = 1.6;
/// A mouth of one flat line is wide only if it exceeds the usual width by more than this share.
inline constexpr double k_widest_flat = 0.6;

/// The mean and the standard deviation of a measure in drawings of faces at rest.
struct Usual {
  double mean, spread;
};
inline constexpr Usual k_tilt{-0.06, 0.08}, k_brow_gap{0.29, 0.055}, k_low_brow{0.29, 0.12}, k_corner{0.0, 0.03},
    k_corner_skew{0.0, 0.04}, k_mouth_width{0.8, 0.15}, k_gap{0.0, 0.04}, k_covered{0.0, 0.12}, k_closing{0.0, 0.1},
    k_arched{0.57, 0.13};
/// Differences below this many spreads are no expression; those above the other one are nothing else.
inline constexpr double k_from = 1.7, k_whole = 2.6;
/// A line for an eye is a shut eye where both eyes are lines and bend by this share of their width.
inline constexpr double k_shut_bend = 0.12;
/// A smile widens the mouth by this much of what it raises the corners.
inline constexpr double k_smile_widens = 0.8;
/// What is clearly drawn of a tilt and of a gap, and the share of it that a face has to show.
inline constexpr double k_clear_tilt = 0.22, k_clear_gap = 0.15, k_shown = 0.25;
/// Two sides that differ by at most this are meant alike.
inline constexpr double k_even_lids = 0.6, k_even_brows = 0.12, k_even_tilts = 0.3;
/// An eye without an iris that is opened less than this share of its width is partly shut.
inline constexpr double k_half_open = 0.26;
/// Lids at rest are this far apart, of the width of the eye: the median of drawings.
inline constexpr double k_opening = 0.5;
/// An eye that is opened less than this share of the other is partly shut.
inline constexpr double k_unlike = 0.6;
/// Expressions are limited to what faces can do.
inline constexpr double k_widest = 0.5, k_most_tilt = 0.7, k_most_raise = 0.3, k_most_corner = 0.18, k_most_open = 0.8,
                        k_most_narrowed = 0.5, k_most_widened = 0.35;
/// A brow tilts about this share of its length from the inner end.
inline constexpr double k_tilt_pivot = 0.75;
/// Lips part upwards by this share of the gap, between jaws that drop (0) and vowels (0.2). The corners of a mouth that
/// opens stay above the middle of its lips by the second share, and the mouth narrows by the third one: the medians of
/// controls of ten rigs.
inline constexpr double k_upper_of_gap = 0.1, k_corners_stay = 0.2, k_open_narrows = 0.15;
/// The least weight of a point of lips that open, which at the middle is one more.
inline constexpr double k_least_weight = 0.02;
/// So the corners drop by this share.
inline constexpr double k_corners_drop = 0.5 - k_upper_of_gap - k_corners_stay;
/// The standard deviation between a sketch and what it means, in distances of the eyes.
inline constexpr double k_sketch_doubt = 0.025;
/// The standard deviation of a hand that draws over a face, in distances of the eyes.
inline constexpr double k_hand_over_face = 0.0086;
/// The only line of a mouth over a face is one border of its opening if shut lips, which are both, cost so much more.
inline constexpr double k_lone_border = 20;
/// A drawing of at least this many lines shows a whole face.
inline constexpr std::size_t k_whole_face = 6;
/// Drawings whose lines cost more than this, on the mean, are no faces.
inline constexpr double k_most_cost = 3.2;
/// Doubt where the same hand drew the face at rest, and where the model's own features are those at rest.
inline constexpr double k_same_hand = 0.6, k_over_face = 0.6;

}  // namespace penpose::portrait
