#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "ui/app/dialogs/entries.h"
#include "ui/app/panels/timeline/timeline_strip.h"
#include "ui/app/playback/frames.h"
#include "ui/app/widgets/button_row.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

// The buttons above the ruler: transport, key, ease, editors, onion, marks; the rest where there is room.

namespace penpose::app {
namespace {

/// The frame of the playhead, to be typed over.
void show_frame_field(PanelContext& context, const TimelineOwners& with, float width) {
  bool accepted = false;
  bool& typed = with.shown().frame_typed;
  if (!typed) with.shown().frame_text = frame_text(with.playback.time_s(), with.playback.rate());
  text_field(context, "##frame", with.shown().frame_text, width, "frame", &accepted);
  tooltip(context, "Type a frame, or seconds such as 1.5s");
  if (accepted) {
    if (const auto moment = typed_moment(with.shown().frame_text, with.playback.rate())) {
      with.playback.go_to(*moment);
    } else {
      with.notices.tell("\"" + with.shown().frame_text + "\" is no frame: type a number of one, or seconds as in 1.5s",
                        true);
    }
  }
  typed = ImGui::IsItemActive();
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

void show_speed(PanelContext& context, const TimelineOwners& with, float width) {
  const double speed = with.playback.speed();
  const char* label = speed == 1 ? "1x##speed" : speed == 0.5 ? "1/2x##speed" : "1/4x##speed";
  const Action next{"play_speed"};
  if (wide_button(context, label, width, speed != 1, context.actions.keys().tooltip_of(next).c_str()))
    context.actions.run(next);
}

/// The clip that is shown, or how many animations of the file wait to be opened; empty: there is one timeline only.
std::string clip_label(const document::Document& document) {
  if (!document.clips.empty()) return fitted_text(document::shown_clip_name(document), 5 * ImGui::GetFontSize());
  const std::size_t animations = document.model->animations.size();
  if (animations == 0) return {};
  return std::to_string(animations) + (animations == 1 ? " animation" : " animations");
}

/// Something else than a button, that wide.
ButtonRow::Button shown_by(const char* label, float width, const TimelineOwners& with,
                           void (*show)(PanelContext&, const TimelineOwners&, float)) {
  ButtonRow::Button button{label};
  button.shows = [&with, show](PanelContext& panel, float wide) { show(panel, with, wide); };
  button.width = width;
  return button;
}

void add_transport(PanelContext& context, const TimelineOwners& with, ButtonRow& row) {
  row.add(Action::previous_key, false, true, false);
  row.add(Action::previous_frame, false, true, false);
  ButtonRow::Button play{with.playback.playing() ? "Stop" : "Play",
                         with.playback.playing() ? icon::k_stop : icon_of(Action::play),
                         context.actions.keys().tooltip_of(Action::play), false};
  play.chosen = with.playback.playing();
  play.weight = ButtonWeight::ordinary;
  play.does = [&context] { context.actions.run(Action::play); };
  row.add(std::move(play));
  row.add(Action::next_frame, false, true, false);
  row.add(Action::next_key, false, true, false);
  row.add(shown_by("##frame", 1.7F * context.unit, with, show_frame_field));
  row.add(shown_by("##rates", 1.9F * context.unit, with, show_rate));
  row.add(shown_by("##speeds", 1.5F * context.unit, with, show_speed));
  if (const std::string clip = clip_label(with.editing.document()); !clip.empty()) {
    ButtonRow::Button clips{clip + "##clips", icon_of(Action{"clips"}),
                            context.actions.keys().tooltip_of(Action{"clips"})};
    clips.does = [&context] { context.actions.run(Action{"clips"}); };
    row.add(std::move(clips));
  }
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

void add_keys(const TimelineOwners& with, ButtonRow& row) {
  row.separate();
  row.add(Action::key_pose, false, true, true,
          has_unkept_pose(with.editing.document()) ? ButtonWeight::primary : ButtonWeight::ordinary);
  row.add(Action::delete_key, false, true, false);
  row.add(Action::auto_key, with.playback.while_drawing().auto_key, true, false);
  row.add(Action::perform, with.playback.while_drawing().performs, true, false);
}

void add_ease(PanelContext& context, const TimelineOwners& with, ButtonRow& row) {
  row.separate();
  ButtonRow::Button ease = shown_by("##kinds", 3.1F * context.unit, with, show_ease);
  ease.least = 1.4F * context.unit;
  ease.most = ease.width;
  row.add(std::move(ease));
  ButtonRow::Button between = shown_by("##between", 5.5F * context.unit, with, show_breakdown);
  between.least = 4.6F * context.unit;
  between.most = 9 * context.unit;
  row.add(std::move(between));
}

void show_onion(PanelContext& context, const TimelineOwners& with, float width) {
  show_onion_button(context, with.look, width);
}

void show_marks_button(PanelContext& context, const TimelineOwners& with, float width) {
  const LoopRange& loop = with.playback.loop();
  ButtonLook look{width, loop.any(), "Bookmarks, and the in and out points of what is played",
                  icon_of(Action{"bookmark"}), false};
  if (icon_button(context, "Marks", look)) ImGui::OpenPopup("marks list");
  show_marks_menu(context, with, "marks list");
}

void add_rest(const TimelineOwners& with, ButtonRow& row) {
  const auto& keys = with.editing.document().timeline->keys;
  const auto here = std::find_if(keys.begin(), keys.end(),
                                 [&](const auto& key) { return std::abs(key.time_s - with.playback.time_s()) < 1e-9; });
  row.separate();
  ButtonRow::Button name{"Name##key", {}, "Name the pose of this key"};
  name.enabled = here != keys.end();
  name.does = [&with, named = name.enabled ? here->name : std::string()] {
    with.dialogs.state<KeyNameEntry>().text = named;
    with.dialogs.show(Dialog::key_name);
  };
  name.spare = true;
  row.add(std::move(name));
  const auto view = [&](const char* label, std::string_view drawn, const char* tip, bool enabled, auto does) {
    ButtonRow::Button button{label, drawn, tip, false};
    button.enabled = enabled;
    button.spare = true;
    button.does = does;
    row.add(std::move(button));
  };
  const bool part = with.shown().span_s > 0;
  view("Zoom out##track", icon::k_minus, "Show more of the timeline", true, [&with] { zoom_track(with, 1.6); });
  view("Zoom in##track", icon::k_plus, "Show less of the timeline, about the playhead", true,
       [&with] { zoom_track(with, 1 / 1.6); });
  view("Back##track", icon::k_left, "Show what comes before", part, [&with] { pan_track(with, -0.5); });
  view("On##track", icon::k_right, "Show what comes after", part, [&with] { pan_track(with, 0.5); });
  view("Copy##key", icon_of(Action::copy_key), "Copy the pose of this moment", true, [&with] { with.keys.copy(); });
  view("Paste##key", icon_of(Action::paste_key), "Key the copied pose at this moment", with.keys.copied(),
       [&with] { with.keys.paste(); });
}

}  // namespace

void show_time_buttons(PanelContext& context, const TimelineOwners& with) {
  // A button may put another timeline in its place.
  const auto held = with.editing.document().timeline;
  ButtonRow row(context, "more of time");
  add_transport(context, with, row);
  add_keys(with, row);
  add_ease(context, with, row);
  row.separate();
  row.add(Action::dope_sheet, with.shown().part == TimelinePart::sheet, true, false);
  row.add(Action::curve_editor, with.shown().part == TimelinePart::curves, true, false);
  row.add(Action{"overlap"}, with.overlap.open(), true, false);
  row.separate();
  row.add(Action::onion_skin, with.look.onion_skin, true, false);
  row.add(shown_by("##onion", 2 * context.unit, with, show_onion));
  row.separate();
  row.add(shown_by("##marks", 1.2F * context.unit, with, show_marks_button));
  add_rest(with, row);
  const float used = row.show(ImGui::GetContentRegionAvail().x);
  const float left = ImGui::GetContentRegionAvail().x - used;
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.2f s   %zu %s", with.playback.time_s(), held->keys.size(),
                held->keys.size() == 1 ? "key" : "keys");
  if (left < ImGui::CalcTextSize(text.data()).x + 3 * context.gap) return;
  ImGui::SameLine();
  text_beside(context, text.data());
}

}  // namespace penpose::app
