#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/portrait/reading/likeness.h"

namespace penpose::portrait {

/// The stretch of a line that is nothing known.
inline constexpr std::size_t k_nothing = static_cast<std::size_t>(-1);
/// What such a line costs: the likelihood of any smooth line on the sheet, and that it is drawn at all.
inline constexpr double k_nothing_cost = 84.0;

/// What a line was taken for.
struct Label {
  std::size_t stretch = 0;  ///< k_nothing: nothing known
  bool reversed = false;    ///< drawn from the end of the stretch to its beginning
  double cost = 0;          ///< Likeness::cost
  /// Another that the same line is as well, as shut lips are one line.
  std::size_t also = k_nothing;
  friend bool operator==(const Label& a, const Label& b) { return a.stretch == b.stretch && a.reversed == b.reversed; }
};

/// What each line may be, the best first: at most `count`, none above the best one's cost by more than `window`.
[[nodiscard]] std::vector<std::vector<Label>> candidates_of(const Likeness& likeness, const FaceView& face,
                                                            std::span<const Trace> lines, std::size_t count,
                                                            double window);
/// The best label of each curve for one line, the best first, at most `count` within `window` of the best.
[[nodiscard]] std::vector<Label> curves_for(const Likeness& likeness, const FaceView& face, const Trace& line,
                                            std::size_t count, double window);

/// The best label of one curve for a line, however unlikely. Precondition: the face has that curve.
[[nodiscard]] Label label_of_curve(const Likeness& likeness, const FaceView& face, const Trace& line,
                                   std::size_t curve);

/// Mean distances between lines, each from the one that is nearer to the other on the whole; n * n, px.
[[nodiscard]] std::vector<double> distances_between(std::span<const Trace> lines);

/// What two lines of one curve cost: little where they continue each other or lie upon each other, much where they
/// should lie upon each other and do not. `apart`: their distance, px.
[[nodiscard]] double cost_of_both(const Stretch& a, const Stretch& b, double apart);

/// What curves cost that are drawn without their companion (FaceView::companion). `drawn`: how much of each curve is,
/// as shares of its length; a small part of a companion is none. A hand that draws over a face may draw a part of it;
/// of a mouth, its opening first.
[[nodiscard]] double cost_of_lone_curves(const FaceView& face, std::span<const double> drawn, const Hand& hand);

/// The labels of least cost, together with what lines of one curve and lone curves cost: by branch and bound.
struct Assignment {
  std::vector<Label> labels;
  double cost = 0;
};
[[nodiscard]] Assignment assign(const FaceView& face, std::span<const std::vector<Label>> candidates,
                                std::span<const double> distances, const Hand& hand);

}  // namespace penpose::portrait
