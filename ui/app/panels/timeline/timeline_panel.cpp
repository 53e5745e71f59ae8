#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/app/canvas/canvas.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/notices.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/panels/timeline/camera_strip.h"
#include "ui/app/panels/timeline/timeline_strip.h"
#include "ui/app/playback/frames.h"
#include "ui/app/playback/keys.h"
#include "ui/app/playback/performer.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/sound/sound_strip.h"
#include "ui/app/tour/tour_guide.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

/// What the pen does on the row of keys: a touch of a key goes to it, a pull takes it along.
void use_keys(PanelContext& context, const TimelineOwners& with, const Strip& strip) {
  const document::Timeline& timeline = *with.editing.document().timeline;
  const float x = ImGui::GetIO().MousePos.x;
  if (ImGui::IsItemActivated()) {
    with.shown().key_drag.reset();
    float nearest = 0.5F * context.unit;
    for (const auto& key : timeline.keys) {
      if (std::abs(strip.x_of(key.time_s) - x) >= nearest) continue;
      nearest = std::abs(strip.x_of(key.time_s) - x);
      with.shown().key_drag = {key.time_s, key.time_s};
    }
  }
  if (ImGui::IsItemActive()) {
    const double time = on_frame(strip.time_of(x), with.playback.rate());
    if (with.shown().key_drag) {
      auto& [from, to] = *with.shown().key_drag;
      const bool pulled = std::abs(ImGui::GetMouseDragDelta(0, 0).x) > 0.4F * context.unit;
      to = pulled || to != from ? time : from;
      if (to == from) with.playback.scrub(from);
    } else {
      with.playback.scrub(time);
    }
  }
  if (!ImGui::IsItemDeactivated()) return;
  const auto drag = std::exchange(with.shown().key_drag, std::nullopt);
  if (drag && drag->first != drag->second) {
    with.keys.move(drag->first, drag->second);
  } else {
    with.playback.end_scrub();
  }
}

/// A key that has just been set shines; one that Between would set is seen before.
void draw_landing(PanelContext& context, const TimelineOwners& with, const Strip& strip, float middle, float half) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float x = strip.x_of(with.playback.time_s());
  if (with.shown().breakdown) {
    const float wide = 1.2F * half;
    list.AddQuad({x - wide, middle}, {x, middle - wide}, {x + wide, middle}, {x, middle + wide},
                 color_of(palette().key_here), 2);
  }
  const auto shine = static_cast<float>(with.keys.shine(with.playback.time_s()));
  if (shine <= 0) return;
  list.AddCircleFilled({x, middle}, half * (1.5F + 1.5F * (1 - shine)), color_of(palette().key_here, 0.4F * shine));
  list.AddCircle({x, middle}, half * (1.5F + 1.5F * (1 - shine)), color_of(palette().key_here, 0.9F * shine), 0,
                 0.08F * context.unit);
}

void show_keys(PanelContext& context, const TimelineOwners& with) {
  hit_ghost_reach(context, with);
  const Strip strip =
      begin_strip(context, with, "track", "Touch a key to go to it, drag it to move it; Key makes one here");
  use_keys(context, with, strip);
  const auto held = with.editing.document().timeline;
  const auto held_bookmarks = with.editing.document().bookmarks;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(strip.from, strip.to(), true);
  const float middle = strip.from.y + 0.5F * strip.size.y;
  const float half = 0.24F * context.unit;
  if (held_bookmarks) {
    for (const document::Bookmark& one : *held_bookmarks) {
      const float x = strip.x_of(one.time_s);
      list.AddLine({x, strip.from.y}, {x, strip.to().y}, bookmark_color(one.color, 0.5F));
    }
  }
  show_cursor(strip, with);
  draw_ghost_reach(with, strip);
  draw_landing(context, with, strip, middle, half);
  KeyRow row(strip, middle, half);
  for (std::size_t i = 0; i < held->keys.size(); ++i) {
    const auto& key = held->keys[i];
    const auto& drag = with.shown().key_drag;
    const bool dragged = drag && drag->first == key.time_s;
    const float x = strip.x_of(dragged ? drag->second : key.time_s);
    const bool here = std::abs(key.time_s - with.playback.time_s()) < 1e-9;
    // Those of some controls alone are smaller than whole poses.
    row.add(x, key.controls.whole() ? half : 0.7F * half,
            color_of(dragged || here ? palette().key_here : palette().key), here);
    // Its name, as far as there is room up to the next key.
    const float room =
        i + 1 < held->keys.size() ? strip.x_of(held->keys[i + 1].time_s) - x - 2 * half - scaled(4) : 1e6F;
    if (key.name.empty() || room < half) continue;
    list.AddText({x + half + scaled(3), middle - 0.5F * ImGui::GetFontSize()}, ImGui::GetColorU32(ImGuiCol_Text),
                 fitted_text(key.name, room).c_str());
  }
  list.PopClipRect();
}

/// Shows something at the left of the next strip, where rows have their names.
template <typename Show>
void beside_strip(PanelContext& context, const TimelineOwners& with, Show show) {
  const float width = names_width(context, with) - context.gap;
  if (width <= 0) return;
  const ImVec2 corner = ImGui::GetCursorPos();
  show(width);
  ImGui::SetCursorPos(corner);
}

}  // namespace

void show_timeline(PanelContext& context, const Area& area, EditingSession& editing, CanvasLook& look,
                   Playback& playback, Keys& keys, Performer& performer, TourGuide& tour, Notices& notices,
                   Dialogs& dialogs, PanelState& panels, SoundTrack& sound, OverlapOffer& overlap, GhostHand& ghosts,
                   CameraDesk& cameras) {
  const TimelineOwners with{editing, look, playback, keys, performer, tour, notices, dialogs, panels, overlap, ghosts};
  if (begin_panel(context, "timeline", area)) {
    show_time_buttons(context, with);
    // A small window has no room for more.
    if (area.height() > 2 * static_cast<double>(context.unit)) {
      beside_strip(context, with, [&](float width) {
        if (wide_button(context, "All rows", width, with.shown().all_rows,
                        "Show controls that are at rest in every key, too"))
          with.shown().all_rows = !with.shown().all_rows;
      });
      show_ruler(context, with);
      show_keys(context, with);
      beside_strip(context, with, [&](float width) {
        if (cameras.moves()) show_camera_name(context, cameras, width);
      });
      show_camera_strip(context, with, cameras);
      if (sound.sound() != nullptr) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + names_width(context, with));
      const auto words = editing.document().words;
      const SpokenSound said{words.get(), editing.document().spoken.get()};
      show_sound_strip(context, sound, said, playback, shown_moments(with).from, shown_moments(with).span);
      const float left = ImGui::GetContentRegionAvail().y;
      if (left > context.unit && with.shown().part == TimelinePart::sheet) show_dope_sheet(context, with, left);
      if (left > context.unit && with.shown().part == TimelinePart::curves) show_curve_editor(context, with, left);
    }
  }
  end_panel();
}

}  // namespace penpose::app
