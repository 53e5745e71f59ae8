#include <algorithm>
#include <array>
#include <filesystem>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <optional>
#include <string>
#include <vector>

#include "ui/app/dialogs/file_browser.h"
#include "ui/app/dialogs/first_pass_entry.h"
#include "ui/app/mouths/first_pass.h"
#include "ui/app/mouths/kept_mouths.h"
#include "ui/app/widgets/internal/widgets.h"
#include "ui/files/files.h"

// The first pass of a sound that is spoken: by its text, by ear, or by the cues of another program.

namespace penpose::app {
namespace {

using Way = FirstPassEntry::Way;

/// What is shown and changed here.
struct PassOwners {
  const EditingSession& editing;
  const SoundTrack& track;
  KeptMouths& kept;
  FirstPass& pass;
  Files& files;
  Preferences& preferences;
  Dialogs& dialogs;
  FirstPassEntry& entry;
};

const std::vector<FileKind>& texts() {
  static const std::vector<FileKind> kinds{{"Texts", {".txt"}}, {"All files", {}}};
  return kinds;
}
const std::vector<FileKind>& cue_files() {
  static const std::vector<FileKind> kinds{
      {"Cues",
       {".tsv", ".json", ".xml", ".dat", ".txt", ".textgrid", ".pgo", ".pg2", ".srt", ".vtt", ".marks", ".csv"}},
      {"All files", {}}};
  return kinds;
}

/// The text with its lines broken where the field ends; words are all that counts of it.
std::string wrapped(const std::string& text, float width) {
  std::string out;
  float used = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n", at);
    if (begin == std::string::npos) break;
    const std::size_t end = std::min(text.find_first_of(" \t\r\n", begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const float wide = ImGui::CalcTextSize((" " + word).c_str()).x;
    if (!out.empty()) out += used + wide > width ? '\n' : ' ';
    used = out.empty() || out.back() == '\n' ? wide : used + wide;
    out += word;
    at = end;
  }
  return out;
}

void tell(const PassOwners& with, const base::Status& status, const std::string& place = {}) {
  with.entry.told = status ? std::string() : status.error().line(place);
}

/// What is said, in lines.
void show_field(PanelContext& context, const PassOwners& with) {
  FirstPassEntry& entry = with.entry;
  context.has_field = true;
  if (context.field_first) ImGui::SetKeyboardFocusHere();
  const float high = 4 * context.unit;
  ImGui::InputTextMultiline("##said", &entry.text, {-1, high});
  note_field(context, "##said");
  const float width = ImGui::GetItemRectSize().x - 2 * ImGui::GetStyle().FramePadding.x -
                      ImGui::GetStyle().ScrollbarSize - ImGui::GetFontSize();
  if (!ImGui::IsItemActive() && entry.text != entry.wrapped) entry.wrapped = entry.text = wrapped(entry.text, width);
}

void show_text(PanelContext& context, const PassOwners& with) {
  FirstPassEntry& entry = with.entry;
  ImGui::TextWrapped("%s", "What is said, word by word, in English. Lips then close on 19 of 20 p, b and m.");
  if (entry.looks_for_text) {
    const std::string chosen = browse(context, {with.files, with.preferences, with.dialogs}, {texts(), 4, 2});
    if (wide_button(context, "Type it##said")) entry.looks_for_text = false;
    if (chosen.empty()) return;
    const auto bytes = files::read_file(chosen, files::k_most_text_bytes);
    tell(with, bytes ? base::Status(base::Done{}) : base::Status(bytes.error()), chosen);
    if (!bytes) return;
    entry.text = std::string(bytes->begin(), bytes->end());
    entry.looks_for_text = false;
    return;
  }
  show_field(context, with);
  if (wide_button(context, "Open a text (.txt)")) entry.looks_for_text = true;
  ImGui::SameLine();
  const char* copied = ImGui::GetClipboardText();
  const bool any = copied != nullptr && *copied != 0;
  ImGui::BeginDisabled(!any);
  if (wide_button(context, "Paste##said", 0, false, "What was copied in another program") && any) entry.text = copied;
  ImGui::EndDisabled();
}

void show_cues(PanelContext& context, const PassOwners& with) {
  ImGui::TextWrapped(
      "%s",
      "Cues of Rhubarb, Papagayo, Praat, Polly, Azure or Audacity, captions or words. They begin with the sound.");
  const std::string chosen = browse(context, {with.files, with.preferences, with.dialogs}, {cue_files(), 5, 2});
  if (chosen.empty()) return;
  const auto taken = with.pass.take_cues(chosen);
  tell(with, taken, chosen);
  if (taken) with.dialogs.close();
}

/// What is missing before anything can be spoken, with the way to get it. True: nothing is.
bool show_missing(PanelContext& context, const PassOwners& with) {
  const std::size_t kept = with.editing.document().mouths.size();
  if (kept == 0) {
    ImGui::TextWrapped("%s", "No mouth is kept yet. Draw some and keep them in the panel Mouths.");
    if (with.kept.offers_usual() && wide_button(context, "Take those of the model's own controls"))
      with.kept.keep_usual();
    return false;
  }
  if (with.entry.way != Way::cues && with.track.sound() == nullptr) {
    const auto sound = with.editing.document().sound;
    ImGui::TextWrapped("%s", sound == nullptr ? "The timeline has no sound yet."
                                              : ("The file of the sound is gone: " + sound->file).c_str());
    if (wide_button(context, "Open a sound")) {
      with.entry.wants_sound = true;
      with.dialogs.show(Dialog::sound);
    }
    return false;
  }
  if (with.entry.way != Way::cues && !with.entry.cannot.empty()) {
    ImGui::TextWrapped("%s", (with.entry.cannot + ". Cues of another program work without it.").c_str());
    return false;
  }
  return true;
}

void show_ways(PanelContext& context, FirstPassEntry& entry) {
  constexpr std::array<std::pair<Way, const char*>, 3> k_ways{
      {{Way::text, "With the text"}, {Way::ear, "By ear"}, {Way::cues, "Cues of a file"}}};
  const float third = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
  for (const auto& [way, label] : k_ways) {
    if (way != Way::text) ImGui::SameLine();
    if (wide_button(context, label, third, entry.way == way)) entry.way = way;
  }
}

void show_listening(PanelContext& context, const PassOwners& with) {
  ImGui::TextUnformatted("The sound is listened to. Drawing may go on meanwhile.");
  ImGui::ProgressBar(static_cast<float>(with.pass.share()), {-1, context.unit});
  note(context, "listening");
  if (wide_button(context, "Go on drawing")) with.dialogs.close();
  ImGui::SameLine();
  if (wide_button(context, "Stop##listening") || context.cancels) with.pass.stop();
}

}  // namespace

void show_first_pass_dialog(PanelContext& context, EditingSession& editing, SoundTrack& track, KeptMouths& kept,
                            FirstPass& pass, Files& files, Preferences& preferences, Dialogs& dialogs) {
  FirstPassEntry& entry = dialogs.state<FirstPassEntry>();
  const PassOwners with{editing, track, kept, pass, files, preferences, dialogs, entry};
  if (context.dialog_opens) {
    entry.told.clear();
    entry.began = entry.wants_sound = false;
    // What was heard is corrected and spoken again.
    if (const auto words = editing.document().words; words && entry.wrapped.empty()) {
      for (const document::SpokenWord& one : *words) entry.text += (entry.text.empty() ? "" : " ") + one.word;
    }
    const auto can = speech::can_hear();
    entry.cannot = can ? std::string() : can.error().line();
  }
  // What came of it: the dialog goes, or says why not.
  if (entry.began && !pass.listens()) {
    entry.began = false;
    entry.told = pass.refused();
    if (entry.told.empty() && !pass.stopped()) return dialogs.close();
  }
  if (begin_dialog(context, "First pass", 17)) {
    if (pass.listens()) {
      show_listening(context, with);
    } else {
      show_ways(context, entry);
      const bool ready = show_missing(context, with);
      if (ready && entry.way == Way::text) show_text(context, with);
      if (ready && entry.way == Way::cues) show_cues(context, with);
      if (ready && entry.way == Way::ear)
        ImGui::TextWrapped(
            "%s",
            "What is heard is English, and by ear alone lips close on two of three p, b and m. Where you "
            "know what is said, give the text: then it is 19 of 20.");
      if (!entry.told.empty()) ImGui::TextWrapped("%s", entry.told.c_str());
      const bool speaks = ready && (entry.way == Way::ear || (entry.way == Way::text && !entry.text.empty()));
      if (entry.way != Way::cues) {
        ImGui::BeginDisabled(!speaks);
        if (primary_button(context, "Speak##now", 4 * context.unit) || (context.accepts && speaks)) {
          tell(with, pass.listen(entry.way == Way::text ? entry.text : std::string()));
          entry.began = pass.listens();
        }
        ImGui::EndDisabled();
        ImGui::SameLine();
      }
      if (wide_button(context, "Cancel")) context.actions.run(Action::cancel);
    }
  }
  end_dialog();
}

}  // namespace penpose::app
