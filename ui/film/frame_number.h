#pragma once

#include "ui/render/picture/image.h"

namespace penpose::film {

/// Where a number is drawn: the px of its middle and the height of its digits, px.
struct NumberPlace {
  double x = 0;
  double y = 0;
  double height = 16;
};

/// Draws a number of light digits; `on_dark`: upon a dark plate, so that it is read over any picture. What lies outside
/// of the picture is left out. Precondition: number at least 0.
void draw_number(render::Image& image, int number, const NumberPlace& place, bool on_dark);

/// How wide the digits of a number are, px.
[[nodiscard]] double number_width(int number, double height);

/// Draws a frame's number into the lower left corner of its picture.
void draw_frame_number(render::Image& image, int frame);

}  // namespace penpose::film
