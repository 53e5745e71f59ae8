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

// Other readings of the last line as faces, at the foot of the canvas above what it moved.

namespace penpose::app {
namespace {

/// Share of the canvas that the pictures may take, from top to bottom.
constexpr double k_readings_share = 0.2;

const char* question_of(const ReadingOffer& offer) {
  return offer.nothing_moved() ? "Nothing moved. Did you mean" : "Did you mean";
}

/// The line that the readings are of, px of the view as it is; nothing: it was drawn in another one.
std::optional<std::vector<PxPoint>> line_asked_about(const EditingSession& editing, const Canvas& canvas,
                                                     const ReadingOffer& offer) {
  const document::Document& document = editing.document();
  if (offer.face_line()) {
    const document::FaceLine* line = document::find_face_line(document, *offer.face_line());
    return line != nullptr ? document::line_in(canvas.view(), *document.face, *line) : std::nullopt;
  }
  if (!document.moment || document.moment->lines.empty()) return std::nullopt;
  const document::PoseCurve* curve = document::find_curve(document, document.moment->lines.back().curve);
  if (curve == nullptr || !curve->target || curve->target->view.camera != canvas.view().camera ||
      curve->target->view.viewport != canvas.view().viewport)
    return std::nullopt;
  return curve->target->line;
}

}  // namespace

void show_readings(PanelContext& context, const Area& /*area*/, EditingSession& editing, Canvas& canvas,
                   ReadingOffer& offer, PanelState& panels) {
  auto& place = context.own.of<ReadingsPlace>();
  place.area.reset();
  panels.face_pictures = offer.open();
  // An open menu of a line shows them itself, and no other menu is to lie under them.
  if (!offer.open() || panels.curve_menu || panels.face_line_asked(editing.document())) return;
  const Area free = canvas.free_area();
  const auto gap = static_cast<double>(context.gap);
  const auto size = face_readings_size(context, offer, static_cast<float>(free.width() - 2 * gap),
                                       static_cast<float>(k_readings_share * free.height()));
  const ImGuiStyle& style = ImGui::GetStyle();
  const char* question = question_of(offer);
  const float text = ImGui::GetTextLineHeightWithSpacing();
  const auto width =
      static_cast<double>(std::max(size.width, ImGui::CalcTextSize(question).x + 2 * style.WindowPadding.x + 1));
  const auto height = static_cast<double>(size.height + text + 2 * style.WindowPadding.y);
  Area row{free.left + gap, free.bottom - gap - height, free.left + gap + width, free.bottom - gap};
  // What it is about stays in sight.
  const auto seen = line_asked_about(editing, canvas, offer);
  if (seen && std::any_of(seen->begin(), seen->end(), [&](const PxPoint& p) { return row.holds(p); })) {
    row = {row.left, free.top + gap, row.right, free.top + gap + height};
  } else {
    place.area = row;
  }
  if (begin_panel(context, "readings", row)) {
    ImGui::TextUnformatted(question);
    show_face_readings(context, editing, canvas, offer, size.picture);
  }
  end_panel();
}

}  // namespace penpose::app
