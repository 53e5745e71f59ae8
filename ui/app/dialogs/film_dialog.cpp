#include <array>
#include <filesystem>

#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/film_entry.h"
#include "ui/app/dialogs/film_job.h"
#include "ui/app/files/files.h"
#include "ui/app/panels/panels.h"
#include "ui/app/playback/film_writer.h"
#include "ui/app/playback/playback.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

struct FilmSize {
  const char* label;
  geometry::Viewport size;
};
constexpr std::array k_sizes{FilmSize{"1280 x 720", {1280, 720}}, FilmSize{"1920 x 1080", {1920, 1080}},
                             FilmSize{"1080 x 1080", {1080, 1080}}};

}  // namespace

void show_film_dialog(PanelContext& context, EditingSession& editing, Playback& playback, FilmWriter& film,
                      Files& files, Dialogs& dialogs) {
  std::string& name = dialogs.state<FileChoice>().name;
  if (name.empty() && context.dialog_opens) {
    const std::string from = files.project().empty() ? files.path() : files.project();
    const std::string stem = from.starts_with("builtin:") ? "head" : fs::path(from).stem().string();
    name = stem + (has_ffmpeg() ? ".mp4" : ".png");
  }
  if (begin_dialog(context, "Film", 15)) {
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - spacing);
    const bool pictures = fs::path(name).extension() == ".png";
    if (wide_button(context, "A film (.mp4)", half, !pictures, "Made by ffmpeg; plays anywhere")) {
      name = fs::path(name).replace_extension(".mp4").string();
    }
    ImGui::SameLine();
    if (wide_button(context, "Pictures (.png)", half, pictures, "One file a frame, for other programs")) {
      name = fs::path(name).replace_extension(".png").string();
    }
    const float third = (ImGui::GetContentRegionAvail().x - 2 * spacing) / 3;
    for (std::size_t i = 0; i < k_sizes.size(); ++i) {
      if (i > 0) ImGui::SameLine();
      if (wide_button(context, k_sizes[i].label, third, dialogs.state<FilmEntry>().size == k_sizes[i].size)) {
        dialogs.state<FilmEntry>().size = k_sizes[i].size;
      }
    }
    dialog_field(context, "##film name", name, "name.mp4");
    const auto& keys = editing.document().timeline->keys;
    ImGui::TextWrapped("%s at %d frames a second, seen as now, into %s",
                       keys.empty() ? "Nothing is keyed yet" : "From the first frame to the last key", playback.rate(),
                       dialogs.state<FileChoice>().folder.c_str());
    ImGui::BeginDisabled(keys.empty() || name.empty());
    if (wide_button(context, "Write##film", 4 * context.unit) || (context.accepts && !keys.empty() && !name.empty())) {
      const std::string path = (fs::path(dialogs.state<FileChoice>().folder) / name).string();
      if (film.write(path, dialogs.state<FilmEntry>().size)) {
        dialogs.close();
        name.clear();
      }
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (wide_button(context, "Cancel")) context.actions.run(Action::cancel);
  }
  end_dialog();
}

}  // namespace penpose::app
