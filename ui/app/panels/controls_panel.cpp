#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/articulation/edit.h"
#include "core/base/numbers.h"
#include "ui/app/canvas/canvas.h"
#include "ui/app/controls/controls.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/notices.h"
#include "ui/app/panels/panel_entries.h"
#include "ui/app/panels/panel_parts.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/widgets/internal/widgets.h"

// The sketched controls: the one that is being drawn, the list of them, and what can be done with the chosen one.

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct ControlsPanelOwners {
  EditingSession& editing;
  Canvas& canvas;
  Controls& controls;
  Notices& notices;
  Dialogs& dialogs;
  PanelState& panels;
};

using articulation::CurveRole;
using articulation::Surface;

/// Part of a row of equal buttons.
float share(int count) {
  return (ImGui::GetContentRegionAvail().x - static_cast<float>(count - 1) * ImGui::GetStyle().ItemSpacing.x) /
         static_cast<float>(count);
}

void show_step_list(const ControlsPanelOwners& with, const document::PendingSketch& pending,
                    const drawing::Tool& tool) {
  struct Step {
    const char* text;
    articulation::CurveRole role;
    bool done;
  };
  const articulation::Sketch& sketch = pending.sketch;
  const auto next = drawing::next_step(with.editing.document(), tool);
  const Step steps[] = {
      {"1  around all that may move", articulation::CurveRole::general, !sketch.general.empty()},
      {"2  around what moves fully", articulation::CurveRole::specific, !sketch.specific.empty()},
      {tool.draw_reference ? "3  along the feature" : "3  the feature is found by itself",
       articulation::CurveRole::reference, !sketch.reference.empty()},
      {"4  where it should go", articulation::CurveRole::target, false},
  };
  for (const Step& step : steps) {
    const bool now = step.role == next;
    ImGui::TextColored(now ? ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive)
                           : ImGui::GetStyleColorVec4(step.done ? ImGuiCol_Text : ImGuiCol_TextDisabled),
                       "%s %s",
                       now         ? "\u25b6"
                       : step.done ? "\u2713"
                                   : "  ",
                       step.text);
  }
}

/// The mode that was pressed, if one was.
std::optional<articulation::Mode> mode_buttons(PanelContext& context, articulation::Mode now) {
  constexpr std::pair<articulation::Mode, const char*> k_modes[] = {{articulation::Mode::automatic, "Auto"},
                                                                    {articulation::Mode::translate, "Slide"},
                                                                    {articulation::Mode::rotate, "Turn"}};
  std::optional<articulation::Mode> pressed;
  const float width = share(3);
  for (const auto& [mode, label] : k_modes) {
    if (mode != articulation::Mode::automatic) ImGui::SameLine();
    if (wide_button(context, label, width, now == mode,
                    "How the feature goes from where it is to where it was drawn")) {
      pressed = mode;
    }
  }
  return pressed;
}

/// What the first line takes: what was pressed, if anything.
document::TakeRegion take_buttons(PanelContext& context, articulation::Reach reach, std::uint32_t piece,
                                  std::uint32_t pieces) {
  using articulation::Reach;
  document::TakeRegion take;
  const float width = share(2);
  if (wide_button(context, "Through", width, reach == Reach::through,
                  "The first line takes all that lies inside it, also behind") &&
      reach != Reach::through) {
    take.reach = Reach::through;
  }
  ImGui::SameLine();
  if (wide_button(context, "Front only", width, reach == Reach::front, "The first line takes only what is seen") &&
      reach != Reach::front) {
    take.reach = Reach::front;
  }
  if (pieces < 2) return take;
  const std::string label =
      "Piece " + std::to_string(piece + 1) + " of " + std::to_string(pieces) + ": take the next##piece";
  if (wide_button(context, label.c_str(), -1, false, "Several pieces of the model lie inside the first line")) {
    take.piece = (piece + 1) % pieces;
  }
  return take;
}

/// What is shown where nothing was chosen.
constexpr const char* k_found = "what it lies on";

/// The surface that was chosen, if one was.
std::optional<Surface> surface_button(PanelContext& context, const ControlsPanelOwners& with, const Surface& now,
                                      const articulation::RegionPoints& region) {
  const bool slides = !std::holds_alternative<std::monostate>(now);
  const std::string over = of_surface(now, std::string(k_found), [](const auto& one) { return one.words(); });
  if (wide_button(context, ("Over: " + over + "##surface").c_str(), -1, slides,
                  "What it slides over and keeps its distance from, as a lid does from the eye")) {
    ImGui::OpenPopup("surface");
  }
  std::optional<Surface> chosen;
  if (!begin_menu(context, "surface")) return chosen;
  const float width = 7 * context.unit;
  if (wide_button(context, k_found, width, false,
                  "A ball that it lies on, as a lid does on the eye, if there is one")) {
    chosen = Surface();
  }
  articulation::each_surface_kind([&]<typename Kind>() {
    for (const auto& offered : Kind::offered(*with.editing.document().model->mesh, region)) {
      const char* tip = offered.tip.empty() ? nullptr : offered.tip.c_str();
      if (!wide_button(context, offered.words.c_str(), width, false, tip)) continue;
      chosen = offered.make();
      if (chosen) continue;
      with.notices.tell(offered.unable);
      ImGui::CloseCurrentPopup();
    }
  });
  if (chosen) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  return chosen;
}

void swing_button(PanelContext& context, const ControlsPanelOwners& with, float width) {
  if (wide_button(context, "Swing", width, with.controls.swings(),
                  "Plays the control to and fro, also while drawing")) {
    with.controls.set_swing(!with.controls.swings());
  }
}

/// Corrects the pose as it stands.
void show_correct_button(PanelContext& context, const ControlsPanelOwners& with) {
  const document::Document& document = with.editing.document();
  const auto parameters = document.model->rig->parameters();
  std::size_t posed = 0;
  for (std::size_t i = 0; i < parameters.size(); ++i) posed += document.pose[i] != parameters[i].rest ? 1 : 0;
  ImGui::BeginDisabled(posed < articulation::k_fewest_drivers);
  if (wide_button(context, "Correct this pose", -1, false,
                  "Sketch what the controls that are away from rest should do where they come together")) {
    with.controls.correct_pose();
  }
  ImGui::EndDisabled();
}

void show_new(PanelContext& context, const ControlsPanelOwners& with) {
  EditingSession& editing = with.editing;
  const auto pending = editing.document().pending;
  if (!pending && wide_button(context, "New control", -1, false, "Sketch a control in three or four strokes")) {
    with.controls.select({});
    context.actions.run(Action::tool_articulate);
    return;
  }
  const bool none_chosen = with.controls.selected().empty();
  if (!pending) show_correct_button(context, with);
  if (!pending && (editing.editor().tool().kind != drawing::ToolKind::articulate || !none_chosen)) return;
  if (pending) {
    ImGui::Text(pending->drivers.empty() ? "Sketching %s" : "Sketching %s, of the pose", pending->sketch.name.c_str());
    for (const articulation::Driver& driver : pending->drivers) {
      ImGui::TextDisabled("  %s %.2f", driver.control.c_str(), driver.value);
    }
    show_step_list(with, *pending, editing.editor().tool());
  }
  const articulation::Mode mode = pending ? pending->sketch.mode : with.controls.new_mode();
  const Surface surface = pending ? pending->sketch.surface : with.controls.new_surface();
  if (const auto pressed = mode_buttons(context, mode)) with.controls.choose_for_new(*pressed, surface);
  const auto region = [&] { return editing.shown().sketch().region_points(); };
  if (const auto chosen = surface_button(context, with, surface, region)) with.controls.choose_for_new(mode, *chosen);
  if (pending) {
    const auto take =
        take_buttons(context, pending->sketch.reach, pending->sketch.piece, editing.shown().sketch().pieces());
    if (take.reach || take.piece) editing.perform(take);
  }
  drawing::Tool tool = editing.editor().tool();
  if (wide_button(context, tool.draw_reference ? "Find the feature by itself" : "Draw the feature myself", -1, false,
                  "The green line: found in the middle of what moves fully, or drawn by you")) {
    tool.kind = drawing::ToolKind::articulate;
    tool.draw_reference = !tool.draw_reference;
    editing.set_tool(tool);
    // What was drawn before gives way to what is found, or to what will be drawn.
    if (pending && !pending->sketch.reference.empty()) {
      editing.perform(document::SketchCurve{CurveRole::reference, with.canvas.view(), {}});
    }
  }
  if (!pending) return;
  double amount = editing.shown().sketch().amount();
  bool released = false;
  const float width = ImGui::GetContentRegionAvail().x - 2.4F * context.unit - ImGui::GetStyle().ItemSpacing.x;
  if (tall_slider(context, "##amount", amount, 0, 1, width, "how far", released)) {
    with.controls.set_swing(false);
    editing.shown().sketch().set_amount(amount);
  }
  ImGui::SameLine();
  swing_button(context, with, -1);
  if (wide_button(context, "Cancel##sketch", -1, false, "Discard the lines of this control (Esc)")) {
    editing.perform(document::CancelDeformer{});
  }
}

void show_place(PanelContext& context, const ControlsPanelOwners& with, const std::string& name, std::size_t number,
                std::size_t count) {
  EditingSession& editing = with.editing;
  const float quarter = share(4);
  if (wide_button(context, "Mirror", quarter, false, "Make the same control on the other side of the face")) {
    with.controls.mirror(name);
  }
  ImGui::SameLine();
  if (wide_button(context, "Remove", quarter, false, "Delete this control")) {
    editing.perform(document::DeleteDeformer{name});
    with.controls.select({});
  }
  ImGui::SameLine();
  ImGui::BeginDisabled(number == 0);
  if (wide_button(context, "Up", quarter, false, "Earlier in the list")) {
    editing.perform(document::MoveDeformer{name, static_cast<std::uint32_t>(number - 1)});
  }
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(number + 1 >= count);
  if (wide_button(context, "Down", quarter, false, "Later in the list")) {
    editing.perform(document::MoveDeformer{name, static_cast<std::uint32_t>(number + 1)});
  }
  ImGui::EndDisabled();
}

void show_redraws(PanelContext& context, const ControlsPanelOwners& with, const articulation::Deformer& deformer) {
  struct Redraw {
    const char* label;
    CurveRole role;
    const char* tip;
  };
  constexpr Redraw k_redraws[] = {
      {"Region", CurveRole::general, "The next stroke goes around all that may move"},
      {"Core", CurveRole::specific, "The next stroke goes around what moves fully"},
      {"Feature", CurveRole::reference, "The next stroke goes along the feature as it is at rest"},
      {"Target", CurveRole::target, "The next stroke goes where the feature should go"}};
  ImGui::TextDisabled("Draw again");
  const float quarter = share(4);
  const std::string name = deformer.sketch().name;
  for (const Redraw& one : k_redraws) {
    const drawing::Tool& tool = with.editing.editor().tool();
    const bool chosen = tool.kind == drawing::ToolKind::redraw && tool.deformer == name && tool.role == one.role;
    if (one.role != CurveRole::general) ImGui::SameLine();
    if (wide_button(context, one.label, quarter, chosen, one.tip)) with.controls.redraw(name, one.role);
  }
  if (!deformer.inferred() &&
      wide_button(context, "Find the feature by itself", -1, false, "Forget the feature's line that was drawn")) {
    with.editing.perform(document::RedrawCurve{name, CurveRole::reference, with.canvas.view(), {}});
  }
}

/// The other targets of a control: one more at the value that it shows, and those that there are.
void show_betweens(PanelContext& context, const ControlsPanelOwners& with, const articulation::Deformer& deformer,
                   double value) {
  const std::string name = deformer.sketch().name;
  if (deformer.sketch().paper) return;
  const std::string at = base::format_fixed(value, 2);
  const bool rests = std::abs(value) < 1e-3 || std::abs(value - 1) < 1e-3;
  ImGui::BeginDisabled(rests);
  if (wide_button(context, ("Another target at " + at + "##between").c_str(), -1, false,
                  "The next stroke goes where the feature is at this value: set the slider between rest and target")) {
    with.controls.draw_between(name, value);
  }
  ImGui::EndDisabled();
  for (const articulation::Between& one : deformer.sketch().betweens) {
    const std::string shown = base::format_fixed(one.value, 2);
    const float half = share(2);
    if (wide_button(context, ("Target at " + shown + "##again" + shown).c_str(), half, false,
                    "Draw this target again")) {
      with.controls.draw_between(name, one.value);
    }
    ImGui::SameLine();
    if (wide_button(context, ("Remove##between" + shown).c_str(), half, false, "Remove this target")) {
      with.editing.perform(document::DeleteBetween{name, one.value});
      return;
    }
  }
}

void show_chosen(PanelContext& context, const ControlsPanelOwners& with, const articulation::SketchedDeformers& set,
                 std::size_t number) {
  EditingSession& editing = with.editing;
  const articulation::Deformer& deformer = *set.deformers()[number];
  const std::string name = deformer.sketch().name;
  const auto index = rig::find_parameter(editing.document().model->rig->parameters(), name);
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  if (index) {
    bool released = false;
    const rig::Parameter& parameter = editing.document().model->rig->parameters()[*index];
    const auto& shown = editing.shown().pose();
    double value = *index < shown.size() ? shown[*index] : 0;
    const float width = ImGui::GetContentRegionAvail().x - 3.4F * context.unit - 2 * spacing;
    if (tall_slider(context, "##play", value, parameter.minimum, parameter.maximum, width, name, released)) {
      with.controls.set_swing(false);
      with.controls.preview_parameter(*index, value);
    }
    if (released) with.controls.set_parameter(*index, value);
    ImGui::SameLine();
    if (wide_button(context, "\u270e##range", context.unit, false, "Type its value, or change its range")) {
      with.dialogs.state<NumberEntry>() = {name, {}, NumberEntry::Field::value};
      with.dialogs.show(Dialog::number);
    }
    ImGui::SameLine();
    swing_button(context, with, -1);
  }
  bool accepted = false;
  text_field(context, "##rename", with.panels.own.of<ControlList>().rename,
             ImGui::GetContentRegionAvail().x - 3 * context.unit - spacing, "another name", &accepted);
  ImGui::SameLine();
  if ((wide_button(context, "Rename", -1) || accepted) && !with.panels.own.of<ControlList>().rename.empty()) {
    const std::string to = std::exchange(with.panels.own.of<ControlList>().rename, {});
    with.controls.rename(name, to);
    return;
  }
  document::ChangeDeformer change;
  change.deformer = name;
  change.mode = mode_buttons(context, deformer.sketch().mode);
  const auto region = [&] {
    std::vector<geometry::ModelPoint> points;
    const auto canvas = document::make_canvas(*editing.document().model);
    if (!canvas) return points;
    for (const std::uint32_t vertex : deformer.vertices()) points.push_back((*canvas)->positions()[vertex]);
    return points;
  };
  change.surface = surface_button(context, with, deformer.sketch().surface, region);
  const articulation::Sketch& sketch = deformer.sketch();
  if (!sketch.paper && !sketch.reference.empty() &&
      wide_button(context, "Other sheet", -1, sketch.other_sheet,
                  "Where two sheets of the surface meet, such as lips: the feature lies on the other one")) {
    change.other_sheet = !sketch.other_sheet;
  }
  const auto take = take_buttons(context, sketch.reach, sketch.piece, deformer.pieces());
  change.reach = take.reach;
  change.piece = take.piece;
  if (change.mode || change.surface || change.other_sheet || change.reach || change.piece) editing.perform(change);
  show_redraws(context, with, deformer);
  if (index && *index < editing.shown().pose().size()) {
    show_betweens(context, with, deformer, editing.shown().pose()[*index]);
  }
  show_place(context, with, name, number, set.deformers().size());
}

}  // namespace

void show_deformers(PanelContext& context, EditingSession& editing, Canvas& canvas, Controls& controls,
                    Notices& notices, Dialogs& dialogs, PanelState& panels) {
  const ControlsPanelOwners with{editing, canvas, controls, notices, dialogs, panels};
  show_new(context, with);
  show_corrections(context, editing, controls, panels);
  // Held, because what is pressed may put another set in its place.
  const auto deformers = editing.document().model->deformers;
  if (!deformers) return;
  const auto chosen =
      editing.document().pending ? std::nullopt : articulation::find_deformer(*deformers, controls.selected());
  const float below = chosen ? 12.0F * context.unit : 0;
  const float list_height = std::max(2.5F * context.unit, ImGui::GetContentRegionAvail().y - below);
  begin_list(context, "controls", {0, list_height});
  for (const auto& deformer : deformers->deformers()) {
    const std::string& name = deformer->sketch().name;
    if (wide_button(context, name.c_str(), -1, name == controls.selected())) {
      controls.set_swing(false);
      controls.select(name == controls.selected() ? std::string() : name);
    }
    if (name == controls.selected() && name != panels.own.of<ControlList>().scrolled_to) ImGui::SetScrollHereY();
  }
  ImGui::EndChild();
  panels.own.of<ControlList>().scrolled_to = controls.selected();
  if (chosen) show_chosen(context, with, *deformers, *chosen);
}

}  // namespace penpose::app
