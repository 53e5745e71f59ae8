#include "ui/app/widgets/internal/icon.h"

#include <array>
#include <cstdlib>
#include <utility>

// The language: a letter and its numbers, in a square of 24 by 24, y down. M x y begins a line and ends the one before;
// L x y goes on; A x y r from to is an arc about x y, in degrees clockwise from the right; Z closes the line, F fills
// it; C x y r is a circle, D x y r a disc.

namespace penpose::app {
namespace {

constexpr float k_square = 24;
constexpr float k_line = 1.9F;
constexpr float k_radian = 3.14159265F / 180;

constexpr std::array<std::pair<Action, std::string_view>, 72> k_icons{{
    {Action::tool_select, "M6 3L6 18L10 14.5L13 21L15.5 20L12.5 13.5L18 13Z"},
    {Action::tool_pose, "M3 16L8 11L12 15L21 7M16 6L21 7L20 12"},
    {Action::tool_oversketch, "M3 18L9 13L13 16M14 13L20 4L22 6L16 14L13 15Z"},
    {Action::tool_constraint, "M6 11L18 11L18 20L6 20Z A12 11 4 180 360"},
    {Action::tool_pin, "C12 8 4M12 12L12 21"},
    {Action::tool_erase, "M4 15L13 5L20 11L12 20L8 20Z M9 10L16 16M12 20L20 20"},
    {Action::tool_articulate, "C6 18 2.5C18 6 2.5M8 16L16 8M4 6L10 6M7 3L7 9"},
    {Action::undo, "M9 5L4 10L9 15M4 10L14 10A14 14.5 4.5 -90 90M14 19L10 19"},
    {Action::redo, "M15 5L20 10L15 15M20 10L10 10A10 14.5 4.5 270 90M10 19L14 19"},
    {Action::clear_curves, "M5 7L19 7M9 7L9 4L15 4L15 7M7 7L8 20L16 20L17 7"},
    {Action::delete_curve, "M4 16L9 11L13 14L16 11M16 16L21 21M21 16L16 21"},
    {Action::keep_curve, "M4 13L9 18L20 6"},
    {Action::reset_pose, "C12 12 8M8 10L8 10.5M16 10L16 10.5M8 15.5L16 15.5"},
    {Action::suggest_rest, "M12 3L14 10L21 12L14 14L12 21L10 14L3 12L10 10Z"},
    {Action::cancel, "M6 6L18 18M18 6L6 18"},
    {Action::view_front, "C12 11 7M12 8L12 12M9 15L15 15"},
    {Action::view_side, "M8 4L14 4L17 9L19 13L16.5 13.5L16 18L12 19L12 21M8 4L6 9L8 15L8 21"},
    {Action::view_three_quarter, "C12 11 7M14 8L15 12M11 15L16 14"},
    {Action::frame_all, "M4 9L4 4L9 4M15 4L20 4L20 9M20 15L20 20L15 20M9 20L4 20L4 15"},
    {Action::orbit_left, "A12 12 8 100 330M4 12L4 18L10 18"},
    {Action::orbit_right, "A12 12 8 -150 80M20 12L20 18L14 18"},
    {Action::orbit_up, "M12 20L12 5M6 11L12 5L18 11"},
    {Action::orbit_down, "M12 4L12 19M6 13L12 19L18 13"},
    {Action::zoom_in, "C10 10 6M15 15L21 21M10 7L10 13M7 10L13 10"},
    {Action::zoom_out, "C10 10 6M15 15L21 21M7 10L13 10"},
    {Action::wireframe, "M4 18L12 4L20 18Z M8 11L16 11L12 18Z"},
    {Action::key_pose, "M12 4L20 12L12 20L4 12F"},
    {Action::delete_key, "M10 4L18 12L10 20L2 12Z M17 4L22 9M22 4L17 9"},
    {Action::previous_key, "M5 5L5 19M18 5L9 12L18 19Z"},
    {Action::next_key, "M19 5L19 19M6 5L15 12L6 19Z"},
    {Action::play, "M7 4L20 12L7 20F"},
    {Action::onion_skin, "C9 12 6C15 12 6"},
    {Action::open, "M3 19L3 5L9 5L11 8L20 8L20 11M3 19L7 11L22 11L19 19Z"},
    {Action::recent, "C12 12 8M12 7L12 12L16 14"},
    {Action::save, "M4 4L17 4L20 7L20 20L4 20Z M8 4L8 9L15 9L15 4M7 20L7 14L17 14L17 20"},
    {Action::save_as, "M4 4L17 4L20 7L20 12M4 4L4 20L11 20M8 4L8 9L15 9L15 4M14 20L19 15L21 17L16 22L14 22Z"},
    {Action::export_as, "M12 15L12 4M7 9L12 4L17 9M4 14L4 20L20 20L20 14"},
    {Action::panels, "M3 5L21 5L21 19L3 19Z M15 5L15 19"},
    {Action::fullscreen, "M4 9L4 4L9 4M15 4L20 4L20 9M20 15L20 20L15 20M9 20L4 20L4 15M4 4L9 9M20 20L15 15"},
    {Action::theme, "C12 12 4M12 3L12 5M12 19L12 21M3 12L5 12M19 12L21 12M6 6L7 7M17 17L18 18M18 6L17 7M6 18L7 17"},
    {Action::larger, "M3 19L9 5L15 19M5 14L13 14M17 8L23 8M20 5L20 11"},
    {Action::smaller, "M3 19L9 5L15 19M5 14L13 14M17 8L23 8"},
    {Action::help, "C12 12 9A12 10 3 180 400M13.5 13L12 14.5M12 17.5L12 18"},
    {Action::quit, "M14 4L4 4L4 20L14 20M9 12L21 12M16 7L21 12L16 17"},
    {Action::shortcuts, "M3 6L21 6L21 18L3 18Z M7 10L7 10.5M11 10L11 10.5M15 10L15 10.5M8 14.5L16 14.5"},
    {Action::search, "C10 10 6M15 15L21 21"},
    {Action::history, "A12 12 8 -160 130M4 4L4 9L9 9M12 8L12 12L15 14"},
    {Action::previous_frame, "M15 5L7 12L15 19Z"},
    {Action::next_frame, "M9 5L17 12L9 19Z"},
    {Action::copy_key, "M8 8L20 8L20 20L8 20Z M16 8L16 4L4 4L4 16L8 16"},
    {Action::paste_key, "M7 5L4 5L4 21L16 21L16 18M8 3L20 3L20 17L8 17Z M11 10L17 10M14 7L14 13"},
    {Action::loop_from, "M8 4L4 4L4 20L8 20M20 12L10 12M14 8L10 12L14 16"},
    {Action::loop_to, "M16 4L20 4L20 20L16 20M4 12L14 12M10 8L14 12L10 16"},
    {Action::loop_off, "A12 12 7 -150 150M6 4L6 9L11 9M16 16L22 22M22 16L16 22"},
    {Action::perform, "C12 12 9D12 12 5"},
    {Action::auto_key, "M9 5L16 12L9 19L2 12F D20 5 3"},
    {Action::mirror_strokes, "M12 3L12 21M9 7L3 17L9 17Z M15 7L21 17L15 17Z"},
    {Action::flip_pose, "M12 3L12 21M4 9L9 9M6 6L3.5 9L6 12M20 15L15 15M18 12L20.5 15L18 18"},
    {Action::copy_to_right, "M12 3L12 21M3 12L9 12M15 7L21 12L15 17F"},
    {Action::copy_to_left, "M12 3L12 21M15 12L21 12M9 7L3 12L9 17F"},
    {Action::stabiliser, "M3 16A7.5 16 4.5 180 360M12 16A16.5 16 4.5 180 0"},
    {Action::moved_only, "M4 7L20 7M4 12L14 12M4 17L9 17"},
    {Action::density, "M4 5L20 5M4 9.5L20 9.5M4 14L20 14M4 18.5L20 18.5"},
    {Action::film, "M3 5L21 5L21 19L3 19Z M7 5L7 19M17 5L17 19M3 12L7 12M17 12L21 12"},
    {Action::tour_pose, "M7 4L20 12L7 20Z"},
    {Action::tour_rig, "M7 4L20 12L7 20Z"},
    {Action::tour_animate, "M7 4L20 12L7 20Z"},
    {Action::flat_view, "M5 8L14 8L14 17L5 17Z M5 8L9 4L18 4L14 8M18 4L18 13L14 17"},
    {Action::set_front, "C12 9 5M4 20A12 20 8 180 360"},
    {Action::backdrop, "M3 5L21 5L21 19L3 19Z M4 17L9 11L13 15L16 12L20 16"},
    {Action::backdrop_off, "M3 5L21 5L21 19L3 19Z M8 8L16 16M16 8L8 16"},
    {Action::library,
     "M4 4L11 4L11 11L4 11Z M13 4L20 4L20 11L13 11Z M4 13L11 13L11 20L4 20Z M13 13L20 13L20 20L13 20Z"},
}};

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

std::string_view icon_of(Action action) {
  for (const auto& [of, icon] : k_icons) {
    if (of == action && !icon.empty()) return icon;
  }
  return {};
}

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
