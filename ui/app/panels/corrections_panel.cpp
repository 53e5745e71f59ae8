#include <string>
#include <utility>

#include "core/articulation/edit.h"
#include "core/base/numbers.h"
#include "ui/app/controls/controls.h"
#include "ui/app/panels/panel_parts.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct CorrectionsPanelOwners {
  EditingSession& editing;
  Controls& controls;
};

/// Part of a row of equal buttons.
float correction_share(int count) {
  return (ImGui::GetContentRegionAvail().x - static_cast<float>(count - 1) * ImGui::GetStyle().ItemSpacing.x) /
         static_cast<float>(count);
}

/// Stands in the pose of a correction; the next stroke is its target anew.
void redraw_correction(const CorrectionsPanelOwners& with, const std::string& correction) {
  const auto corrections = with.editing.document().model->corrections;
  if (!corrections) return;
  for (const auto& one : corrections->all()) {
    if (one->drawn.sketch.name != correction) continue;
    with.controls.set_swing(false);
    with.editing.shown().preview(std::nullopt);
    // It is drawn on the pose that it corrects: that of its controls alone.
    document::SetParameters values;
    const auto parameters = with.editing.document().model->rig->parameters();
    for (const rig::Parameter& parameter : parameters) {
      double value = parameter.rest;
      for (const articulation::Driver& driver : one->drawn.drivers) {
        if (driver.control == parameter.name) value = driver.value;
      }
      values.values.push_back({parameter.name, value});
    }
    if (!with.editing.perform(values)) return;
    drawing::Tool tool;
    tool.kind = drawing::ToolKind::redraw;
    tool.deformer = correction;
    tool.role = articulation::CurveRole::target;
    with.controls.lent().lend(tool);
    return;
  }
}

}  // namespace

void show_corrections(PanelContext& context, EditingSession& editing, Controls& controls, PanelState& panels) {
  const CorrectionsPanelOwners with{editing, controls};
  // Held, because what is pressed may put others in their place.
  const auto corrections = editing.document().model->corrections;
  if (!corrections || editing.document().pending) return;
  for (const auto& one : corrections->all()) {
    const std::string& name = one->drawn.sketch.name;
    std::string tip = "Corrects";
    for (const articulation::Driver& driver : one->drawn.drivers) {
      tip += " " + with.editing.words_of(driver.control) + " " + base::format_fixed(driver.value, 2);
    }
    ImGui::PushID(name.c_str());
    ImGui::TextUnformatted(name.c_str());
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", tip.c_str());
    const float half = correction_share(2);
    const drawing::Tool& tool = editing.editor().tool();
    const bool redrawing = tool.kind == drawing::ToolKind::redraw && tool.deformer == name;
    bool done = false;
    const std::string again = "Stands in the pose of " + name + "; the next stroke goes where its feature should go";
    if (wide_button(context, "Draw again##correction", half, redrawing, again.c_str())) {
      redraw_correction(with, name);
      done = true;
    }
    ImGui::SameLine();
    if (wide_button(context, "Mirror##correction", half, false, "The same on the other side") && !done) {
      done = editing.perform(document::MirrorDeformer{name, {}});
    }
    // A text field holds one name, and that of a control goes before.
    if (controls.selected().empty()) {
      bool accepted = false;
      text_field(context, "##correction_name", panels.own.of<ControlList>().rename, half, "another name", &accepted);
      ImGui::SameLine();
      if ((wide_button(context, "Rename##correction", half) || accepted) &&
          !panels.own.of<ControlList>().rename.empty() && !done) {
        done = editing.perform(document::RenameDeformer{name, std::exchange(panels.own.of<ControlList>().rename, {})});
      }
    }
    if (wide_button(context, "Remove##correction", -1, false, tip.c_str()) && !done) {
      editing.perform(document::DeleteCorrection{name});
      done = true;
    }
    ImGui::PopID();
    if (done) return;
  }
}

}  // namespace penpose::app
