#include <algorithm>
#include <utility>

#include "core/articulation/edit.h"
#include "ui/app/panels.h"
#include "ui/app/widgets.h"

// The panel at the side: all parameters, and the sketched controls.

namespace penpose::app {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool contains(std::string_view name, std::string_view part) {
  return std::search(name.begin(), name.end(), part.begin(), part.end(),
                     [](char a, char b) { return lower(a) == lower(b); }) != name.end();
}

/// The first word of a name ("browInner_L": "brow"), by which parameters are grouped.
std::string first_word(std::string_view name) {
  std::size_t end = 0;
  while (end < name.size() && name[end] >= 'a' && name[end] <= 'z') ++end;
  return end > 1 ? std::string(name.substr(0, end)) : std::string();
}

/// A name in a format of printf.
std::string escaped(std::string_view name) {
  std::string out;
  for (const char c : name) out += c == '%' ? std::string("%%") : std::string(1, c);
  return out;
}

/// A slider as high as a target; true while it is moved, `released` when it is let go.
bool tall_slider(PanelContext& context, const char* id, double& value, double least, double most, float width,
                 const std::string& name, bool& released) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {8, 0.5F * (context.unit - ImGui::GetFontSize())});
  ImGui::PushStyleVar(ImGuiStyleVar_GrabMinSize, 0.5F * context.unit);
  ImGui::SetNextItemWidth(width);
  const std::string format = escaped(name) + "  %.2f";
  const bool moved =
      ImGui::SliderScalar(id, ImGuiDataType_Double, &value, &least, &most, format.c_str(), ImGuiSliderFlags_NoInput);
  released = ImGui::IsItemDeactivatedAfterEdit();
  ImGui::PopStyleVar(2);
  note(context, (std::string("slider ") + name).c_str());
  return moved;
}

void parameter_row(PanelContext& context, std::size_t index) {
  App& app = context.app;
  const document::Document& document = app.workspace().document();
  const rig::Parameter& parameter = document.model->rig->parameters()[index];
  const rig::Pose& shown = app.workspace().shown_pose();
  // While a control is sketched another model may be shown, with another number of parameters.
  double value = index < shown.size() ? shown[index] : document.pose[index];
  const bool locked = std::binary_search(document.locked.begin(), document.locked.end(), parameter.name);
  ImGui::PushID(static_cast<int>(index));
  if (wide_button(
          context, locked ? "L##lock" : "-##lock", context.unit, locked,
          locked ? "Locked: no stroke moves it. Touch to free it" : "Touch to lock it: no stroke will move it")) {
    app.workspace().perform(document::LockParameters{{parameter.name}, !locked});
  }
  ImGui::SameLine();
  bool released = false;
  const float width = ImGui::GetContentRegionAvail().x - context.unit - context.gap;
  if (tall_slider(context, "##value", value, parameter.minimum, parameter.maximum, width, parameter.name, released)) {
    app.preview_parameter(index, value);
  }
  if (released) app.set_parameter(index, value);
  ImGui::SameLine();
  if (wide_button(context, "0##reset", context.unit, false, "Back to rest")) {
    app.workspace().perform(document::ResetParameters{{parameter.name}});
  }
  ImGui::PopID();
}

void show_step_list(PanelContext& context, const document::PendingSketch& pending, const drawing::Tool& tool) {
  struct Step {
    const char* text;
    articulation::CurveRole role;
    bool done;
  };
  const articulation::Sketch& sketch = pending.sketch;
  const auto next = drawing::next_step(context.app.workspace().document(), tool);
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
                       now         ? ">"
                       : step.done ? "x"
                                   : " ",
                       step.text);
  }
}

bool mode_buttons(PanelContext& context, articulation::Mode now, articulation::Mode& chosen) {
  constexpr std::pair<articulation::Mode, const char*> k_modes[] = {{articulation::Mode::automatic, "Auto"},
                                                                    {articulation::Mode::translate, "Slide"},
                                                                    {articulation::Mode::rotate, "Turn"}};
  bool pressed = false;
  const float width = (ImGui::GetContentRegionAvail().x - 2 * context.gap) / 3;
  for (const auto& [mode, label] : k_modes) {
    if (mode != articulation::Mode::automatic) ImGui::SameLine();
    if (wide_button(context, label, width, now == mode,
                    "How the feature goes from where it is to where it was drawn")) {
      chosen = mode;
      pressed = true;
    }
  }
  return pressed;
}

void show_pending(PanelContext& context) {
  App& app = context.app;
  Workspace& workspace = app.workspace();
  const auto pending = workspace.document().pending;
  drawing::Tool tool = workspace.editor().tool();
  if (!pending) {
    if (wide_button(context, "New control", -1, false, "Sketch a control in three or four strokes")) {
      app.do_action(Action::tool_articulate);
    }
    return;
  }
  ImGui::Text("Sketching %s", pending->sketch.name.c_str());
  show_step_list(context, *pending, tool);
  if (wide_button(context, tool.draw_reference ? "Find the feature by itself" : "Draw the feature myself", -1)) {
    tool.kind = drawing::ToolKind::articulate;
    tool.draw_reference = !tool.draw_reference;
    workspace.set_tool(tool);
  }
  double amount = workspace.sketch().amount();
  bool released = false;
  if (tall_slider(context, "##amount", amount, 0, 1, ImGui::GetContentRegionAvail().x, "shown while drawing",
                  released)) {
    workspace.sketch().set_amount(amount);
  }
  if (wide_button(context, "Give up", -1, false, "Forget the strokes of this control (Esc)")) {
    workspace.perform(document::CancelDeformer{});
  }
}

void show_chosen(PanelContext& context, const articulation::Deformer& deformer) {
  App& app = context.app;
  Workspace& workspace = app.workspace();
  const std::string name = deformer.sketch().name;
  const auto index = rig::find_parameter(workspace.document().model->rig->parameters(), name);
  if (index) {
    bool released = false;
    const rig::Parameter& parameter = workspace.document().model->rig->parameters()[*index];
    const auto& shown = workspace.shown_pose();
    double value = *index < shown.size() ? shown[*index] : 0;
    if (tall_slider(context, "##play", value, parameter.minimum, parameter.maximum, ImGui::GetContentRegionAvail().x,
                    name, released)) {
      app.preview_parameter(*index, value);
    }
    if (released) app.set_parameter(*index, value);
  }
  const float field = ImGui::GetContentRegionAvail().x - 3 * context.unit - context.gap;
  text_field(context, "##rename", app.panels().rename, field, "another name");
  ImGui::SameLine();
  if (wide_button(context, "Rename", 3 * context.unit) && !app.panels().rename.empty()) {
    const std::string to = std::exchange(app.panels().rename, {});
    if (workspace.perform(document::RenameDeformer{name, to})) app.panels().deformer = to;
    return;
  }
  articulation::Mode mode = deformer.sketch().mode;
  if (mode_buttons(context, mode, mode)) {
    document::ChangeDeformer change;
    change.deformer = name;
    change.mode = mode;
    workspace.perform(change);
  }
  const float half = 0.5F * (ImGui::GetContentRegionAvail().x - context.gap);
  if (wide_button(context, "Mirror", half, false, "Make the same control on the other side of the face")) {
    workspace.perform(document::MirrorDeformer{name});
  }
  ImGui::SameLine();
  if (wide_button(context, "Remove", half, false, "Delete this control")) {
    workspace.perform(document::DeleteDeformer{name});
    app.panels().deformer.clear();
  }
  struct Redraw {
    const char* label;
    articulation::CurveRole role;
  };
  constexpr Redraw k_redraws[] = {{"Redraw feature", articulation::CurveRole::reference},
                                  {"Redraw goal", articulation::CurveRole::target}};
  for (const Redraw& one : k_redraws) {
    const drawing::Tool& tool = workspace.editor().tool();
    const bool chosen = tool.kind == drawing::ToolKind::redraw && tool.deformer == name && tool.role == one.role;
    if (one.role == articulation::CurveRole::target) ImGui::SameLine();
    if (wide_button(context, one.label, half, chosen, "The next stroke draws this curve of the control again")) {
      drawing::Tool redraw;
      redraw.kind = drawing::ToolKind::redraw;
      redraw.deformer = name;
      redraw.role = one.role;
      workspace.set_tool(redraw);
    }
  }
  if (ImGui::GetContentRegionAvail().x <= 0) return;
  const bool slides = !std::holds_alternative<std::monostate>(deformer.sketch().surface);
  const char* over = "over nothing";
  if (const auto* part = std::get_if<articulation::PartSurface>(&deformer.sketch().surface)) over = part->part.c_str();
  if (std::holds_alternative<articulation::Sphere>(deformer.sketch().surface)) over = "over a ball";
  if (wide_button(context, (std::string("Slides: ") + over + "##surface").c_str(), -1, slides,
                  "The part that it keeps its distance from, as a lid does from the eye")) {
    ImGui::OpenPopup("surface");
  }
  if (ImGui::BeginPopup("surface")) {
    app.hits().all = true;
    const auto choose = [&](articulation::Surface surface) {
      document::ChangeDeformer change;
      change.deformer = name;
      change.surface = std::move(surface);
      workspace.perform(change);
      ImGui::CloseCurrentPopup();
    };
    if (wide_button(context, "nothing", 7 * context.unit)) choose({});
    for (const auto& part : workspace.document().model->mesh->parts()) {
      if (!part.name.empty() && wide_button(context, part.name.c_str(), 7 * context.unit)) {
        choose(articulation::PartSurface{part.name});
        break;
      }
    }
    ImGui::EndPopup();
  }
}

}  // namespace

void show_parameters(PanelContext& context) {
  App& app = context.app;
  text_field(context, "##search", app.panels().filter, ImGui::GetContentRegionAvail().x - context.unit - context.gap,
             "search");
  ImGui::SameLine();
  if (wide_button(context, "x##clear", context.unit, false, "Show all")) app.panels().filter.clear();
  ImGui::BeginChild("list");
  const auto parameters = app.workspace().document().model->rig->parameters();
  // The order is kept; a group is a run of one first word.
  std::string group;
  bool open = true;
  constexpr std::size_t k_many = 16;
  for (std::size_t i = 0; i < app.workspace().document().model->rig->parameters().size(); ++i) {
    // A row may perform a command that makes another rig.
    const auto now = app.workspace().document().model->rig->parameters();
    if (i >= now.size()) break;
    if (!app.panels().filter.empty()) {
      if (contains(now[i].name, app.panels().filter)) parameter_row(context, i);
      continue;
    }
    const std::string word = first_word(now[i].name);
    if (now.size() > k_many && word != group && !word.empty()) {
      group = word;
      ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {8, 0.5F * (context.unit - ImGui::GetFontSize())});
      open = ImGui::CollapsingHeader((group + "##" + std::to_string(i)).c_str(), ImGuiTreeNodeFlags_DefaultOpen);
      ImGui::PopStyleVar();
    }
    if (open) parameter_row(context, i);
  }
  if (parameters.empty()) {
    ImGui::TextWrapped("This model has nothing to pose yet. Take the tool Rig and sketch a control.");
  }
  ImGui::EndChild();
}

void show_deformers(PanelContext& context) {
  App& app = context.app;
  show_pending(context);
  const auto deformers = app.workspace().document().model->deformers;
  if (!deformers) return;
  ImGui::Dummy({1, context.gap});
  const bool chosen = articulation::find_deformer(*deformers, app.panels().deformer).has_value();
  const float below = chosen ? 7.4F * context.unit : 0;
  const float list_height = std::max(3 * context.unit, ImGui::GetContentRegionAvail().y - below);
  ImGui::BeginChild("controls", {0, list_height});
  for (const auto& deformer : deformers->deformers()) {
    const std::string& name = deformer->sketch().name;
    if (wide_button(context, name.c_str(), -1, name == app.panels().deformer)) {
      app.panels().deformer = name == app.panels().deformer ? std::string() : name;
    }
    if (name == app.panels().deformer && name != app.panels().scrolled_to) ImGui::SetScrollHereY();
  }
  ImGui::EndChild();
  app.panels().scrolled_to = app.panels().deformer;
  for (const auto& deformer : deformers->deformers()) {
    if (deformer->sketch().name != app.panels().deformer) continue;
    show_chosen(context, *deformer);
    break;
  }
}

void show_side_panel(PanelContext& context, const Area& area) {
  App& app = context.app;
  if (begin_panel(context, "side", area)) {
    const float half = 0.5F * (ImGui::GetContentRegionAvail().x - context.gap);
    if (wide_button(context, "Parameters", half, !app.panels().controls_tab)) app.panels().controls_tab = false;
    ImGui::SameLine();
    if (wide_button(context, "Controls", half, app.panels().controls_tab)) app.panels().controls_tab = true;
    if (app.panels().controls_tab) {
      show_deformers(context);
    } else {
      show_parameters(context);
    }
  }
  end_panel();
}

}  // namespace penpose::app
