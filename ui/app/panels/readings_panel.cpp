#include <algorithm>
#include <optional>

#include "ui/app/canvas/canvas.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/panels/panels.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/session/reading_offer.h"
#include "ui/app/widgets/internal/widgets.h"

// Other readings of the last line, at the foot of the canvas above what it moved.

namespace penpose::app {

void show_readings(PanelContext& context, const Area& /*area*/, EditingSession& editing, Canvas& canvas,
                   ReadingOffer& offer) {
  auto& place = context.own.of<ReadingsPlace>();
  place.area.reset();
  if (!offer.open()) return;
  const Area free = canvas.free_area();
  const char* question = offer.nothing_moved() ? "Nothing moved. Did you mean" : "Did you mean";
  const ImGuiStyle& style = ImGui::GetStyle();
  std::vector<std::string> labels;
  for (std::size_t i = 0; i < offer.words().size(); ++i)
    labels.push_back(offer.words()[i] + "? " + std::to_string(offer.percents()[i]) + " %");
  float wide = ImGui::CalcTextSize(question).x + 2 * context.gap + 2 * style.WindowPadding.x;
  float shares = 0;
  for (const std::string& label : labels) shares += button_width(context, label.c_str(), {}, true);
  wide += static_cast<float>(labels.size()) * style.ItemSpacing.x;
  const float most = static_cast<float>(free.width()) - 2 * context.gap;
  // Where there is no room for all their names each gives way in the same measure.
  const float fits = std::clamp((most - wide) / shares, 0.2F, 1.0F);
  const auto width = static_cast<double>(std::min(most, wide + shares * fits + 1));
  const auto height = static_cast<double>(context.unit + 2 * style.WindowPadding.y);
  const double left = free.left + static_cast<double>(context.gap);
  const double bottom = free.bottom - static_cast<double>(context.gap);
  const Area row{left, bottom - height, left + width, bottom};
  place.area = row;
  std::optional<std::size_t> shown;
  std::optional<std::size_t> taken;
  if (begin_panel(context, "readings", row)) {
    text_beside(context, question);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      ImGui::SameLine();
      const float own = fits * button_width(context, labels[i].c_str(), {}, true);
      const std::string label =
          fitted_text(labels[i], own - 0.5F * context.unit) + "##reading " + std::to_string(i + 1);
      const bool pressed = icon_button(context, label.c_str(), {own});
      note(context, ("reading " + std::to_string(i + 1)).c_str());
      if (ImGui::IsItemHovered() || ImGui::IsItemActive()) shown = i;
      tooltip(context, (offer.words()[i] + ": the face shows it; press to take it, and Undo takes it back").c_str());
      if (pressed) taken = i;
    }
  }
  end_panel();
  // What was just taken is to be seen before the pen, which is still there, shows what it took the place of.
  if (place.taken != shown) place.taken.reset();
  offer.show(editing, place.taken ? std::nullopt : shown);
  if (!taken) return;
  offer.take(editing, *taken);
  place.taken = taken;
}

}  // namespace penpose::app
