#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "ui/app/canvas/canvas.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/files/files.h"
#include "ui/app/film/film_entry.h"
#include "ui/app/film/film_writer.h"
#include "ui/app/film/playblast_place.h"
#include "ui/app/panels/panels.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/widgets.h"
#include "ui/film/ffmpeg.h"
#include "ui/film/frame_name.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;
using film::FilmKind;

struct FilmSize {
  const char* label;
  geometry::Viewport size;
};
constexpr std::array k_sizes{FilmSize{"1280 x 720", {1280, 720}}, FilmSize{"1920 x 1080", {1920, 1080}},
                             FilmSize{"1080 x 1080", {1080, 1080}}};
constexpr int k_most_between = 48;

/// Buttons beside each other that share a row.
class Row {
 public:
  explicit Row(int count) : spacing_(ImGui::GetStyle().ItemSpacing.x) {
    width_ = (ImGui::GetContentRegionAvail().x - static_cast<float>(count - 1) * spacing_) / static_cast<float>(count);
  }
  bool button(PanelContext& context, const char* label, bool chosen, const char* tip = nullptr) {
    if (!first_) ImGui::SameLine();
    first_ = false;
    return wide_button(context, label, width_, chosen, tip);
  }

 private:
  float spacing_;
  float width_;
  bool first_ = true;
};

/// What the ending of the typed name says; a sheet is called as pictures are.
void follow_name(FilmEntry& entry, const std::string& name) {
  const auto named = film::kind_of_name(name);
  if (!named || (entry.kind == FilmKind::sheet && *named == FilmKind::pictures)) return;
  entry.kind = *named;
}

void choose_kind(PanelContext& context, FilmEntry& entry, std::string& name) {
  constexpr int k_in_row = 3;
  std::optional<Row> row;
  int shown = 0;
  const auto kinds = film::film_kinds();
  for (const film::FilmKindRow& kind : kinds) {
    const int left = static_cast<int>(kinds.size()) - shown;
    if (shown++ % k_in_row == 0) row.emplace(std::min(left, k_in_row));
    const std::string tip(kind.detail);
    if (!row->button(context, std::string(kind.name).c_str(), entry.kind == kind.kind, tip.c_str())) continue;
    entry.kind = kind.kind;
    name = fs::path(name).replace_extension(kind.extension).string();
  }
}

void choose_size(PanelContext& context, FilmEntry& entry) {
  Row row(static_cast<int>(k_sizes.size()) + 1);
  if (row.button(context, "Canvas", !entry.size, "As large as the canvas is now")) entry.size.reset();
  for (const FilmSize& one : k_sizes) {
    if (row.button(context, one.label, entry.size == one.size)) entry.size = one.size;
  }
}

std::string range_label(const char* name, std::pair<int, int> frames) {
  return std::string(name) + " " + std::to_string(frames.first) + "-" + std::to_string(frames.second);
}

void choose_range(PanelContext& context, FilmEntry& entry, const FilmWriter& film, bool loops) {
  if (entry.range == FilmRange::loop && !loops) entry.range = FilmRange::all;
  struct Choice {
    FilmRange range;
    const char* name;
    const char* tip;
  };
  constexpr std::array k_ranges{
      Choice{FilmRange::all, "All", "From the first frame to where the keys or the sound end"},
      Choice{FilmRange::keys, "Keys", "From the first frame to the last key"},
      Choice{FilmRange::loop, "Loop", "What is played over and over"}};
  Row row(static_cast<int>(k_ranges.size()));
  for (const Choice& one : k_ranges) {
    const bool usable = one.range != FilmRange::loop || loops;
    const std::string label =
        (usable ? range_label(one.name, film.frames_of(one.range)) : std::string(one.name)) + "##range";
    ImGui::BeginDisabled(!usable);
    if (row.button(context, label.c_str(), entry.range == one.range, one.tip)) entry.range = one.range;
    ImGui::EndDisabled();
  }
}

/// What of the frames is on a sheet; whether their numbers are in the pictures of all else.
void choose_frames(PanelContext& context, FilmEntry& entry) {
  if (entry.kind != FilmKind::sheet) {
    if (wide_button(context, "Frame numbers in the picture", -1, entry.numbers)) entry.numbers = !entry.numbers;
    return;
  }
  Row row(2);
  if (row.button(context, "Keyed frames", !entry.every)) entry.every.reset();
  ImGui::SameLine();
  double every = entry.every.value_or(1);
  bool released = false;
  const std::string name = entry.every ? "every n frames" : "or every n frames";
  if (tall_slider(context, "##every", every, 1, k_most_between, ImGui::GetContentRegionAvail().x, name, released)) {
    entry.every = static_cast<int>(std::lround(every));
  }
}

/// What will be written, and what stands in its way.
std::string words_of(const FilmEntry& entry, const FilmWriter& film, int rate, bool has_sound) {
  const auto [first, last] = film.frames_of(entry.range);
  if (entry.kind == FilmKind::sheet) {
    const auto size = film.size_of(entry);
    const std::string which = !entry.every        ? "The keyed frames"
                              : *entry.every == 1 ? "All frames"
                                                  : "One frame of " + std::to_string(*entry.every);
    return which + " from " + std::to_string(first) + " to " + std::to_string(last) + ", each " +
           std::to_string(size.width) + " x " + std::to_string(size.height);
  }
  char text[160];
  std::snprintf(text, sizeof text, "Frames %d to %d at %d a second (%.2f s), seen as now", first, last, rate,
                static_cast<double>(last - first + 1) / rate);
  std::string words(text);
  const bool sounds = film::row_of(entry.kind).sounds;
  if (sounds && film.lacks_sound()) return words + ". The sound cannot be opened: without it";
  if (has_sound) words += sounds ? ", with the sound" : ", without the sound";
  return words;
}

/// The first file that a film is written into.
std::string first_file(const FilmEntry& entry, const std::string& path, int first) {
  return entry.kind == FilmKind::pictures ? film::frame_name(path, static_cast<std::size_t>(first)) : path;
}

}  // namespace

void show_film_dialog(PanelContext& context, EditingSession& editing, Playback& playback, FilmWriter& film,
                      Files& files, Dialogs& dialogs) {
  auto& entry = dialogs.state<FilmEntry>();
  auto& choice = dialogs.state<FileChoice>();
  if (choice.name.empty() && context.dialog_opens) {
    if (!film::has_ffmpeg() && film::row_of(entry.kind).needs_ffmpeg) entry.kind = FilmKind::pictures;
    choice.name = film_stem(files.project(), files.path()) + std::string(film::row_of(entry.kind).extension);
    if (playback.loop().any()) entry.range = FilmRange::loop;
    entry.asked_of.clear();
  }
  if (begin_dialog(context, "Film", 16)) {
    follow_name(entry, choice.name);
    choose_kind(context, entry, choice.name);
    choose_size(context, entry);
    choose_range(context, entry, film, playback.loop().any());
    choose_frames(context, entry);
    dialog_field(context, "##film name", choice.name, "name.mp4");
    const bool keyed = !editing.document().timeline->keys.empty();
    const bool lacks_program = film::row_of(entry.kind).needs_ffmpeg && !film::has_ffmpeg();
    std::string path = (fs::path(choice.folder) / choice.name).string();
    if (!film::kind_of_name(path)) path += film::row_of(entry.kind).extension;
    const std::string first = first_file(entry, path, film.frames_of(entry.range).first);
    std::error_code code;
    if (entry.asked_of != path) entry.asked_of.clear();
    const bool asked = !entry.asked_of.empty();
    if (lacks_program) {
      ImGui::TextWrapped("This needs ffmpeg, which is not installed: install the package ffmpeg, or choose pictures");
    } else if (!keyed) {
      ImGui::TextWrapped("Nothing is keyed yet");
    } else if (asked) {
      ImGui::TextWrapped("%s is there already", fs::path(first).filename().c_str());
    } else if (film.writes()) {
      ImGui::TextWrapped("A film is being written: wait until it is done, or cancel it");
    } else {
      const bool has_sound = editing.document().sound != nullptr;
      const fs::path folder = fs::path(path).parent_path();
      ImGui::TextWrapped("%s, into %s%s", words_of(entry, film, playback.rate(), has_sound).c_str(), folder.c_str(),
                         fs::exists(folder, code) ? "" : ", a new folder");
    }
    const bool can = keyed && !choice.name.empty() && !lacks_program && !film.writes();
    ImGui::BeginDisabled(!can);
    const char* label = asked ? "Write over it##film" : "Write##film";
    const bool pressed = primary_button(context, label, 4 * context.unit) || (context.accepts && can);
    ImGui::EndDisabled();
    if (pressed && !asked && fs::exists(first, code)) {
      entry.asked_of = path;
    } else if (pressed && film.write(path, entry)) {
      dialogs.close();
      choice.name.clear();
    }
    ImGui::SameLine();
    if (wide_button(context, "Cancel")) context.actions.run(Action::cancel);
  }
  end_dialog();
}

}  // namespace penpose::app
