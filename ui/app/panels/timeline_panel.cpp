#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "ui/app/canvas/canvas.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/mouths/first_pass.h"
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
#include "ui/app/playback/time_actions.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/sound/sound_strip.h"
#include "ui/app/tools/tool_in_hand.h"
#include "ui/app/tour/tour_guide.h"
#include "ui/app/widgets/button_row.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

/// Frames from one number to the next, so that numbers have room.
int frames_apart(const Strip& strip, int rate, float room) {
  const double px = static_cast<double>(strip.width()) / (strip.shown.span * rate);
  for (const int frames : {1, 2, 5, 10, rate, 2 * rate, 3 * rate, 5 * rate, 10 * rate, 60 * rate, 600 * rate}) {
    if (px * frames >= static_cast<double>(room)) return frames;
  }
  return 3600 * rate;
}

/// The part that is played, where it is not all.
void show_loop(const Strip& strip, const LoopRange& loop, double last_s) {
  if (!loop.any()) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float from = strip.x_of(loop.begin_s());
  const float to = strip.x_of(loop.end_s(last_s));
  list.AddRectFilled({from, strip.from.y}, {to, strip.to().y}, ImGui::GetColorU32(ImGuiCol_ButtonActive, 0.25F));
  list.AddLine({from, strip.from.y}, {from, strip.to().y}, ImGui::GetColorU32(ImGuiCol_ButtonActive), 2);
  list.AddLine({to, strip.from.y}, {to, strip.to().y}, ImGui::GetColorU32(ImGuiCol_ButtonActive), 2);
}

/// Frames by number. Dragged along it, the playhead goes along, and nothing else.
void show_ruler(PanelContext& context, const TimelineOwners& with) {
  const int rate = with.playback.rate();
  const Strip strip = begin_strip(context, with, "ruler", "Drag to go through time");
  if (ImGui::IsItemActive()) with.playback.scrub(on_frame(strip.time_of(ImGui::GetIO().MousePos.x), rate));
  if (ImGui::IsItemDeactivated()) with.playback.end_scrub();
  const auto held = with.editing.document().timeline;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  list.PushClipRect(strip.from, strip.to(), true);
  show_loop(strip, with.playback.loop(), held->keys.empty() ? 0 : held->keys.back().time_s);
  const int apart = frames_apart(strip, rate, 1.3F * context.unit);
  const int marks = frames_apart(strip, rate, 0.2F * context.unit);
  const auto first = static_cast<int>(std::floor(strip.shown.from * rate / apart)) * apart;
  const auto last = static_cast<int>(std::ceil((strip.shown.from + strip.shown.span) * rate));
  for (int frame = first; frame <= last; frame += std::min(marks, apart)) {
    const float x = strip.x_of(time_of_frame(frame, rate));
    const bool numbered = frame % apart == 0;
    list.AddLine({x, strip.from.y + (numbered ? 0.55F : 0.8F) * strip.size.y}, {x, strip.to().y}, faint);
    if (!numbered) continue;
    const std::string number = std::to_string(frame);
    const float wide = ImGui::CalcTextSize(number.c_str()).x;
    const float left = std::min(x - 0.5F * wide, strip.to().x - wide - 1);
    list.AddText({std::max(left, strip.from.x + 1), strip.from.y + 2}, faint, number.c_str());
  }
  // Where a tour asks to go.
  if (const auto asked = with.tour.active() ? with.tour.asked_time() : std::nullopt) {
    const auto at = static_cast<double>(strip.x_of(*asked));
    const double half_wide = 0.5 * static_cast<double>(context.unit);
    context.targets["tour time"] = {at - half_wide, static_cast<double>(strip.from.y), at + half_wide,
                                    static_cast<double>(strip.to().y)};
  }
  // The playhead, with a handle to see it by.
  const float x = strip.x_of(with.playback.time_s());
  const float half = 0.22F * context.unit;
  const ImU32 accent = color_of(with.performer.performing() ? palette().record : palette().accent);
  list.AddTriangleFilled({x - half, strip.from.y}, {x + half, strip.from.y}, {x, strip.from.y + 1.6F * half}, accent);
  list.AddLine({x, strip.from.y}, {x, strip.to().y}, accent, 2);
  list.PopClipRect();
}

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

void show_keys(PanelContext& context, const TimelineOwners& with) {
  const Strip strip =
      begin_strip(context, with, "track", "Touch a key to go to it, drag it to move it; Key makes one here");
  use_keys(context, with, strip);
  const auto held = with.editing.document().timeline;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(strip.from, strip.to(), true);
  const float middle = strip.from.y + 0.5F * strip.size.y;
  const float half = 0.24F * context.unit;
  show_cursor(strip, with);
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
    const float room = i + 1 < held->keys.size() ? strip.x_of(held->keys[i + 1].time_s) - x - 2 * half - 4 : 1e6F;
    if (key.name.empty() || room < half) continue;
    list.AddText({x + half + 3, middle - 0.5F * ImGui::GetFontSize()}, ImGui::GetColorU32(ImGuiCol_Text),
                 fitted_text(key.name, room).c_str());
  }
  list.PopClipRect();
}

/// The frame of the playhead, to be typed over.
void show_frame_field(PanelContext& context, const TimelineOwners& with, float width) {
  bool accepted = false;
  text_field(context, "##frame", with.shown().frame_text, width, "frame", &accepted);
  tooltip(context, "The frame; type one to go there, or seconds as in 1.5s");
  if (accepted) {
    if (const auto moment = typed_moment(with.shown().frame_text, with.playback.rate())) {
      with.playback.go_to(*moment);
    } else {
      with.notices.tell("\"" + with.shown().frame_text + "\" is no frame: type a number of one, or seconds as in 1.5s",
                        true);
    }
  }
  if (!ImGui::IsItemActive()) with.shown().frame_text = frame_text(with.playback.time_s(), with.playback.rate());
}

void show_rate(PanelContext& context, const TimelineOwners& with, float width) {
  const std::string label = std::to_string(with.playback.rate()) + " fps##rate";
  if (wide_button(context, label.c_str(), width, false, "Frames a second")) ImGui::OpenPopup("rates");
  if (!begin_menu(context, "rates")) return;
  for (const int rate : k_frame_rates) {
    const std::string one = std::to_string(rate) + "##choose rate";
    if (!wide_button(context, one.c_str(), 4 * context.unit, rate == with.playback.rate())) continue;
    with.playback.set_rate(rate);
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

/// How controls go on from the keys that are meant.
void show_kinds(PanelContext& context, const TimelineOwners& with, float width) {
  const auto now = with.keys.kind();
  std::string label = "Mixed";
  for (const KeyKindInfo& one : key_kinds()) {
    if (now == one.kind) label = one.name;
  }
  if (!now && with.editing.document().timeline->keys.empty()) label = "Smooth";
  label += "##kind";
  const char* tip = "How the face goes to the next key: from the key here, or before, or from those that are selected";
  if (wide_button(context, label.c_str(), width, false, tip)) ImGui::OpenPopup("kinds");
  if (!begin_menu(context, "kinds")) return;
  for (const KeyKindInfo& one : key_kinds()) {
    const std::string entry = std::string(one.name) + "##choose kind";
    if (!wide_button(context, entry.c_str(), 4 * context.unit, now == one.kind, one.tip)) continue;
    with.keys.set_kind(one.kind);
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

/// A slider from the key before to the key after; a breakdown is keyed where it is let go.
void show_breakdown(PanelContext& context, const TimelineOwners& with, float width) {
  constexpr double k_overshoots = 0.3;
  double& share = with.shown().breakdown;
  bool released = false;
  if (tall_slider(context, "##breakdown", share, -k_overshoots, 1 + k_overshoots, width, "Between", released))
    with.keys.preview_tween(share);
  tooltip(context,
          "A pose between the key before and the key after, keyed here when let go; at the ends it overshoots");
  if (!released) return;
  with.keys.tween(share);
  share = 0.5;
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

/// The clip that is shown, or how many animations of the file wait to be opened; empty: there is one timeline only.
std::string clip_label(const document::Document& document) {
  if (!document.clips.empty()) return fitted_text(document::shown_clip_name(document), 5 * ImGui::GetFontSize());
  const std::size_t animations = document.model->animations.size();
  if (animations == 0) return {};
  return std::to_string(animations) + (animations == 1 ? " animation" : " animations");
}

/// A pose that the timeline does not have, which is lost where one goes on without it.
bool has_unkept_pose(const document::Document& document) {
  if (!document.timeline->keys.empty()) return !(document.pose == document::pose_at(document, document.time_s));
  const auto parameters = document.model->rig->parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (document.pose[i] != parameters[i].rest) return true;
  }
  return false;
}

void show_buttons(PanelContext& context, const TimelineOwners& with) {
  // A button may put another timeline in its place.
  const auto held = with.editing.document().timeline;
  const document::Timeline& timeline = *held;
  const auto here = std::find_if(timeline.keys.begin(), timeline.keys.end(),
                                 [&](const auto& key) { return std::abs(key.time_s - with.playback.time_s()) < 1e-9; });
  const bool on_key = here != timeline.keys.end();
  ButtonRow row(context, "more of time");
  row.add(Action::previous_key, false, true, false);
  row.add(Action::previous_frame, false, true, false);
  ButtonRow::Button play{with.playback.playing() ? "Stop" : "Play",
                         with.playback.playing() ? icon::k_stop : icon_of(Action::play),
                         context.actions.keys().tooltip_of(Action::play)};
  play.chosen = with.playback.playing();
  play.weight = ButtonWeight::ordinary;
  play.keeps_word = true;
  play.does = [&] { context.actions.run(Action::play); };
  row.add(std::move(play));
  row.add(Action::next_frame, false, true, false);
  row.add(Action::next_key, false, true, false);
  ButtonRow::Button frame{"##frame"};
  frame.shows = [&with](PanelContext& panel, float width) { show_frame_field(panel, with, width); };
  frame.width = 2 * context.unit;
  row.add(std::move(frame));
  ButtonRow::Button rate{"##rates"};
  rate.shows = [&with](PanelContext& panel, float width) { show_rate(panel, with, width); };
  rate.width = 2.1F * context.unit;
  row.add(std::move(rate));
  if (const std::string clip = clip_label(with.editing.document()); !clip.empty()) {
    ButtonRow::Button clips{clip + "##clips", icon_of(Action{"clips"}),
                            context.actions.keys().tooltip_of(Action{"clips"})};
    clips.does = [&] { context.actions.run(Action{"clips"}); };
    row.add(std::move(clips));
  }
  row.separate();
  row.add(Action::key_pose, false, true, true,
          has_unkept_pose(with.editing.document()) ? ButtonWeight::primary : ButtonWeight::ordinary);
  row.add(Action::delete_key, false, true, false);
  ButtonRow::Button name{"Name##key", {}, "Give the pose of this key a name"};
  name.enabled = on_key;
  name.does = [&with, named = on_key ? here->name : std::string()] {
    with.dialogs.state<KeyNameEntry>().text = named;
    with.dialogs.show(Dialog::key_name);
  };
  row.add(std::move(name));
  row.add(Action::auto_key, with.playback.while_drawing().auto_key, true, false);
  row.add(Action::perform, with.playback.while_drawing().performs, true, false);
  row.separate();
  ButtonRow::Button kind{"##kinds"};
  kind.shows = [&with](PanelContext& panel, float width) { show_kinds(panel, with, width); };
  kind.width = 2.4F * context.unit;
  row.add(std::move(kind));
  row.add(Action::dope_sheet, with.shown().part == TimelinePart::sheet, true, false);
  row.add(Action::curve_editor, with.shown().part == TimelinePart::curves, true, false);
  row.add(Action{"overlap"}, with.overlap.open(), true, false);
  row.add(Action::onion_skin, with.look.onion_skin);
  ButtonRow::Button onion{"##onion"};
  onion.shows = [&with](PanelContext& panel, float width) { show_onion_button(panel, with.look, width); };
  onion.width = 2 * context.unit;
  row.add(std::move(onion));
  row.separate();
  const auto view = [&](const char* label, std::string_view drawn, const char* tip, bool enabled, auto does) {
    ButtonRow::Button button{label, drawn, tip, false};
    button.enabled = enabled;
    button.does = does;
    row.add(std::move(button));
  };
  const bool part = with.shown().span_s > 0;
  view("Zoom out##track", icon::k_minus, "Show more of the timeline", true, [&with] { zoom_track(with, 1.6); });
  view("Zoom in##track", icon::k_plus, "Show less of the timeline, about the playhead", true,
       [&with] { zoom_track(with, 1 / 1.6); });
  view("Back##track", icon::k_left, "Show what comes before", part, [&with] { pan_track(with, -0.5); });
  view("On##track", icon::k_right, "Show what comes after", part, [&with] { pan_track(with, 0.5); });
  row.separate();
  row.add(Action::copy_key, false, true, false);
  row.add(Action::paste_key, false, true, false);
  row.add(Action::loop_from, with.playback.loop().from_s.has_value(), true, false);
  row.add(Action::loop_to, with.playback.loop().to_s.has_value(), true, false);
  if (with.playback.loop().any()) row.add(Action::loop_off, false, true, false);
  const float used = row.show(ImGui::GetContentRegionAvail().x);
  const float left = ImGui::GetContentRegionAvail().x - used;
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.2f s   %zu keys", with.playback.time_s(), timeline.keys.size());
  if (left < ImGui::CalcTextSize(text.data()).x + 3 * context.gap) return;
  ImGui::SameLine();
  text_beside(context, text.data());
}

}  // namespace

void show_timeline(PanelContext& context, const Area& area, EditingSession& editing, CanvasLook& look,
                   Playback& playback, Keys& keys, Performer& performer, TourGuide& tour, Notices& notices,
                   Dialogs& dialogs, PanelState& panels, SoundTrack& sound, FirstPass& pass, OverlapOffer& overlap,
                   GhostHand& ghosts, ToolInHand& tool, CameraDesk& cameras) {
  const TimelineOwners with{editing, look, playback, keys, performer, tour, notices, dialogs, panels, overlap, ghosts};
  if (begin_panel(context, "timeline", area)) {
    show_buttons(context, with);
    // A small window has no room for more.
    if (area.height() > 2 * static_cast<double>(context.unit)) {
      beside_strip(context, with, [&](float width) {
        if (wide_button(context, "All rows", width, with.shown().all_rows, "Also controls that rest in every key"))
          with.shown().all_rows = !with.shown().all_rows;
      });
      show_ruler(context, with);
      if (tool.now().shows_ghosts) show_ghost_reach(context, with);
      beside_strip(context, with, [&](float width) { show_breakdown(context, with, width); });
      show_keys(context, with);
      beside_strip(context, with, [&](float width) {
        if (cameras.moves()) show_camera_name(context, cameras, width);
      });
      show_camera_strip(context, with, cameras);
      if (sound.sound() != nullptr) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + names_width(context, with));
      const SpokenSound said{pass.words(), editing.document().spoken.get()};
      show_sound_strip(context, sound, said, playback, shown_moments(with).from, shown_moments(with).span);
      const float left = ImGui::GetContentRegionAvail().y;
      if (left > context.unit && with.shown().part == TimelinePart::sheet) show_dope_sheet(context, with, left);
      if (left > context.unit && with.shown().part == TimelinePart::curves) show_curve_editor(context, with, left);
    }
  }
  end_panel();
}

}  // namespace penpose::app
