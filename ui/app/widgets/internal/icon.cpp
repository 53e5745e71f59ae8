#include "ui/app/widgets/internal/icon.h"

#include <cstdlib>

// The language: a letter and its numbers, in a square of 24 by 24, y down. M x y begins a line and ends the one before;
// L x y goes on; A x y r from to is an arc about x y, in degrees clockwise from the right; Z closes the line, F fills
// it; C x y r is a circle, D x y r a disc.

namespace penpose::app {
namespace {

constexpr float k_square = 24;
constexpr float k_line = 1.9F;
constexpr float k_radian = 3.14159265F / 180;

/// Numbers of a drawing, one after the other.
struct Reader {
  const char* at;
  const char* end;
  float number() {
    while (at < end && (*at == ' ')) ++at;
    char* next = nullptr;
    const float value = std::strtof(at, &next);
    at = next > at ? next : at + 1;
    return value;
  }
};

}  // namespace

void draw_icon(ImDrawList& list, std::string_view icon, ImVec2 middle, float size, ImU32 color) {
  const float unit = size / k_square;
  const float line = k_line * unit;
  const auto x = [&](float value) { return middle.x + (value - 0.5F * k_square) * unit; };
  const auto y = [&](float value) { return middle.y + (value - 0.5F * k_square) * unit; };
  Reader read{icon.data(), icon.data() + icon.size()};
  const auto end_line = [&](ImDrawFlags flags) {
    if (list._Path.Size > 1) {
      list.PathStroke(color, flags, line);
    } else {
      list.PathClear();
    }
  };
  while (read.at < read.end) {
    const char letter = *read.at++;
    if (letter == 'M') end_line(0);
    if (letter == 'M' || letter == 'L') {
      const float px = x(read.number());
      list.PathLineTo({px, y(read.number())});
    } else if (letter == 'Z') {
      end_line(ImDrawFlags_Closed);
    } else if (letter == 'F') {
      list.PathFillConvex(color);
    } else if (letter == 'A' || letter == 'C' || letter == 'D') {
      const float px = x(read.number());
      const float py = y(read.number());
      const float radius = read.number() * unit;
      if (letter == 'C') list.AddCircle({px, py}, radius, color, 0, line);
      if (letter == 'D') list.AddCircleFilled({px, py}, radius, color);
      if (letter == 'A') {
        const float from = read.number() * k_radian;
        list.PathArcTo({px, py}, radius, from, read.number() * k_radian);
      }
    }
  }
  end_line(0);
}

}  // namespace penpose::app
