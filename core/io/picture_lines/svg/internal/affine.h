#pragma once

#include <optional>
#include <string_view>

#include "core/geometry/space.h"

namespace penpose::io {

/// A map of the plane as SVG writes it: matrix(a b c d e f), x' = a x + c y + e, y' = b x + d y + f.
struct Affine {
  double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

  [[nodiscard]] geometry::PxPoint operator()(geometry::PxPoint p) const {
    return {a * p.x + c * p.y + e, b * p.x + d * p.y + f};
  }
};

/// First `inner`, then `outer`.
[[nodiscard]] Affine operator*(const Affine& outer, const Affine& inner);
[[nodiscard]] inline Affine translation(double x, double y) { return {1, 0, 0, 1, x, y}; }
[[nodiscard]] inline Affine scaling(double x, double y) { return {x, 0, 0, y, 0, 0}; }

/// The value of a `transform` attribute (SVG 1.1, section 7.6). Nothing where it is none.
[[nodiscard]] std::optional<Affine> parse_transform(std::string_view text);

}  // namespace penpose::io
