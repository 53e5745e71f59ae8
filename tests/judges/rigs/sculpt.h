#pragma once

#include "tests/judges/rigs/parts.h"

namespace penpose::judges {

/// One at `center`, smooth, next to nothing beyond twice `radii`.
[[nodiscard]] std::vector<double> around(std::span<const ModelPoint> places, const ModelPoint& center,
                                         const ModelVector& radii);
/// From 0 at `low` to 1 at `high`, without corners.
[[nodiscard]] double smooth_step(double low, double high, double x);

[[nodiscard]] Field pushed(std::span<const double> share, const ModelVector& way);
/// About an axis through `center`; each vertex takes its share of the displacement.
[[nodiscard]] Field turned(std::span<const ModelPoint> places, std::span<const double> share, const ModelPoint& center,
                           const ModelVector& axis, double degrees);
[[nodiscard]] Field times(const Field& field, std::span<const double> share);
[[nodiscard]] std::vector<double> product(std::span<const double> a, std::span<const double> b);
/// field += amount other. Precondition: as many vertices.
void add_to(Field& field, double amount, const Field& other);

/// The shares of the +x (`left`) or -x side, which meet softly over `width`.
[[nodiscard]] std::vector<double> side_share(std::span<const ModelPoint> places, bool left, double width);

/// Adds stretch_, dimple_, press_, lower_down_, puff_, funnel, roll_, shrug_, mouth_, jaw_ and lips_close from the
/// lines of the mouth, pucker, upper_up_ and jaw_open.
void add_mouth_fields(Parts& parts);

}  // namespace penpose::judges
