#include <algorithm>
#include <array>

#include "firmware_io/decode/hand/pressure_curve.h"
#include "ui/app/dialogs/dialogs.h"
#include "ui/app/dialogs/entries.h"
#include "ui/app/hands/bindings.h"
#include "ui/app/panels/panels.h"
#include "ui/app/preferences.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"
#include "ui/app/widgets/pad_picture.h"

namespace penpose::app {
namespace {

/// What is shown and changed here.
struct TabletDialogOwners {
  Dialogs& dialogs;
};

decode::PressureCurve curve_of(const replay::TabletSetting& setting) {
  std::vector<decode::PressureCurve::Point> points;
  for (const auto& p : setting.pressure) points.push_back({p.x, p.y});
  auto made = decode::PressureCurve::make(std::move(points));
  return made ? std::move(made).value() : decode::PressureCurve();
}

/// Hard pressed to the right, meant upwards, with the pen's last pressure as it is meant.
void show_pressure(const TabletDialogOwners& with, const replay::TabletSetting& setting, ImVec2 from, ImVec2 size) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(from, {from.x + size.x, from.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg), scaled(4));
  const decode::PressureCurve curve = curve_of(setting);
  const auto place = [&](double pressed, double meant) {
    return ImVec2{from.x + static_cast<float>(pressed) * size.x, from.y + size.y - static_cast<float>(meant) * size.y};
  };
  constexpr int k_steps = 32;
  for (int i = 0; i < k_steps; ++i) {
    const double a = static_cast<double>(i) / k_steps;
    const double b = static_cast<double>(i + 1) / k_steps;
    list.AddLine(place(a, curve(a)), place(b, curve(b)), ImGui::GetColorU32(ImGuiCol_PlotLines), scaled(2));
  }
  const auto& pressure = with.dialogs.state<PenTrial>().pressure;
  if (pressure.empty()) return;
  const ImVec2 end = place(1, pressure.back());
  list.AddLine({from.x, end.y}, end, ImGui::GetColorU32(ImGuiCol_ButtonActive), scaled(2));
}

/// A place to draw in: the line appears under the pen, as thick as it is pressed.
void test_area(PanelContext& context, const TabletDialogOwners& with, const replay::TabletSetting& setting) {
  ImGui::TextDisabled("Draw here to try it; the curve maps pressure");
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float height = 4.5F * context.unit;
  const ImVec2 size{ImGui::GetContentRegionAvail().x - height - context.gap, height};
  ImGui::InvisibleButton("try", size);
  note(context, "try");
  const Area area{from.x, from.y, from.x + size.x, from.y + size.y};
  with.dialogs.state<PenTrial>().area = area;
  // A line is drawn here, whichever way it goes.
  context.scrolls.push_back({area});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 to{from.x + size.x, from.y + size.y};
  list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg), scaled(4));
  list.PushClipRect(from, to, true);
  const auto& line = with.dialogs.state<PenTrial>().line;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const auto place = [](PxPoint p) { return ImVec2{static_cast<float>(p.x), static_cast<float>(p.y)}; };
    list.AddLine(place(line[i - 1]), place(line[i]), ImGui::GetColorU32(ImGuiCol_PlotLines),
                 1 + 8 * static_cast<float>(with.dialogs.state<PenTrial>().pressure[i]));
  }
  list.PopClipRect();
  show_pressure(with, setting, {to.x + context.gap, from.y}, {height, height});
  ImGui::Dummy({1, context.gap});
}

}  // namespace

void try_pen(Dialogs& dialogs, PxPoint at, double pressure, bool begins) {
  if (dialogs.open() != Dialog::tablet) return;
  constexpr std::size_t k_most = 100000;
  PenTrial& trial = dialogs.state<PenTrial>();
  if (begins && trial.area.holds(at)) {
    trial.line.clear();
    trial.pressure.clear();
  }
  if (trial.line.size() >= k_most || (trial.line.empty() && !trial.area.holds(at))) return;
  trial.line.push_back(at);
  trial.pressure.push_back(pressure);
}

void show_tablet_dialog(PanelContext& context, HandDesk& desk, Bindings& bindings, Preferences& preferences,
                        Dialogs& dialogs) {
  const TabletDialogOwners with{dialogs};
  replay::TabletSetting& setting = preferences.settings().tablet;
  if (begin_dialog(context, "Tablet", 17)) {
    for (const DeskTablet& tablet : desk.tablets()) show_guess(context, tablet);
    bool changed = false;
    const auto flag = [&](const char* label, bool& on, const char* tip) {
      if (wide_button(context, label, -1, on, tip)) {
        on = !on;
        changed = true;
      }
    };
    flag("Keep the picture's shape", setting.keep_aspect,
         "Use the part of the tablet that has the shape of the window");
    flag("Left-handed", setting.left_handed, "Turn the tablet by 180 degrees");
    // Four slices of the area and the softness of the pressure, each by sliders alone.
    std::array<double, 4> area{0, 0, 1, 1};
    if (setting.area.size() == 4) std::copy(setting.area.begin(), setting.area.end(), area.begin());
    constexpr std::array k_sides{"left", "top", "right", "bottom"};
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {8, 0.5F * (context.unit - ImGui::GetFontSize())});
    for (std::size_t i = 0; i < 4; ++i) {
      const double least = i < 2 ? 0 : area[i - 2] + 0.05;
      const double most = i < 2 ? area[i + 2] - 0.05 : 1;
      ImGui::SetNextItemWidth(-3 * context.unit);
      if (ImGui::SliderScalar(k_sides[i], ImGuiDataType_Double, &area[i], &least, &most, "%.2f",
                              ImGuiSliderFlags_NoInput)) {
        setting.area.assign(area.begin(), area.end());
        changed = true;
      }
      note(context, k_sides[i]);
    }
    // One point in the middle bends the curve: pressed half as hard means this much.
    double half = setting.pressure.size() == 3 ? setting.pressure[1].y : 0.5;
    const double least = 0.05;
    const double most = 0.95;
    ImGui::SetNextItemWidth(-3 * context.unit);
    if (ImGui::SliderScalar("softness", ImGuiDataType_Double, &half, &least, &most, "half pressed means %.2f",
                            ImGuiSliderFlags_NoInput)) {
      setting.pressure = {{0, 0}, {0.5, half}, {1, 1}};
      changed = true;
    }
    note(context, "softness");
    ImGui::PopStyleVar();
    if (changed) bindings.setting_changed();
    test_area(context, with, setting);
    if (wide_button(context, "Reset##tablet")) {
      setting = {};
      bindings.setting_changed();
    }
    ImGui::SameLine();
    if (primary_button(context, "Done") || context.accepts) dialogs.show(Dialog::none);
  }
  end_dialog();
}

}  // namespace penpose::app
