#include "ui/app/panels/timeline/camera_strip.h"

#include <cmath>
#include <optional>
#include <utility>

#include "ui/app/playback/frames.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

/// A key of the camera in hand.
struct CameraKeyDrag {
  std::optional<std::pair<double, double>> key;  ///< from, to
};

/// Under which the button is found that looks through the camera.
constexpr const char* k_through = "Camera##look through";
constexpr float k_camera_key_units = 0.2F;

/// What the pen does on the row.
void use_camera_keys(PanelContext& context, const TimelineOwners& with, const Strip& strip, CameraKeyDrag& drag) {
  const float x = ImGui::GetIO().MousePos.x;
  if (ImGui::IsItemActivated()) {
    drag.key.reset();
    float nearest = 0.5F * context.unit;
    for (const auto& key : with.editing.document().camera->keys) {
      if (std::abs(strip.x_of(key.time_s) - x) >= nearest) continue;
      nearest = std::abs(strip.x_of(key.time_s) - x);
      drag.key = {key.time_s, key.time_s};
    }
  }
  if (ImGui::IsItemActive()) {
    const double time = on_frame(strip.time_of(x), with.playback.rate());
    if (drag.key) {
      auto& [from, to] = *drag.key;
      if (to != from || std::abs(ImGui::GetMouseDragDelta(0, 0).x) > 0.4F * context.unit) to = time;
      if (to == from) with.playback.scrub(from);
    } else {
      with.playback.scrub(time);
    }
  }
  if (!ImGui::IsItemDeactivated()) return;
  const auto moved = std::exchange(drag.key, std::nullopt);
  if (moved && moved->first != moved->second) {
    with.editing.perform(document::MoveCameraKey{moved->first, moved->second});
  } else {
    with.playback.end_scrub();
  }
}

}  // namespace

double camera_strip_height(const PanelContext& context, const CameraDesk& cameras) {
  return cameras.moves() ? static_cast<double>(context.unit + context.gap) : 0;
}

void show_camera_name(PanelContext& context, CameraDesk& cameras, float width) {
  if (wide_button(context, k_through, width, cameras.looks_through(), "Look through the camera, or freely"))
    cameras.look_through(!cameras.looks_through());
}

void show_camera_strip(PanelContext& context, const TimelineOwners& with, CameraDesk& cameras) {
  const auto track = with.editing.document().camera;
  if (!track) return;
  CameraKeyDrag& drag = with.panels.own.of<CameraKeyDrag>();
  const float row_width = ImGui::GetContentRegionAvail().x;
  const ImVec2 corner = ImGui::GetCursorPos();
  const float wide = names_width(context, with) > 0 ? 0 : ImGui::CalcTextSize("Camera").x + 2 * context.gap;
  if (wide > 0) {
    // The button comes first, so that it and not the strip below it is hit.
    ImGui::SetCursorPosX(corner.x + row_width - wide);
    const bool through = cameras.looks_through();
    if (ImGui::InvisibleButton(k_through, {wide, context.unit})) cameras.look_through(!through);
    note(context, k_through);
    tooltip(context, "Look through the camera, or freely");
    ImGui::SetCursorPos(corner);
  }
  const Strip strip = begin_strip(context, with, "camera track",
                                  "Keys of the camera: touch one to go to it, drag it to move it; a square is a cut");
  use_camera_keys(context, with, strip, drag);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(strip.from, strip.to(), true);
  show_cursor(strip, with);
  const float middle = strip.from.y + 0.5F * strip.size.y;
  const float half = k_camera_key_units * context.unit;
  KeyRow row(strip, middle, half);
  for (const document::CameraKey& key : track->keys) {
    const bool dragged = drag.key && drag.key->first == key.time_s;
    const float x = strip.x_of(dragged ? drag.key->second : key.time_s);
    const bool here = dragged || std::abs(key.time_s - with.playback.time_s()) < 1e-6;
    const ImU32 color = color_of(here ? palette().key_camera_here : palette().key_camera);
    if (key.kind == document::KeyKind::stepped) {
      list.AddRectFilled({x - half, middle - half}, {x + half, middle + half}, color, scaled(2));
    } else {
      row.add(x, half, color, here);
    }
  }
  list.PopClipRect();
  if (wide == 0) return;
  // Drawn over the strip, whose end it is.
  const ImVec2 from{strip.to().x - wide, strip.from.y};
  list.AddRectFilled(from, strip.to(),
                     ImGui::GetColorU32(cameras.looks_through() ? ImGuiCol_ButtonActive : ImGuiCol_Button),
                     ImGui::GetStyle().FrameRounding);
  list.AddText({from.x + context.gap, middle - 0.5F * ImGui::GetTextLineHeight()}, ImGui::GetColorU32(ImGuiCol_Text),
               "Camera");
}

}  // namespace penpose::app
