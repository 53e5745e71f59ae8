#include <string>
#include <vector>

#include "ui/app/canvas/canvas.h"
#include "ui/app/face/feature_words.h"
#include "ui/app/panels/face/line_names.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/session/editing_session.h"

// What each line of the face was taken for, beside it; a touch opens the menu that changes it.

namespace penpose::app {
namespace {

/// Names are beside lines while these are in hand: to draw, to touch, and to see what is erased.
bool shows_names(drawing::ToolKind tool) {
  using ToolKind = drawing::ToolKind;
  return tool == ToolKind::draw || tool == ToolKind::none || tool == ToolKind::erase;
}

}  // namespace

void show_face_labels(PanelContext& context, const Area& free, EditingSession& editing, Canvas& canvas,
                      PanelState& panels) {
  const auto& face = editing.document().face;
  panels.face_labels.clear();
  if (!face || !panels.shown || !editing.moments().shows(face->time_s) || editing.pen_is_drawing()) return;
  if (!shows_names(editing.editor().tool().kind)) return;
  std::vector<LineName> names;
  for (const document::FaceLine& line : face->lines) {
    auto seen = document::line_in(canvas.view(), *face, line);
    if (!seen) return;
    const bool known = !line.feature.empty();
    names.push_back({std::move(*seen), known ? feature_words(line.feature) : "?", known});
  }
  const auto areas = show_line_names(context, free, names, !panels.curve_menu && !panels.feature_menu,
                                     "What this line was taken for: press to say what it is");
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (!areas[i]) continue;
    panels.face_labels.emplace_back(face->lines[i].id, *areas[i]);
    context.targets["line " + std::to_string(i + 1)] = *areas[i];
  }
}

}  // namespace penpose::app
