#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "ui/app/panels/timeline/curve_graph.h"
#include "ui/app/playback/frames.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

/// The control whose values stand at the axis; nothing: no curve is shown.
std::optional<std::size_t> axis_control(const TimelineOwners& with) {
  const auto& chosen = with.shown().chosen;
  for (const KeySelection::Key& key : with.keys.selected().keys()) {
    if (chosen.count(key.second) > 0) return key.second;
  }
  if (chosen.empty()) return std::nullopt;
  return *chosen.begin();
}

/// The least step of 1, 2 or 5 times a power of ten that leaves so many px between two lines.
double step_of_values(const Graph& graph, std::size_t control, float room) {
  const double low = graph.value_of(control, graph.strip.to().y);
  const double high = graph.value_of(control, graph.strip.from.y);
  const double least = (high - low) * static_cast<double>(room / graph.strip.size.y);
  if (!(least > 0) || !std::isfinite(least)) return 0;
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least) return factor * power;
  }
  return 10 * power;
}

/// Lines of the values of a control, from the lowest up.
std::vector<double> values_at_axis(const Graph& graph, std::size_t control, double step) {
  std::vector<double> values;
  if (step <= 0) return values;
  const double low = graph.value_of(control, graph.strip.to().y);
  const double high = graph.value_of(control, graph.strip.from.y);
  for (double n = std::ceil(low / step); n * step <= high && values.size() < 200; n += 1) values.push_back(n * step);
  return values;
}

float value_room() { return 1.7F * ImGui::GetFontSize(); }

/// Calls back with the place of each line of the time axis; the ruler has their frames.
template <typename Each>
void each_frame_line(PanelContext& context, const TimelineOwners& with, const Strip& strip, Each each) {
  const int rate = with.playback.rate();
  const int apart = frames_apart(strip, rate, 1.6F * context.unit);
  const auto first = static_cast<int>(std::ceil(strip.shown.from * rate / apart)) * apart;
  const double last = (strip.shown.from + strip.shown.span) * rate;
  for (int frame = first; frame <= last; frame += apart) each(strip.x_of(time_of_frame(frame, rate)));
}

}  // namespace

void draw_grid(PanelContext& context, const TimelineOwners& with, const Graph& graph) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Strip& strip = graph.strip;
  const auto control = axis_control(with);
  const ImU32 faint = ImGui::GetColorU32(ImGuiCol_Text, 0.08F);
  const auto across = [&](float y, ImU32 color) { list.AddLine({strip.from.x, y}, {strip.to().x, y}, color); };
  if (control) {
    const rig::Parameter& range = graph.parameters[*control];
    for (const double value : values_at_axis(graph, *control, step_of_values(graph, *control, value_room())))
      across(graph.y_of(*control, value), faint);
    // Both ends of its range.
    for (const double value : {range.minimum, range.maximum})
      across(graph.y_of(*control, value), ImGui::GetColorU32(ImGuiCol_Text, 0.22F));
  }
  each_frame_line(context, with, strip, [&](float x) { list.AddLine({x, strip.from.y}, {x, strip.to().y}, faint); });
}

void draw_axis(PanelContext& context, const TimelineOwners& with, const Graph& graph) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Strip& strip = graph.strip;
  const auto control = axis_control(with);
  const ImU32 ground = ImGui::GetColorU32(ImGuiCol_FrameBg, 0.8F);
  ImGui::PushFont(small_font());
  const float high = ImGui::GetFontSize();
  // The name stands where no value does: at the right end.
  const std::string name =
      control ? fitted_text(with.editing.words()[*control].text(), 8 * context.unit) : std::string();
  const float name_wide = name.empty() ? 0 : ImGui::CalcTextSize(name.c_str()).x + scaled(12);
  if (control) {
    const double step = step_of_values(graph, *control, 1.7F * ImGui::GetIO().Fonts->Fonts[0]->FontSize);
    for (const double value : values_at_axis(graph, *control, step)) {
      const float y = graph.y_of(*control, value) - 0.5F * high;
      if (y < strip.from.y || y + high > strip.to().y) continue;
      const std::string number = axis_number(value, step);
      const float wide = ImGui::CalcTextSize(number.c_str()).x;
      list.AddRectFilled({strip.from.x, y}, {strip.from.x + wide + scaled(6), y + high}, ground, scaled(2));
      list.AddText({strip.from.x + scaled(3), y}, ImGui::GetColorU32(ImGuiCol_Text, 0.85F), number.c_str());
      context.targets["axis " + number] = {static_cast<double>(strip.from.x), static_cast<double>(y),
                                           static_cast<double>(strip.from.x + wide + scaled(6)),
                                           static_cast<double>(y + high)};
    }
    const float x = strip.to().x - name_wide + scaled(4);
    list.AddRectFilled({x - scaled(4), strip.from.y}, {strip.to().x, strip.from.y + high + scaled(3)}, ground,
                       scaled(2));
    list.AddText({x, strip.from.y + 1}, curve_color(with, *control), name.c_str());
  }
  ImGui::PopFont();
}

}  // namespace penpose::app
