#include <algorithm>
#include <string>
#include <vector>

#include "core/document/features/feature_near.h"
#include "ui/app/canvas/canvas.h"
#include "ui/app/controls/meant_controls.h"
#include "ui/app/controls/restriction.h"
#include "ui/app/face/feature_words.h"
#include "ui/app/panels/face/line_names.h"
#include "ui/app/panels/face/menu_place.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/view/shown_features.h"
#include "ui/app/widgets/internal/widgets.h"

// Names of the features of the face, while they are corrected, and the menu of one of them, or of a line that has to be
// said which feature it is.

namespace penpose::app {
namespace {

using document::Command;

/// What a line is that runs along a feature.
Command correction_of(const FeatureMenu& menu, const std::string& feature) {
  if (menu.curve) return document::LineIsFeature{*menu.curve, feature};
  return document::DrawFeature{menu.view, menu.line, feature};
}

/// Which feature a line runs along.
std::optional<Command> choose_feature(PanelContext& context, const EditingSession& editing, const Canvas& canvas,
                                      const FeatureMenu& menu, bool& closes) {
  const auto names = document::nameable_features(*editing.document().model, editing.all_features());
  const float width = 4.2F * context.unit;
  const double wide = 2 * static_cast<double>(width) + 3 * static_cast<double>(context.gap);
  const auto rows = static_cast<double>((names.size() + 1) / 2 + 2);
  std::optional<Command> chosen;
  if (begin_panel(context, "feature", menu_area(context, canvas, menu.at, wide, rows), true)) {
    ImGui::TextUnformatted("Which feature is this?");
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (i % 2 == 1) ImGui::SameLine();
      const std::string label = feature_words(names[i]) + "##which";
      const std::string tip = "The " + feature_words(names[i]) + " of the face runs along this line";
      if (wide_button(context, label.c_str(), width, false, tip.c_str())) chosen = correction_of(menu, names[i]);
    }
    closes = wide_button(context, "Close##which", width);
  }
  end_panel();
  return chosen;
}

/// Which controls lines may move: those of the part that a feature is of.
bool show_part_rows(PanelContext& context, EditingSession& editing, PanelState& panels, Restriction& restriction,
                    FacePart part) {
  const std::string words = words_of_part(part);
  const bool only =
      wide_button(context, ("Only " + words + "##part").c_str(), -1, false, "Lines and pulls move nothing else");
  const bool without =
      wide_button(context, ("Not " + words + "##part").c_str(), -1, false, "Lines and pulls move everything else");
  if (!only && !without) return false;
  const MeantControls meant = controls_of_part(editing, panels.own.of<ControlParts>(), part);
  if (only) restriction.only(meant.names, meant.words);
  if (without) restriction.without(meant.names, meant.words);
  return true;
}

/// What can be done with a feature.
std::optional<Command> change_feature(PanelContext& context, EditingSession& editing, const Canvas& canvas,
                                      PanelState& panels, Restriction& restriction, bool& closes) {
  const FeatureMenu menu = *panels.feature_menu;
  const auto part = poses::part_of_feature(menu.feature);
  const bool corrected = document::find_correction(*editing.document().model, menu.feature) != nullptr;
  const double wide = 5.0 * static_cast<double>(context.unit);
  std::optional<Command> chosen;
  if (begin_panel(context, "feature",
                  menu_area(context, canvas, menu.at, wide, (corrected ? 3.6 : 2.6) + (part ? 2 : 0)))) {
    ImGui::TextUnformatted(feature_words(menu.feature).c_str());
    if (wide_button(context, "No such feature", -1, false, "The face has no such feature; lines are never read as it"))
      chosen = document::PlaceFeature{menu.feature, {}};
    if (corrected && wide_button(context, "As found", -1, false, "Undo your correction"))
      chosen = document::FeatureAsFound{menu.feature};
    const bool restricts = part && show_part_rows(context, editing, panels, restriction, *part);
    closes = wide_button(context, "Close##feature", -1) || restricts;
  }
  end_panel();
  return chosen;
}

/// Where the canvas is narrower, of the height of a button, names would hide the face.
constexpr double k_room = 14;

struct NamedLine {
  std::string feature;
  LineName shown;
  double top = 0;  ///< px
};

/// All features, from the top of the canvas to its foot, so that names stand in the order of their lines.
std::vector<NamedLine> named_lines(const EditingSession& editing, const Canvas& canvas) {
  const document::FeatureCurves& features = editing.all_features();
  std::vector<NamedLine> out;
  for (const auto* list : {&features.curves, &features.unsure}) {
    for (const portrait::FeatureCurve& curve : *list) {
      auto line = feature_line(curve, canvas.surface(), canvas.view());
      if (line.empty()) continue;
      const bool sure = list == &features.curves;
      const double top = line[line.size() / 2].y;
      out.push_back({curve.name, {std::move(line), feature_words(curve.name) + (sure ? "" : "?"), sure}, top});
    }
  }
  std::stable_sort(out.begin(), out.end(), [](const NamedLine& a, const NamedLine& b) { return a.top < b.top; });
  return out;
}

/// Leaves the one whose line the pointer is near.
void keep_pointed(std::vector<NamedLine>& named, const PanelContext& context, const EditingSession& editing,
                  const Canvas& canvas) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const auto near =
      shown_feature_near(editing, canvas.surface(), {static_cast<double>(mouse.x), static_cast<double>(mouse.y)},
                         0.5 * static_cast<double>(context.unit));
  std::erase_if(named, [&](const NamedLine& one) { return one.feature != near; });
}

}  // namespace

void show_feature_names(PanelContext& context, const Area& free, EditingSession& editing, Canvas& canvas,
                        PanelState& panels) {
  panels.feature_labels.clear();
  if (!panels.shown || editing.pen_is_drawing()) return;
  if (editing.editor().tool().kind != drawing::ToolKind::feature) return;
  std::vector<NamedLine> named = named_lines(editing, canvas);
  if (free.width() < k_room * static_cast<double>(context.unit)) keep_pointed(named, context, editing, canvas);
  std::vector<LineName> names;
  names.reserve(named.size());
  for (const NamedLine& one : named) names.push_back(one.shown);
  const auto areas =
      show_line_names(context, free, names, !panels.feature_menu, "Draw along it to correct it, or press for more");
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (!areas[i]) continue;
    panels.feature_labels.emplace_back(named[i].feature, *areas[i]);
    context.targets["feature " + named[i].feature] = *areas[i];
  }
}

void show_feature_menu(PanelContext& context, const Area& /*area*/, EditingSession& editing, Canvas& canvas,
                       PanelState& panels, Restriction& restriction) {
  if (!panels.feature_menu) return;
  const FeatureMenu menu = *panels.feature_menu;
  bool closes = false;
  const auto chosen = menu.feature.empty() ? choose_feature(context, editing, canvas, menu, closes)
                                           : change_feature(context, editing, canvas, panels, restriction, closes);
  if (chosen) editing.perform(*chosen);
  if (chosen || closes) panels.feature_menu.reset();
}

}  // namespace penpose::app
