#pragma once

#include <optional>
#include <string_view>

#include "core/io/picture_lines/svg/internal/affine.h"

namespace penpose::io {

/// A part of a drawing with units of its own: how wide and high it is in them.
struct Viewport {
  double width = 0;
  double height = 0;
};

/// A length in user units (SVG 1.1, section 7.10, with 96 px an inch and letters of 16 px); `whole` is what 100 %
/// stands for. Nothing where the text is none.
[[nodiscard]] std::optional<double> parse_length(std::string_view text, double whole);

/// The value of a `viewBox` attribute.
struct ViewBox {
  double x = 0;
  double y = 0;
  Viewport size;
};
/// Nothing where the text is none, or has no area.
[[nodiscard]] std::optional<ViewBox> parse_view_box(std::string_view text);

/// How what is in a view box fills a viewport, as `preserveAspectRatio` says (SVG 1.1, section 7.8); a text that says
/// nothing is xMidYMid meet.
[[nodiscard]] Affine fitted(const ViewBox& box, Viewport into, std::string_view preserve);

}  // namespace penpose::io
