#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/document/time/timeline_editing.h"
#include "ui/app/panels/timeline/curve_graph.h"
#include "ui/app/panels/timeline/sheet_names.h"
#include "ui/app/panels/timeline/timeline_strip.h"
#include "ui/app/playback/frames.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

constexpr float k_handle_inset_px = 4, k_curve_step_px = 3, k_point_units = 0.17F;
constexpr std::size_t k_curves_at_first = 4;
/// Of more keys handles would hide the curves.
constexpr std::size_t k_most_with_handles = 40;

/// A handle of a key: its end, and the slope that it stands for.
struct Handle {
  KeySelection::Key key;
  bool incoming = false;
  ImVec2 end;
};

std::vector<Handle> handles_of(const TimelineOwners& with, const Graph& graph) {
  std::vector<Handle> handles;
  if (with.keys.selected().size() > k_most_with_handles) return handles;
  const document::Timeline& timeline = *with.editing.document().timeline;
  for (const KeySelection::Key& key : with.keys.selected().keys()) {
    const std::size_t control = key.second;
    if (with.shown().chosen.count(control) == 0) continue;
    const auto place = document::key_at(timeline, key.first);
    if (!place) continue;
    const double value = timeline.keys[*place].pose[control];
    const auto before = *place > 0 ? document::key_before(timeline, control, *place - 1) : std::nullopt;
    const auto after = document::key_after(timeline, control, *place + 1);
    const auto add = [&](bool incoming, double other_s, double slope) {
      // A third of the way, where a Bezier curve has its control point.
      const double at_s = key.first + (other_s - key.first) / 3;
      // One that goes beyond the graph can still be taken at its border.
      const float top = graph.strip.from.y + scaled(k_handle_inset_px);
      const float y = std::clamp(graph.y_of(control, value + slope * (at_s - key.first)), top,
                                 std::max(top, graph.strip.to().y - scaled(k_handle_inset_px)));
      handles.push_back({key, incoming, {graph.strip.x_of(at_s), y}});
    };
    if (before) {
      const auto segment = document::segment_of(timeline, control, *before, *place);
      if (segment.kind == document::KeyKind::smooth || document::has_slopes(segment.kind))
        add(true, segment.from_s, segment.slope_to);
    }
    const document::KeyKind kind = timeline.keys[*place].controls[control].kind;
    if (after && (kind == document::KeyKind::smooth || document::has_slopes(kind)))
      add(false, timeline.keys[*after].time_s, document::segment_of(timeline, control, *place, *after).slope_from);
  }
  return handles;
}

/// The key of a shown curve below the pointer.
std::optional<KeySelection::Key> point_below(const TimelineOwners& with, const Graph& graph, ImVec2 at, float reach) {
  std::optional<KeySelection::Key> hit;
  float nearest = reach;
  for (const document::PoseKey& key : with.editing.document().timeline->keys) {
    const float x = graph.strip.x_of(key.time_s);
    if (std::abs(x - at.x) >= nearest) continue;
    for (const std::size_t control : with.shown().chosen) {
      if (!key.controls.has(control)) continue;
      const float away = std::hypot(x - at.x, graph.y_of(control, key.pose[control]) - at.y);
      if (away >= nearest) continue;
      nearest = away;
      hit = KeySelection::Key{key.time_s, control};
    }
  }
  return hit;
}

void begin_drag(PanelContext& context, const TimelineOwners& with, const Graph& graph, ImVec2 at) {
  KeyDrag& drag = with.shown().drag;
  const ImGuiIO& io = ImGui::GetIO();
  KeySelection& keys = with.keys.selected();
  drag = {};
  drag.from = {at.x, at.y};
  drag.begin_s = graph.strip.time_of(at.x);
  drag.value = graph.share_of(at.y);
  const float reach = 0.4F * context.unit;
  for (const Handle& handle : handles_of(with, graph)) {
    if (std::hypot(handle.end.x - at.x, handle.end.y - at.y) >= reach) continue;
    drag.does = KeyDrag::Does::handles;
    drag.control = handle.key.second;
    drag.key_s = handle.key.first;
    drag.incoming = handle.incoming;
  }
  const auto hit = point_below(with, graph, at, reach);
  if (drag.does == KeyDrag::Does::handles) {
    // A key that lies nearer than its handle is what was meant.
    const auto place = document::key_at(*with.editing.document().timeline, drag.key_s);
    const bool on_key = hit && place && std::hypot(graph.strip.x_of(hit->first) - at.x, 0.0F) < 0.4F * reach;
    if (!on_key) return;
  }
  drag.does = hit ? KeyDrag::Does::moves : KeyDrag::Does::boxes;
  if (!hit) return;
  if (io.KeyShift && keys.has(hit->first, hit->second)) {
    keys.remove(hit->first, hit->second);
  } else {
    if (!io.KeyShift && !keys.has(hit->first, hit->second)) keys.clear();
    keys.add(hit->first, hit->second);
  }
}

/// The slope from a key to the pointer, in units a second.
std::optional<double> slope_to(const Graph& graph, const TimelineOwners& with, const KeyDrag& drag, ImVec2 at) {
  const auto place = document::key_at(*with.editing.document().timeline, drag.key_s);
  if (!place) return std::nullopt;
  const double value = with.editing.document().timeline->keys[*place].pose[drag.control];
  const double frame_s = time_of_frame(1, with.playback.rate());
  double away_s = graph.strip.time_of(at.x) - drag.key_s;
  away_s = drag.incoming ? std::min(away_s, -0.25 * frame_s) : std::max(away_s, 0.25 * frame_s);
  return (graph.value_of(drag.control, at.y) - value) / away_s;
}

void end_drag(const TimelineOwners& with, const Graph& graph, ImVec2 at) {
  const KeyDrag done = std::exchange(with.shown().drag, {});
  const ImGuiIO& io = ImGui::GetIO();
  KeySelection& keys = with.keys.selected();
  const double now_s = graph.strip.time_of(at.x);
  const int rate = with.playback.rate();
  if (done.does == KeyDrag::Does::boxes) {
    if (!io.KeyShift) keys.clear();
    if (!done.pulled) return with.playback.go_to(on_frame(now_s, rate));
    const auto [left, right] = std::minmax(done.from.first, at.x);
    const auto [top, bottom] = std::minmax(done.from.second, at.y);
    for (const document::PoseKey& key : with.editing.document().timeline->keys) {
      const float x = graph.strip.x_of(key.time_s);
      if (x < left || x > right) continue;
      for (const std::size_t control : with.shown().chosen) {
        const float y = graph.y_of(control, key.pose[control]);
        if (key.controls.has(control) && y >= top && y <= bottom) keys.add(key.time_s, control);
      }
    }
    return;
  }
  if (!done.pulled) return;
  if (done.does == KeyDrag::Does::moves) {
    const double by_s = std::max(on_frame(now_s - done.begin_s, rate), -keys.first_s());
    with.keys.shift_selected(by_s, graph.share_of(at.y) - done.value);
  } else if (done.does == KeyDrag::Does::handles) {
    if (const auto slope = slope_to(graph, with, done, at))
      with.keys.pull_handle({done.key_s, done.control}, done.incoming, *slope, io.KeyCtrl);
  }
}

void draw_curves(PanelContext& context, const TimelineOwners& with, const Graph& graph) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const document::Timeline& timeline = *with.editing.document().timeline;
  const KeySelection& selected = with.keys.selected();
  const KeyDrag& drag = with.shown().drag;
  const bool moves = drag.pulled && drag.does == KeyDrag::Does::moves;
  const ImVec2 at = ImGui::GetIO().MousePos;
  std::vector<ImVec2> line;
  // ImGui has room for 65536 corners in all.
  const float step = std::max(k_curve_step_px, graph.strip.size.x / 400);
  const float apart = least_apart(graph.strip, k_point_units * context.unit);
  for (const std::size_t control : with.shown().chosen) {
    line.clear();
    for (float x = graph.strip.from.x; x <= graph.strip.to().x; x += step) {
      const auto value = document::sample(timeline, control, graph.strip.time_of(x));
      if (value) line.push_back({x, graph.y_of(control, *value)});
    }
    list.AddPolyline(line.data(), static_cast<int>(line.size()), curve_color(with, control), 0, scaled(2));
    std::array<float, 2> drawn_x{-1e9F, -1e9F};  // of keys, of those that are selected
    for (const document::PoseKey& key : timeline.keys) {
      if (!key.controls.has(control)) continue;
      const bool chosen = selected.has(key.time_s, control);
      const float x = graph.strip.x_of(key.time_s);
      float& last_x = drawn_x[chosen ? 1 : 0];
      if (x < graph.strip.from.x || x > graph.strip.to().x || x - last_x < apart) continue;
      last_x = x;
      ImVec2 point{x, graph.y_of(control, key.pose[control])};
      if (chosen && moves) {
        point.x =
            graph.strip.x_of(on_frame(key.time_s + graph.strip.time_of(at.x) - drag.begin_s, with.playback.rate()));
        point.y += at.y - drag.from.second;
      }
      draw_key(point, k_point_units * context.unit,
               chosen ? color_of(palette().key_selected) : curve_color(with, control), chosen);
    }
  }
  for (const Handle& handle : handles_of(with, graph)) {
    const auto place = document::key_at(timeline, handle.key.first);
    const ImVec2 from{graph.strip.x_of(handle.key.first),
                      graph.y_of(handle.key.second, timeline.keys[*place].pose[handle.key.second])};
    const bool held = drag.does == KeyDrag::Does::handles && drag.key_s == handle.key.first &&
                      drag.control == handle.key.second && drag.incoming == handle.incoming;
    const ImVec2 end = held && drag.pulled ? at : handle.end;
    list.AddLine(from, end, ImGui::GetColorU32(ImGuiCol_Text, 0.7F), scaled(1.5F));
    list.AddCircleFilled(end, 0.12F * context.unit, ImGui::GetColorU32(ImGuiCol_Text));
    const std::string name =
        std::string(handle.incoming ? "handle before " : "handle after ") + graph.parameters[handle.key.second].name;
    const double reach = 0.3 * static_cast<double>(context.unit);
    context.targets[name] = {static_cast<double>(end.x) - reach, static_cast<double>(end.y) - reach,
                             static_cast<double>(end.x) + reach, static_cast<double>(end.y) + reach};
  }
}

/// How the controls trail that Overlap is about, over their curves as they are.
void draw_trailing(const TimelineOwners& with, const Graph& graph) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::vector<ImVec2> line;
  const float step = std::max(k_curve_step_px, graph.strip.size.x / 400);
  for (const OverlapOffer::Trailing& one : with.overlap.trailing()) {
    const std::size_t control = one.overlap.control;
    if (with.shown().chosen.count(control) == 0) continue;
    line.clear();
    for (float x = graph.strip.from.x; x <= graph.strip.to().x; x += step) {
      const auto value = with.overlap.value_at(control, graph.strip.time_of(x));
      if (value) line.push_back({x, graph.y_of(control, *value)});
    }
    list.AddPolyline(line.data(), static_cast<int>(line.size()), ImGui::GetColorU32(ImGuiCol_Text), 0, scaled(2.5F));
    for (std::size_t k = 0; k < one.keys.times_s.size(); ++k) {
      const ImVec2 at{graph.strip.x_of(one.keys.times_s[k]), graph.y_of(control, one.keys.values[k])};
      if (at.x >= graph.strip.from.x && at.x <= graph.strip.to().x)
        list.AddCircleFilled(at, scaled(4), ImGui::GetColorU32(ImGuiCol_Text), 8);
    }
  }
}

/// At first, the curves of what moves most.
void choose_first(const TimelineOwners& with, std::span<const rig::Parameter> parameters) {
  TimelineShown& shown = with.shown();
  std::erase_if(shown.chosen, [&](std::size_t control) { return control >= parameters.size(); });
  if (!shown.chosen.empty() || shown.drag.does != KeyDrag::Does::nothing) return;
  const auto& keys = with.editing.document().timeline->keys;
  std::vector<std::pair<double, std::size_t>> moves;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    double least = parameters[i].maximum;
    double most = parameters[i].minimum;
    for (const document::PoseKey& key : keys) {
      least = std::min(least, key.pose[i]);
      most = std::max(most, key.pose[i]);
    }
    if (most > least) moves.emplace_back((least - most) / (parameters[i].maximum - parameters[i].minimum), i);
  }
  std::stable_sort(moves.begin(), moves.end());
  for (std::size_t k = 0; k < std::min(moves.size(), k_curves_at_first); ++k) shown.chosen.insert(moves[k].second);
}

}  // namespace

ImU32 curve_color(const TimelineOwners& with, std::size_t control) {
  const auto& colors = palette().curves;
  const auto& chosen = with.shown().chosen;
  const auto before = static_cast<std::size_t>(std::distance(chosen.begin(), chosen.lower_bound(control)));
  return color_of(colors[before % colors.size()]);
}

void show_curve_editor(PanelContext& context, const TimelineOwners& with, float height) {
  const auto held = with.editing.document().model;
  choose_first(with, held->rig->parameters());
  const ImVec2 corner = ImGui::GetCursorPos();
  show_row_names(context, with, rows_of(with), 0.92F * context.unit, height);
  ImGui::SetCursorPos(corner);
  Graph graph{begin_strip(context, with, "curves",
                          "Drag keys, or the handles of a selected one; with Ctrl one handle alone. Touch a control's "
                          "name to show its curve",
                          height),
              held->rig->parameters()};
  const ImVec2 at = ImGui::GetIO().MousePos;
  KeyDrag& drag = with.shown().drag;
  if (ImGui::IsItemActivated()) begin_drag(context, with, graph, at);
  const float away = std::hypot(at.x - drag.from.first, at.y - drag.from.second);
  if (ImGui::IsItemActive() && away > 0.2F * context.unit) drag.pulled = true;
  if (ImGui::IsItemDeactivated()) end_drag(with, graph, at);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(graph.strip.from, graph.strip.to(), true);
  draw_grid(context, with, graph);
  // Curves and keys lie over the numbers of the axis, never below them.
  draw_axis(context, with, graph);
  draw_curves(context, with, graph);
  draw_trailing(with, graph);
  show_cursor(graph.strip, with);
  if (drag.does == KeyDrag::Does::boxes && drag.pulled)
    list.AddRect({drag.from.first, drag.from.second}, at, ImGui::GetColorU32(ImGuiCol_ButtonActive));
  list.PopClipRect();
}

}  // namespace penpose::app
