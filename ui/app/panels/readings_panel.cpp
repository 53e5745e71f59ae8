#include <algorithm>
#include <optional>

#include "ui/app/canvas/canvas.h"
#include "ui/app/panels/face/face_readings_row.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/session/reading_offer.h"
#include "ui/app/widgets/internal/widgets.h"

// Other readings of the last line, at the foot of the canvas above what it moved.

namespace penpose::app {
namespace {

const char* question_of(const ReadingOffer& offer) {
  return offer.nothing_moved() ? "Nothing moved. Did you mean" : "Did you mean";
}

/// Whether a row would lie over the line that it is about.
bool hides_line(const Area& row, const EditingSession& editing, const Canvas& canvas, const ReadingOffer& offer) {
  const auto& face = editing.document().face;
  const document::FaceLine* line = document::find_face_line(editing.document(), *offer.face_line());
  const auto seen = line != nullptr ? document::line_in(canvas.view(), *face, *line) : std::nullopt;
  return seen && std::any_of(seen->begin(), seen->end(), [&](const PxPoint& p) { return row.holds(p); });
}

/// What a line of the face may be besides, in pictures.
void show_faces(PanelContext& context, EditingSession& editing, const Canvas& canvas, ReadingOffer& offer) {
  const Area free = canvas.free_area();
  const auto gap = static_cast<double>(context.gap);
  const auto size = face_readings_size(context, offer, static_cast<float>(free.width() - 2 * gap));
  const ImGuiStyle& style = ImGui::GetStyle();
  const char* question = question_of(offer);
  const float text = ImGui::GetTextLineHeightWithSpacing();
  const auto width =
      static_cast<double>(std::max(size.width, ImGui::CalcTextSize(question).x + 2 * style.WindowPadding.x + 1));
  const auto height = static_cast<double>(size.height + text + 2 * style.WindowPadding.y);
  Area row{free.left + gap, free.bottom - gap - height, free.left + gap + width, free.bottom - gap};
  // What it is about stays in sight.
  if (hides_line(row, editing, canvas, offer)) {
    row = {row.left, free.top + gap, row.right, free.top + gap + height};
  } else {
    context.own.of<ReadingsPlace>().area = row;
  }
  if (begin_panel(context, "readings", row)) {
    ImGui::TextUnformatted(question);
    show_face_readings(context, editing, offer, size.picture);
  }
  end_panel();
}

}  // namespace

void show_readings(PanelContext& context, const Area& /*area*/, EditingSession& editing, Canvas& canvas,
                   ReadingOffer& offer, PanelState& panels) {
  auto& place = context.own.of<ReadingsPlace>();
  place.area.reset();
  panels.face_pictures = offer.open() && offer.face_line();
  // An open menu of a line shows them itself.
  if (!offer.open() || panels.face_line_asked(editing.document())) return;
  if (offer.face_line()) return show_faces(context, editing, canvas, offer);
  const Area free = canvas.free_area();
  const char* question = question_of(offer);
  const ImGuiStyle& style = ImGui::GetStyle();
  std::vector<std::string> labels;
  for (const OfferedReading& one : offer.readings())
    labels.push_back(one.words + "?" + (one.percent ? " " + std::to_string(*one.percent) + " %" : ""));
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
      tooltip(context,
              (offer.readings()[i].words + ": the face shows it; press to take it, and Undo takes it back").c_str());
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
