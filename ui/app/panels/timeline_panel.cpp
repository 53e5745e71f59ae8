#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "ui/app/canvas/canvas.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/notices.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/playback/frames.h"
#include "ui/app/playback/keys.h"
#include "ui/app/playback/performer.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/sound/sound_strip.h"
#include "ui/app/tour/tour_guide.h"
#include "ui/app/widgets/button_row.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct Owners {
  EditingSession& editing;
  CanvasLook& look;
  Playback& playback;
  Keys& keys;
  Performer& performer;
  TourGuide& tour;
  Notices& notices;
  Dialogs& dialogs;
  PanelState& panels;
  SoundTrack& sound;
};

constexpr double k_least_range_s = 4;
constexpr double k_least_span_s = 0.5;

/// The moments that the track shows.
struct Shown {
  double from = 0;
  double span = 0;
};

Shown shown_moments(const Owners& with) {
  const double last = with.playback.last_s();
  const double all = std::max({k_least_range_s, std::ceil(last + 1), std::ceil(with.playback.time_s())});
  if (with.panels.own.of<TimelineShown>().span_s <= 0 || with.panels.own.of<TimelineShown>().span_s >= all) {
    with.panels.own.of<TimelineShown>().span_s = with.panels.own.of<TimelineShown>().from_s = 0;
    return {0, all};
  }
  // The cursor is in sight wherever it goes.
  if (std::exchange(with.panels.own.of<TimelineShown>().seen_time_s, with.playback.time_s()) !=
      with.playback.time_s()) {
    if (with.playback.time_s() < with.panels.own.of<TimelineShown>().from_s)
      with.panels.own.of<TimelineShown>().from_s = with.playback.time_s();
    if (with.playback.time_s() >
        with.panels.own.of<TimelineShown>().from_s + with.panels.own.of<TimelineShown>().span_s)
      with.panels.own.of<TimelineShown>().from_s = with.playback.time_s() - with.panels.own.of<TimelineShown>().span_s;
  }
  with.panels.own.of<TimelineShown>().from_s =
      std::clamp(with.panels.own.of<TimelineShown>().from_s, 0.0, all - with.panels.own.of<TimelineShown>().span_s);
  return {with.panels.own.of<TimelineShown>().from_s, with.panels.own.of<TimelineShown>().span_s};
}

/// Shows more or less of the timeline, about its cursor.
void zoom_track(const Owners& with, double factor) {
  const Shown now = shown_moments(with);
  const double span = std::max(k_least_span_s, now.span * factor);
  const double share = std::clamp((with.playback.time_s() - now.from) / now.span, 0.0, 1.0);
  with.panels.own.of<TimelineShown>().span_s = span;
  with.panels.own.of<TimelineShown>().from_s = std::max(0.0, with.playback.time_s() - share * span);
}

/// Shows another part of the timeline, by a share of what is shown.
void pan_track(const Owners& with, double share) {
  const Shown now = shown_moments(with);
  with.panels.own.of<TimelineShown>().from_s = std::max(0.0, now.from + share * now.span);
}

/// Where moments lie on a strip of the panel.
struct Strip {
  ImVec2 from;
  ImVec2 size;
  float inset = 0;
  Shown shown;
  [[nodiscard]] float width() const { return size.x - 2 * inset; }
  [[nodiscard]] ImVec2 to() const { return {from.x + size.x, from.y + size.y}; }
  [[nodiscard]] float x_of(double time_s) const {
    return from.x + inset + static_cast<float>((time_s - shown.from) / shown.span) * width();
  }
  [[nodiscard]] double time_of(float x) const {
    const double share = static_cast<double>((x - from.x - inset) / width());
    return std::max(0.0, shown.from + std::clamp(share, -0.02, 1.02) * shown.span);
  }
};

/// A strip as wide as the panel, which is hit under a name.
Strip begin_strip(PanelContext& context, const Owners& with, const char* name, const char* tip) {
  Strip strip;
  strip.shown = shown_moments(with);
  strip.from = ImGui::GetCursorScreenPos();
  strip.size = {std::max(context.unit, ImGui::GetContentRegionAvail().x), context.unit};
  strip.inset = 0.3F * context.unit;
  ImGui::InvisibleButton(name, strip.size);
  note(context, name);
  tooltip(context, tip);
  if (ImGui::IsItemHovered() && ImGui::GetIO().MouseWheel != 0) {
    zoom_track(with, std::pow(0.8, static_cast<double>(ImGui::GetIO().MouseWheel)));
  }
  ImGui::GetWindowDrawList()->AddRectFilled(strip.from, strip.to(), ImGui::GetColorU32(ImGuiCol_FrameBg), 4);
  return strip;
}

/// Frames from one number to the next, so that numbers have room.
int frames_apart(const Strip& strip, int rate, float room) {
  const double px = static_cast<double>(strip.width()) / (strip.shown.span * rate);
  for (const int frames : {1, 2, 5, 10, rate, 2 * rate, 5 * rate, 10 * rate, 60 * rate, 600 * rate}) {
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
void show_ruler(PanelContext& context, const Owners& with) {
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
    list.AddText({x + 3, strip.from.y + 2}, faint, number.c_str());
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
  const ImU32 accent =
      with.performer.performing() ? IM_COL32(232, 64, 52, 255) : ImGui::GetColorU32(ImGuiCol_ButtonActive);
  list.AddTriangleFilled({x - half, strip.from.y}, {x + half, strip.from.y}, {x, strip.from.y + 1.6F * half}, accent);
  list.AddLine({x, strip.from.y}, {x, strip.to().y}, accent, 2);
  list.PopClipRect();
}

/// What the pen does on the row of keys: a touch of a key goes to it, a pull takes it along.
void use_keys(PanelContext& context, const Owners& with, const Strip& strip) {
  const document::Timeline& timeline = *with.editing.document().timeline;
  const float x = ImGui::GetIO().MousePos.x;
  if (ImGui::IsItemActivated()) {
    with.panels.own.of<TimelineShown>().key_drag.reset();
    float nearest = 0.5F * context.unit;
    for (const auto& key : timeline.keys) {
      if (std::abs(strip.x_of(key.time_s) - x) >= nearest) continue;
      nearest = std::abs(strip.x_of(key.time_s) - x);
      with.panels.own.of<TimelineShown>().key_drag = {key.time_s, key.time_s};
    }
  }
  if (ImGui::IsItemActive()) {
    const double time = on_frame(strip.time_of(x), with.playback.rate());
    if (with.panels.own.of<TimelineShown>().key_drag) {
      auto& [from, to] = *with.panels.own.of<TimelineShown>().key_drag;
      const bool pulled = std::abs(ImGui::GetMouseDragDelta(0, 0).x) > 0.4F * context.unit;
      to = pulled || to != from ? time : from;
      if (to == from) with.playback.scrub(from);
    } else {
      with.playback.scrub(time);
    }
  }
  if (!ImGui::IsItemDeactivated()) return;
  const auto drag = std::exchange(with.panels.own.of<TimelineShown>().key_drag, std::nullopt);
  if (drag && drag->first != drag->second) {
    with.keys.move(drag->first, drag->second);
  } else {
    with.playback.end_scrub();
  }
}

void show_keys(PanelContext& context, const Owners& with) {
  const Strip strip =
      begin_strip(context, with, "track", "Touch a key to go to it, drag it to move it; Key makes one here");
  use_keys(context, with, strip);
  const auto held = with.editing.document().timeline;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(strip.from, strip.to(), true);
  const float middle = strip.from.y + 0.5F * strip.size.y;
  const float half = 0.24F * context.unit;
  const float cursor = strip.x_of(with.playback.time_s());
  list.AddLine({cursor, strip.from.y}, {cursor, strip.to().y}, ImGui::GetColorU32(ImGuiCol_ButtonActive), 2);
  for (std::size_t i = 0; i < held->keys.size(); ++i) {
    const auto& key = held->keys[i];
    const auto& drag = with.panels.own.of<TimelineShown>().key_drag;
    const bool dragged = drag && drag->first == key.time_s;
    const float x = strip.x_of(dragged ? drag->second : key.time_s);
    const bool here = std::abs(key.time_s - with.playback.time_s()) < 1e-9;
    list.AddQuadFilled({x - half, middle}, {x, middle - half}, {x + half, middle}, {x, middle + half},
                       dragged || here ? IM_COL32(255, 214, 92, 255) : IM_COL32(255, 168, 0, 255));
    list.AddQuad({x - half, middle}, {x, middle - half}, {x + half, middle}, {x, middle + half},
                 IM_COL32(60, 40, 0, 255), here ? 2.5F : 1);
    // Its name, as far as there is room up to the next key.
    const float room = i + 1 < held->keys.size() ? strip.x_of(held->keys[i + 1].time_s) - x - 2 * half - 4 : 1e6F;
    if (key.name.empty() || room < half) continue;
    list.AddText({x + half + 3, middle - 0.5F * ImGui::GetFontSize()}, ImGui::GetColorU32(ImGuiCol_Text),
                 fitted_text(key.name, room).c_str());
  }
  list.PopClipRect();
}

/// The frame of the playhead, to be typed over.
void show_frame_field(PanelContext& context, const Owners& with, float width) {
  bool accepted = false;
  text_field(context, "##frame", with.panels.own.of<TimelineShown>().frame_text, width, "frame", &accepted);
  tooltip(context, "The frame; type one to go there, or seconds as in 1.5s");
  if (accepted) {
    if (const auto moment = typed_moment(with.panels.own.of<TimelineShown>().frame_text, with.playback.rate())) {
      with.playback.go_to(*moment);
    } else {
      with.notices.tell("\"" + with.panels.own.of<TimelineShown>().frame_text +
                            "\" is no frame: type a number of one, or seconds as in 1.5s",
                        true);
    }
  }
  if (!ImGui::IsItemActive())
    with.panels.own.of<TimelineShown>().frame_text = frame_text(with.playback.time_s(), with.playback.rate());
}

void show_rate(PanelContext& context, const Owners& with, float width) {
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

void show_buttons(PanelContext& context, const Owners& with) {
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
                         with.playback.playing() ? icon::k_stop : icon_of(Action::play), tooltip_of(Action::play)};
  play.chosen = with.playback.playing();
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
  row.add(Action::key_pose);
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
  row.add(Action::copy_key, false, true, false);
  row.add(Action::paste_key, false, true, false);
  row.add(Action::loop_from, with.playback.loop().from_s.has_value(), true, false);
  row.add(Action::loop_to, with.playback.loop().to_s.has_value(), true, false);
  if (with.playback.loop().any()) row.add(Action::loop_off, false, true, false);
  const bool smooth = timeline.interpolation == document::KeyInterpolation::smooth;
  ButtonRow::Button between{smooth ? "Smooth" : "Linear", {}, "How poses between keys are made"};
  between.does = [&with, smooth] {
    with.editing.perform(document::SetKeyInterpolation{smooth ? document::KeyInterpolation::linear
                                                              : document::KeyInterpolation::smooth});
  };
  row.add(std::move(between));
  row.add(Action::onion_skin, with.look.onion_skin);
  const auto view = [&](const char* label, std::string_view drawn, const char* tip, bool enabled, auto does) {
    ButtonRow::Button button{label, drawn, tip, false};
    button.enabled = enabled;
    button.does = does;
    row.add(std::move(button));
  };
  const bool part = with.panels.own.of<TimelineShown>().span_s > 0;
  view("-##track", icon::k_minus, "Show more of the timeline", true, [&with] { zoom_track(with, 1.6); });
  view("+##track", icon::k_plus, "Show less of the timeline, about the playhead", true,
       [&with] { zoom_track(with, 1 / 1.6); });
  view("<##track", icon::k_left, "Show what comes before", part, [&with] { pan_track(with, -0.5); });
  view(">##track", icon::k_right, "Show what comes after", part, [&with] { pan_track(with, 0.5); });
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
                   Dialogs& dialogs, PanelState& panels, SoundTrack& sound) {
  const Owners with{editing, look, playback, keys, performer, tour, notices, dialogs, panels, sound};
  if (begin_panel(context, "timeline", area)) {
    show_buttons(context, with);
    // A small window has no room for more.
    if (area.height() > 2 * static_cast<double>(context.unit)) {
      show_ruler(context, with);
      show_keys(context, with);
      show_sound_strip(context, sound, playback, shown_moments(with).from, shown_moments(with).span);
    }
  }
  end_panel();
}

}  // namespace penpose::app
