#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string>
#include <variant>

#include "core/document/time/animation_sampling.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/panels/panels.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/widgets.h"

// Clips of the document and animations of the file that are not opened yet.

namespace penpose::app {
namespace {

/// The name that is being typed, and the clip that it is of.
struct ClipNameEntry {
  std::string text;
  std::string of;
};

struct ClipsDialogOwners {
  EditingSession& editing;
  Playback& playback;
};

std::string seconds(double time_s) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f s", time_s);
  return text.data();
}

std::string detail_of(const document::Timeline& keys) {
  if (keys.keys.empty()) return "no keys";
  return std::to_string(keys.keys.size()) + " keys, " + seconds(keys.keys.back().time_s);
}

bool row(PanelContext& context, const std::string& label, const std::string& detail, bool chosen, const char* tip) {
  ButtonLook look{ImGui::GetContentRegionAvail().x, chosen, tip};
  look.left_aligned = true;
  look.key = detail;
  return icon_button(context, label.c_str(), look);
}

/// Does it, and shows the clip that is shown then from its beginning.
void perform(const ClipsDialogOwners& with, const document::Command& command) {
  if (!with.editing.perform(command) || command.holds<document::NameClip>()) return;
  with.playback.loop() = {};
  with.playback.go_to(0);
}

/// A name that nothing has: with a number behind it.
std::string fresh_name(const document::Document& document, const std::string& name) {
  const auto taken = [&](const std::string& one) {
    const auto& animations = document.model->animations;
    return one == document::shown_clip_name(document) ||
           std::any_of(document.clips.begin(), document.clips.end(), [&](const auto& c) { return c->name == one; }) ||
           std::any_of(animations.begin(), animations.end(), [&](const auto& a) { return a.name == one; });
  };
  if (!taken(name)) return name;
  int number = 2;
  while (taken(name + " " + std::to_string(number))) ++number;
  return name + " " + std::to_string(number);
}

/// All clips, and the animations of the file; a touch shows one.
void show_list(PanelContext& context, const document::Document& document, float height,
               std::optional<document::Command>& does) {
  begin_list(context, "clips", {0, height}, true);
  if (document.clips.empty())
    row(context, std::string(document::k_timeline_name) + "##clip", detail_of(*document.timeline), true, "Is shown");
  for (std::size_t i = 0; i < document.clips.size(); ++i) {
    const std::string label = document::clip_name(*document.clips[i]) + "##clip" + std::to_string(i);
    if (row(context, label, detail_of(document::keys_of_clip(document, i)), i == document.clip, "Show this clip"))
      does = document::ShowClip{static_cast<std::uint32_t>(i)};
  }
  for (std::size_t i = 0; i < document.model->animations.size(); ++i) {
    const bool open = std::any_of(document.clips.begin(), document.clips.end(),
                                  [&](const auto& clip) { return clip->animation == i; });
    if (open) continue;
    const document::Animation& animation = document.model->animations[i];
    const std::string name = document::clip_name({animation.name, i});
    const std::string label = name + "##animation" + std::to_string(i);
    if (row(context, label, "of the file, " + seconds(document::duration_s(animation)), false,
            "Open its keys for editing; untouched parts are saved unchanged"))
      does = document::OpenClip{static_cast<std::uint32_t>(i)};
  }
  ImGui::EndChild();
}

/// What is done with the clip that is shown.
void show_changes(PanelContext& context, const document::Document& document, const Playback& playback,
                  std::string& name, std::optional<document::Command>& does) {
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  const float third = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  const std::string shown = document::shown_clip_name(document);
  const auto button = [&](const char* label, float width, bool enabled, const char* tip) {
    ImGui::BeginDisabled(!enabled);
    const bool pressed = wide_button(context, label, width, false, tip);
    ImGui::EndDisabled();
    return pressed && enabled;
  };
  text_field(context, "##clip name", name, 2 * third + gap, "its name");
  ImGui::SameLine();
  const bool named = !name.empty() && name != shown;
  if (button("Rename##clip", third, named, "Rename the shown clip") || (named && context.accepts))
    does = document::NameClip{{name}};
  if (button("New##clip", third, true, "An empty clip")) does = document::AddClip{fresh_name(document, "clip"), false};
  ImGui::SameLine();
  if (button("Double##clip", third, true, "Duplicate the shown clip"))
    does = document::AddClip{fresh_name(document, shown), true};
  ImGui::SameLine();
  if (button("Delete##clip", third, document.clips.size() > 1, "Delete the shown clip, also from the file when saved"))
    does = document::DeleteClip{};
  const LoopRange& loop = playback.loop();
  if (button("Trim to loop##clip", 2 * third + gap, loop.any() && !document.timeline->keys.empty(),
             "Cut the shown clip to the part between the in and the out point"))
    does = document::TrimClip{loop.begin_s(), loop.end_s(playback.last_s())};
  ImGui::SameLine();
}

}  // namespace

void show_clips_dialog(PanelContext& context, EditingSession& editing, Playback& playback, Dialogs& dialogs) {
  if (begin_dialog(context, "Clips", 15)) {
    std::optional<document::Command> does;
    const document::Document& document = editing.document();
    ClipNameEntry& entry = dialogs.state<ClipNameEntry>();
    if (entry.of != document::shown_clip_name(document))
      entry = {document::shown_clip_name(document), document::shown_clip_name(document)};
    const float rows = std::clamp(static_cast<float>(context.window.height) / context.unit - 6.5F, 2.0F, 8.0F);
    show_list(context, document, rows * context.unit, does);
    show_changes(context, document, playback, entry.text, does);
    if (primary_button(context, "Done", -1)) dialogs.show(Dialog::none);
    if (does) perform({editing, playback}, *does);
  }
  end_dialog();
}

}  // namespace penpose::app
