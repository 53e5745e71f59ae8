#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "ui/app/canvas/canvas.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/input/navigation.h"
#include "ui/app/panels/panel_state.h"
#include "ui/app/panels/panels.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

// Which way the model's axes lie, in a corner of the canvas; their ends are buttons to look from there.

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct AxisPanelOwners {
  Dialogs& dialogs;
};

struct Axis {
  const char* label;
  char letter[2];
  const char* tip;
  render::Viewpoint from;
  Rgb color;
};

// The usual three colours: x red, y green, z blue.
constexpr std::array k_axes{
    Axis{"X##axis", "X", "Look from the model's left side", {90, 0}, k_canvas_colors.axis_x},
    Axis{"Y##axis", "Y", "Look from above", {0, 89}, k_canvas_colors.axis_y},
    Axis{"Z##axis", "Z", "Look from the model's front", {0, 0}, k_canvas_colors.axis_z},
};
/// Of a canvas narrower than this, in targets, nothing is taken.
constexpr double k_least_units = 12;
constexpr float k_reach = 1.1F;
constexpr float k_disc = 0.34F;

geometry::ModelVector way_of(const Axis& axis, double front_degrees) {
  if (axis.letter[0] == 'Y') return {0, 1, 0};
  const double yaw = (axis.from.yaw_degrees + front_degrees) * std::numbers::pi / 180;
  return {std::sin(yaw), 0, std::cos(yaw)};
}

/// An end of an axis, which is a button on the canvas itself: panels lie above it.
bool show_end(PanelContext& context, const AxisPanelOwners& with, const Axis& axis, ImVec2 at) {
  const float half = 0.5F * context.unit;
  const Area area{static_cast<double>(at.x - half), static_cast<double>(at.y - half), static_cast<double>(at.x + half),
                  static_cast<double>(at.y + half)};
  context.hits.panels.push_back(area);
  context.targets[axis.label] = area;
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool hovered = area.holds({static_cast<double>(mouse.x), static_cast<double>(mouse.y)}) &&
                       !ImGui::IsWindowHovered(ImGuiHoveredFlags_AnyWindow) && !context.menu_open &&
                       with.dialogs.open() == Dialog::none && !ImGui::IsAnyItemActive();
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddCircleFilled(at, (hovered ? 1.25F : 1.0F) * k_disc * context.unit, color_of(axis.color));
  const ImVec2 size = ImGui::CalcTextSize(axis.letter);
  list.AddText({at.x - 0.5F * size.x, at.y - 0.5F * size.y}, color_of(k_canvas_colors.ink), axis.letter);
  if (hovered) context.tip_waits = true;
  if (hovered && context.tip_due) ImGui::SetTooltip("%s", axis.tip);
  return hovered && ImGui::IsMouseClicked(0);
}

}  // namespace

void show_axes(PanelContext& context, const Area& free, Canvas& canvas, Dialogs& dialogs, PanelState& panels) {
  const AxisPanelOwners with{dialogs};
  const auto camera = geometry::Camera::make(canvas.view().camera, canvas.view().viewport);
  const auto unit = static_cast<double>(context.unit);
  if (!camera || !panels.shown || std::min(free.width(), free.height()) < k_least_units * unit) return;
  const double front = viewpoint_of(canvas.view().camera).yaw_degrees - canvas.looking_from().yaw_degrees;
  const float reach = k_reach * context.unit;
  const float inset = reach + 0.6F * context.unit;
  const ImVec2 middle{static_cast<float>(free.right) - inset, static_cast<float>(free.top) + inset};
  struct Placed {
    const Axis* axis;
    ImVec2 at;
    double near;
  };
  std::array<Placed, k_axes.size()> placed{};
  for (std::size_t i = 0; i < k_axes.size(); ++i) {
    const auto way = way_of(k_axes[i], front);
    const auto x = static_cast<float>(glm::dot(way, camera->right()));
    const auto y = static_cast<float>(glm::dot(way, camera->up()));
    placed[i] = {&k_axes[i], {middle.x + reach * x, middle.y - reach * y}, -glm::dot(way, camera->forward())};
  }
  // What is nearer lies above.
  std::sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) { return a.near < b.near; });
  ImDrawList& lines = *ImGui::GetBackgroundDrawList();
  for (const Placed& one : placed) lines.AddLine(middle, one.at, color_of(one.axis->color), 0.07F * context.unit);
  for (const Placed& one : placed) {
    if (show_end(context, with, *one.axis, one.at)) canvas.look_from(one.axis->from);
  }
}

}  // namespace penpose::app
