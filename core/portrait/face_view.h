#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "core/intent/model/whole_model.h"
#include "core/portrait/feature_curve.h"
#include "core/portrait/proportions.h"
#include "core/rig/rig.h"

namespace penpose::portrait {

using geometry::PxPoint;

/// The most curves of a face, and the most controls that are asked what they do to them: those that move them farthest.
inline constexpr std::size_t k_most_curves = 60;
inline constexpr std::size_t k_most_controls = 400;

/// Lines and stretches of curves are compared at so many points, evenly spaced along them.
inline constexpr std::size_t k_points = 12;
inline constexpr std::size_t k_numbers = 2 * k_points;
/// The x and y of each of those points, one after the other.
using Trace = std::array<double, k_numbers>;

/// The diagonal of a face in its own picture: the unit in which all widths of doubt are given.
inline constexpr double k_face_px = 800.0;

/// A symmetric matrix of the numbers of a trace, by rows; the lower half is kept.
using Spread = std::array<double, k_numbers * k_numbers>;
/// spread += factor^2 way way'.
void add_way(const Trace& way, double factor, Spread& spread);

/// A control that moves curves, as shares of its range from where it starts.
struct Control {
  std::size_t parameter = 0;
  double low = 0;   ///< <= 0
  double high = 0;  ///< >= 0
};

/// Controls that are chosen together: one, or those of both sides by the same share.
struct Unit {
  std::array<std::size_t, 2> members{};
  std::size_t count = 1;
  bool one_side = false;  ///< one of a pair, alone
};

/// A part of a curve that a line may be, and how it moves in the picture.
struct Stretch {
  std::size_t curve = 0;
  double from = 0, to = 1;  ///< shares of the curve's length
  Trace rest{};
  std::vector<Trace> ways;         ///< of each control's whole range
  std::vector<Trace> proportions;  ///< of each proportion doubled
  double length = 0;               ///< px, at rest
  [[nodiscard]] bool whole() const { return from == 0.0 && to == 1.0; }
};

/// The feature curves of a model as one camera sees them, scaled to k_face_px, and what moves them: the controls and
/// the proportions in which a drawing may differ from the model.
class FaceView {
 public:
  /// `start`: the pose at which nothing has moved. `free`: the parameters that may move, ascending; those that move no
  /// curve by half a px or more, and joints that carry the whole face, are left out, and so are the weakest beyond
  /// k_most_controls.
  /// Errors: no curves or too many, a curve without length in the view or behind the camera, numbers that are not
  /// finite.
  static base::Result<FaceView> make(const rig::Rig& rig, const intent::WholeModel& whole,
                                     std::span<const FeatureCurve> curves, const rig::Pose& start,
                                     std::span<const std::size_t> free, const geometry::Camera& camera);

  [[nodiscard]] std::span<const Stretch> stretches() const { return stretches_; }
  /// How controls spread one of stretches() by their usual shares.
  [[nodiscard]] const Spread& spread(std::size_t stretch) const { return spreads_[stretch]; }
  /// The same of the middle of its points: xx, xy, yy.
  [[nodiscard]] const std::array<double, 3>& spread_of_middle(std::size_t stretch) const {
    return middle_spreads_[stretch];
  }
  [[nodiscard]] std::span<const Control> controls() const { return controls_; }
  [[nodiscard]] std::span<const Unit> units() const { return units_; }
  [[nodiscard]] std::size_t curve_count() const { return curve_count_; }
  [[nodiscard]] std::size_t proportion_count() const { return all_proportions_.size(); }
  [[nodiscard]] Part part(std::size_t curve) const { return parts_[curve]; }
  /// A curve that is drawn wherever this one is: the brow and the upper lid of the other side, the upper lid above the
  /// lower one, the other border of the lips.
  [[nodiscard]] std::optional<std::size_t> companion(std::size_t curve) const { return companions_[curve]; }
  /// The borders of the mouth's opening (parting_of).
  [[nodiscard]] const std::optional<std::array<std::size_t, 2>>& parting() const { return parting_; }
  /// The curve of the model that one stands for; none: the model has no such feature, but drawings of faces do.
  [[nodiscard]] std::optional<std::size_t> meant(std::size_t curve) const { return meant_[curve]; }
  /// How far controls move a curve, px, root mean square of what is usual.
  [[nodiscard]] double unrest(std::size_t curve) const { return unrest_[curve]; }
  /// The points of a curve at rest, evenly along it.
  [[nodiscard]] std::span<const PxPoint> rest_line(std::size_t curve) const { return lines_[curve]; }
  /// How those points move where a proportion is doubled, one a proportion.
  [[nodiscard]] std::vector<std::vector<PxPoint>> proportion_lines(std::size_t curve) const;
  /// The same face as somebody draws it whose lines at rest are these (one a curve, as many points as rest_line): what
  /// controls do goes along with the smooth map of the face to them (SheetWarp). `at_rest`: the lines are known, and
  /// are those at rest; otherwise the model's stay, with their proportions.
  [[nodiscard]] FaceView drawn_as(const std::vector<std::vector<PxPoint>>& lines, bool at_rest) const;
  /// The middle of the face in the camera's picture, and px of the face for each px of it.
  [[nodiscard]] PxPoint middle() const { return middle_; }
  [[nodiscard]] double scale() const { return scale_; }
  /// Where a place of the camera's picture is on the face.
  [[nodiscard]] PxPoint on_face(const PxPoint& p) const { return (p - middle_) * scale_; }
  /// A part of a curve. Precondition: 0 <= from < to <= 1.
  [[nodiscard]] Stretch stretch(std::size_t curve, double from, double to) const;
  /// The whole of a curve.
  [[nodiscard]] const Stretch& curve(std::size_t c) const { return stretches_[c * stretches_per_curve()]; }
  [[nodiscard]] static std::size_t stretches_per_curve();
  /// What kinds of curves a placement may start from: shares of the face that drawings leave out together.
  [[nodiscard]] const std::vector<std::vector<std::size_t>>& groups() const { return groups_; }

 private:
  FaceView() = default;

  using Line = std::vector<PxPoint>;

  std::vector<Line> lines_;                                ///< one a curve, evenly along it
  std::vector<std::vector<Line>> ways_, all_proportions_;  ///< one a control or a proportion
  std::vector<double> lengths_;
  void measure_spreads();

  std::vector<Stretch> stretches_;
  std::vector<Spread> spreads_;
  std::vector<std::array<double, 3>> middle_spreads_;
  std::vector<Control> controls_;
  std::vector<Unit> units_;
  std::vector<double> unrest_;
  std::vector<std::vector<std::size_t>> groups_;
  std::optional<std::array<std::size_t, 2>> parting_;
  std::vector<Part> parts_;
  std::vector<std::optional<std::size_t>> companions_, meant_;
  std::size_t curve_count_ = 0;
  PxPoint middle_{0, 0};  ///< of the face in the camera's picture
  double scale_ = 1;
};

/// A typical share of its range that a unit moves.
[[nodiscard]] double usual_share(const Unit& unit);

/// `count` points evenly along a line.
[[nodiscard]] Trace trace_of(std::span<const PxPoint> line);

}  // namespace penpose::portrait
