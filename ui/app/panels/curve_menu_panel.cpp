#include <algorithm>

#include "ui/app/canvas/canvas.h"
#include "ui/app/controls/controls.h"
#include "ui/app/controls/meant_controls.h"
#include "ui/app/controls/restriction.h"
#include "ui/app/face/feature_words.h"
#include "ui/app/panels/face/face_readings_row.h"
#include "ui/app/panels/face/menu_place.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/session/reading_offer.h"
#include "ui/app/widgets/internal/widgets.h"

// What can be done with a curve that was touched, beside it.

namespace penpose::app {

namespace {

/// The line is no wish, but where a feature of the face is.
void show_feature_rows(PanelContext& context, PanelState& panels, const document::FaceLine& line, PxPoint at,
                       float width, std::optional<document::Command>& chosen) {
  if (!line.feature.empty()) {
    const std::string label = "This is the " + feature_words(line.feature) + "##face";
    if (wide_button(context, label.c_str(), width, false,
                    "The feature runs along this line, as the face is: draw along what is found in the wrong place"))
      chosen = document::LineIsFeature{line.id, line.feature};
    ImGui::SameLine();
  }
  if (!wide_button(context, "This is another feature##face", width, false, "Choose the feature that this line follows"))
    return;
  panels.curve_menu.reset();
  panels.feature_menu = FeatureMenu{{}, line.id, {}, {}, at};
}

/// Which controls lines may move from now on: those of the part that the line is of.
bool show_only_part(PanelContext& context, EditingSession& editing, PanelState& panels, Restriction& restriction,
                    FacePart part, float width) {
  const std::string label = "Only " + words_of_part(part) + "##face";
  if (!wide_button(context, label.c_str(), width, false, "Lines and pulls move nothing else")) return false;
  const MeantControls meant = controls_of_part(editing, panels.own.of<ControlParts>(), part);
  restriction.only(meant.names, meant.words);
  return true;
}

/// What a line of the face may be.
void show_face_menu(PanelContext& context, EditingSession& editing, const Canvas& canvas, PanelState& panels,
                    ReadingOffer& offer, Restriction& restriction, const document::FaceLine& line, PxPoint at) {
  const std::vector<std::string> names = names_of(editing.features());
  const document::CurveId id = line.id;
  const std::string feature = line.feature;
  const float width = 4.2F * context.unit;
  const double wide = 2 * static_cast<double>(width) + 3 * static_cast<double>(context.gap);
  const bool others = offer.open() && offer.face_line() == id;
  const auto part = poses::part_of_feature(feature);
  const auto pictures = face_readings_size(context, offer, static_cast<float>(wide), 3 * context.unit);
  const double rows = static_cast<double>((names.size() + 1) / 2 + 3 + (part ? 1 : 0)) +
                      (others ? static_cast<double>(pictures.height / context.unit) : 0.0);
  std::optional<document::Command> chosen;
  bool taken = false;
  if (begin_panel(context, "line", menu_area(context, canvas, at, wide, rows), true)) {
    if (others) taken = show_face_readings(context, editing, canvas, offer, pictures.picture);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (i % 2 == 1) ImGui::SameLine();
      const std::string label = feature_words(names[i]) + "##face";
      if (wide_button(context, label.c_str(), width, names[i] == feature, "This line is that"))
        chosen = document::NameFaceLine{id, names[i], false};
    }
    if (wide_button(context, "Nothing of these##face", width, feature.empty(), "Ignore this line"))
      chosen = document::NameFaceLine{id, {}, true};
    ImGui::SameLine();
    if (wide_button(context, "Find again##face", width, false, "Find what this line is from all lines"))
      chosen = document::NameFaceLine{id, {}, false};
    if (wide_button(context, "Delete##face", width, false, "Take the line away")) chosen = document::DeleteCurve{id};
    ImGui::SameLine();
    if (wide_button(context, "Close##face", width)) panels.curve_menu.reset();
    show_feature_rows(context, panels, line, at, width, chosen);
    if (part) taken = show_only_part(context, editing, panels, restriction, *part, width) || taken;
  }
  end_panel();
  if (chosen) editing.perform(*chosen);
  if (chosen || taken) panels.curve_menu.reset();
}

}  // namespace

void show_curve_menu(PanelContext& context, const Area& /*area*/, EditingSession& editing, Canvas& canvas,
                     Controls& controls, ReadingOffer& offer, PanelState& panels, Restriction& restriction) {
  const auto chosen = panels.curve_menu;
  if (const auto* line = chosen ? document::find_face_line(editing.document(), chosen->first) : nullptr) {
    // A copy: what is chosen changes the document.
    const document::FaceLine shown = *line;
    show_face_menu(context, editing, canvas, panels, offer, restriction, shown, chosen->second);
    return;
  }
  const auto* curve = chosen ? document::find_curve(editing.document(), chosen->first) : nullptr;
  if (curve == nullptr || editing.editor().tool().kind != drawing::ToolKind::none) {
    panels.curve_menu.reset();
    return;
  }
  const bool reference = curve->role == document::PoseCurveRole::reference;
  const float width = 3 * context.unit;
  const double rows = 2 + (reference ? 1 : 0) + (curve->target ? 1 : 0);
  const Area area = menu_area(context, canvas, chosen->second, static_cast<double>(width) + 2 * context.gap, rows);
  const document::CurveId id = curve->id;
  const bool target = curve->target.has_value();
  bool done = false;
  if (begin_panel(context, "curve", area)) {
    if (target && wide_button(context, "Redraw##curve", -1, false, "Draw over a part of this target")) {
      drawing::Tool tool;
      tool.kind = drawing::ToolKind::oversketch;
      tool.curve = id;
      controls.lent().lend(tool);
      done = true;
    }
    if (reference &&
        wide_button(context, "Keep##curve", -1, false, context.actions.keys().tooltip_of(Action::keep_curve).c_str())) {
      editing.perform(document::KeepCurve{id});
      done = true;
    }
    if (wide_button(context, "Feature##curve", -1, false, "Choose the feature that this line follows")) {
      panels.feature_menu = FeatureMenu{{}, id, {}, {}, chosen->second};
      done = true;
    }
    if (wide_button(context, "Delete##curve", -1, false,
                    context.actions.keys().tooltip_of(Action::delete_curve).c_str())) {
      editing.perform(document::DeleteCurve{id});
      done = true;
    }
  }
  end_panel();
  if (done) panels.curve_menu.reset();
}

}  // namespace penpose::app
