#include <algorithm>
#include <string>

#include "ui/app/canvas/canvas.h"
#include "ui/app/film/film_writer.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/panels/panels.h"
#include "ui/app/widgets/internal/widgets.h"

// How far a film is that is being written, at the top of the canvas.

namespace penpose::app {
namespace {

constexpr double k_film_panel_wide = 11;

std::string words_of(const FilmJob& job) {
  const FilmProgress& progress = job.progress();
  if (job.cancelled()) return "giving up";
  if (progress.all == 0) return "film begins";
  // What is drawn is not yet joined.
  if (progress.done == progress.all) return "film ends";
  return "film " + std::to_string(progress.done) + " of " + std::to_string(progress.all);
}

}  // namespace

void show_film(PanelContext& context, const Area& /*area*/, Canvas& canvas, FilmWriter& film) {
  auto& place = context.own.of<FilmPlace>();
  place.area.reset();
  const FilmJob* job = film.job();
  if (job == nullptr) return;
  const Area free = canvas.free_area();
  const auto gap = static_cast<double>(context.gap);
  const double width = std::min(k_film_panel_wide * static_cast<double>(context.unit), free.width() - 2 * gap);
  const double height = static_cast<double>(context.unit + 2 * ImGui::GetStyle().WindowPadding.y);
  const Area row{free.left + gap, free.top + gap, free.left + gap + width, free.top + gap + height};
  place.area = row;
  bool cancels = false;
  if (begin_panel(context, "film", row)) {
    const float button = button_width(context, "Cancel", {}, true);
    const float bar = ImGui::GetContentRegionAvail().x - button - ImGui::GetStyle().ItemSpacing.x;
    const FilmProgress& progress = job->progress();
    const float share = progress.all == 0 ? 0 : static_cast<float>(progress.done) / static_cast<float>(progress.all);
    ImGui::ProgressBar(share, {bar, context.unit}, words_of(*job).c_str());
    note(context, "film progress");
    ImGui::SameLine();
    ImGui::BeginDisabled(job->cancelled());
    cancels = wide_button(context, "Cancel##film progress", button, false, "Write no film");
    ImGui::EndDisabled();
  }
  end_panel();
  if (cancels) film.cancel();
}

}  // namespace penpose::app
