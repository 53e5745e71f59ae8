#include <array>
#include <filesystem>

#include "ui/app/dialogs/film_entry.h"
#include "ui/app/dialogs/film_job.h"
#include "ui/app/panels/panels.h"
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

void show_film_dialog(PanelContext& context) {
  App& app = context.app;
  std::string& name = app.dialogs().state<FileChoice>().name;
  if (name.empty() && context.dialog_opens) {
    const std::string from = app.project().empty() ? app.path() : app.project();
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
      if (wide_button(context, k_sizes[i].label, third, app.dialogs().state<FilmEntry>().size == k_sizes[i].size)) {
        app.dialogs().state<FilmEntry>().size = k_sizes[i].size;
      }
    }
    dialog_field(context, "##film name", name, "name.mp4");
    const auto& keys = app.editing().document().timeline->keys;
    ImGui::TextWrapped("%s at %d frames a second, seen as now, into %s",
                       keys.empty() ? "Nothing is keyed yet" : "From the first frame to the last key",
                       app.playback().rate(), app.dialogs().state<FileChoice>().folder.c_str());
    ImGui::BeginDisabled(keys.empty() || name.empty());
    if (wide_button(context, "Write##film", 4 * context.unit) || (context.accepts && !keys.empty() && !name.empty())) {
      const std::string path = (fs::path(app.dialogs().state<FileChoice>().folder) / name).string();
      if (app.film().write(path, app.dialogs().state<FilmEntry>().size)) {
        app.dialogs().close();
        name.clear();
      }
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (wide_button(context, "Cancel")) app.do_action(Action::cancel);
  }
  end_dialog();
}

}  // namespace penpose::app
