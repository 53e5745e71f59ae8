#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "ui/app/panels.h"
#include "ui/app/widgets.h"

namespace penpose::app {
namespace {

constexpr double k_least_range_s = 4;
constexpr double k_least_span_s = 0.5;
constexpr double k_snap_s = 1.0 / 24;

/// Moments between keys lie on frames of a film.
double on_frame(double time_s) { return std::round(time_s / k_snap_s) * k_snap_s; }

/// The moments that the track shows.
struct Shown {
  double from = 0;
  double span = 0;
};

Shown shown_moments(App& app) {
  PanelState& panels = app.panels();
  const document::Timeline& timeline = *app.workspace().document().timeline;
  const double last = timeline.keys.empty() ? 0 : timeline.keys.back().time_s;
  const double all = std::max({k_least_range_s, std::ceil(last + 1), std::ceil(panels.time_s)});
  if (panels.span_s <= 0 || panels.span_s >= all) {
    panels.span_s = panels.from_s = 0;
    return {0, all};
  }
  // The cursor is in sight wherever it goes.
  if (std::exchange(panels.seen_time_s, panels.time_s) != panels.time_s) {
    if (panels.time_s < panels.from_s) panels.from_s = panels.time_s;
    if (panels.time_s > panels.from_s + panels.span_s) panels.from_s = panels.time_s - panels.span_s;
  }
  panels.from_s = std::clamp(panels.from_s, 0.0, all - panels.span_s);
  return {panels.from_s, panels.span_s};
}

/// Shows more or less of the timeline, about its cursor.
void zoom_track(App& app, double factor) {
  PanelState& panels = app.panels();
  const Shown now = shown_moments(app);
  const double span = std::max(k_least_span_s, now.span * factor);
  const double share = std::clamp((panels.time_s - now.from) / now.span, 0.0, 1.0);
  panels.span_s = span;
  panels.from_s = std::max(0.0, panels.time_s - share * span);
}

/// Shows another part of the timeline, by a share of what is shown.
void pan_track(App& app, double share) {
  const Shown now = shown_moments(app);
  app.panels().from_s = std::max(0.0, now.from + share * now.span);
}

/// What the pen does on the track: a key that it takes along, or the cursor. `time_of` and `x_of` map px to moments.
template <typename TimeOf, typename XOf>
void use_track(PanelContext& context, const TimeOf& time_of, const XOf& x_of) {
  App& app = context.app;
  PanelState& panels = app.panels();
  const document::Timeline& timeline = *app.workspace().document().timeline;
  const float x = ImGui::GetIO().MousePos.x;
  if (ImGui::IsItemActivated()) {
    panels.key_drag.reset();
    float nearest = 0.5F * context.unit;
    for (const auto& key : timeline.keys) {
      if (std::abs(x_of(key.time_s) - x) >= nearest) continue;
      nearest = std::abs(x_of(key.time_s) - x);
      panels.key_drag = {key.time_s, key.time_s};
    }
  }
  if (ImGui::IsItemActive()) {
    const double time = on_frame(std::max(0.0, time_of(x)));
    if (panels.key_drag) {
      auto& [from, to] = *panels.key_drag;
      // A touch goes to the key; only a pull takes it along.
      const bool pulled = std::abs(ImGui::GetMouseDragDelta(0, 0).x) > 0.4F * context.unit;
      to = pulled || to != from ? time : from;
      if (to == from) app.scrub(from);
    } else {
      app.scrub(time);
    }
  }
  if (!ImGui::IsItemDeactivated()) return;
  const auto drag = std::exchange(panels.key_drag, std::nullopt);
  if (drag && drag->first != drag->second) {
    app.move_key(drag->first, drag->second);
  } else {
    app.end_scrub();
  }
}

void show_track(PanelContext& context) {
  App& app = context.app;
  const Shown shown = shown_moments(app);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size{std::max(context.unit, ImGui::GetContentRegionAvail().x), context.unit};
  const float inset = 0.3F * context.unit;
  const float width = size.x - 2 * inset;
  const auto x_of = [&](double time_s) {
    return from.x + inset + static_cast<float>((time_s - shown.from) / shown.span) * width;
  };
  const auto time_of = [&](float x) {
    return shown.from + std::clamp(static_cast<double>((x - from.x - inset) / width), -0.02, 1.02) * shown.span;
  };
  ImGui::InvisibleButton("track", size);
  note(context, "track");
  tooltip("Drag to scrub, drag a key to move it; the pose at this moment is kept with Key");
  if (ImGui::IsItemHovered() && ImGui::GetIO().MouseWheel != 0) {
    zoom_track(app, std::pow(0.8, static_cast<double>(ImGui::GetIO().MouseWheel)));
  }
  use_track(context, time_of, x_of);
  const auto held = app.workspace().document().timeline;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
  const ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  const ImVec2 to{from.x + size.x, from.y + size.y};
  list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg), 4);
  list.PushClipRect(from, to, true);
  double step = 0.1;
  for (const double wider : {0.5, 1.0, 5.0, 10.0, 60.0, 600.0, 3600.0}) {
    if (width * step / shown.span < 1.8 * static_cast<double>(context.unit)) step = wider;
  }
  for (double t = std::floor(shown.from / step) * step; t <= shown.from + shown.span + 1e-9; t += step) {
    list.AddLine({x_of(t), from.y + 0.7F * size.y}, {x_of(t), to.y}, faint);
    char text[24];
    std::snprintf(text, sizeof text, step < 1 ? "%.1f s" : "%.0f s", t);
    list.AddText({x_of(t) + 3, to.y - ImGui::GetFontSize()}, faint, text);
  }
  const float middle = from.y + 0.38F * size.y;
  const float half = 0.22F * context.unit;
  for (const auto& key : held->keys) {
    const auto& drag = app.panels().key_drag;
    const float x = x_of(drag && drag->first == key.time_s ? drag->second : key.time_s);
    list.AddQuadFilled({x - half, middle}, {x, middle - half}, {x + half, middle}, {x, middle + half},
                       IM_COL32(255, 176, 0, 255));
    list.AddText({x + half + 2, from.y}, ink, key.name.c_str());
  }
  const float cursor = x_of(app.panels().time_s);
  list.AddLine({cursor, from.y}, {cursor, to.y}, ink, 2);
  list.PopClipRect();
}

}  // namespace

void show_timeline(PanelContext& context, const Area& area) {
  App& app = context.app;
  if (begin_panel(context, "timeline", area)) {
    action_button(context, Action::previous_key, 0, false, "|<");
    ImGui::SameLine();
    action_button(context, Action::play, 2 * context.unit, app.playing(), app.playing() ? "Stop" : "Play");
    ImGui::SameLine();
    action_button(context, Action::next_key, 0, false, ">|");
    ImGui::SameLine();
    action_button(context, Action::key_pose, 2 * context.unit);
    ImGui::SameLine();
    // A button may put another timeline in its place.
    const auto held = app.workspace().document().timeline;
    const document::Timeline& timeline = *held;
    const bool on_key = std::any_of(timeline.keys.begin(), timeline.keys.end(),
                                    [&](const auto& key) { return std::abs(key.time_s - app.panels().time_s) < 1e-9; });
    ImGui::BeginDisabled(!on_key);
    action_button(context, Action::delete_key);
    ImGui::SameLine();
    if (wide_button(context, "Name##key", 0, false, "Give the pose of this key a name")) {
      app.panels().key_name.clear();
      for (const auto& key : timeline.keys) {
        if (std::abs(key.time_s - app.panels().time_s) < 1e-9) app.panels().key_name = key.name;
      }
      app.panels().dialog = Dialog::key_name;
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    const bool smooth = timeline.interpolation == document::KeyInterpolation::smooth;
    if (wide_button(context, smooth ? "Smooth" : "Linear", 2.4F * context.unit, false,
                    "How poses between keys are made")) {
      app.workspace().perform(document::SetKeyInterpolation{smooth ? document::KeyInterpolation::linear
                                                                   : document::KeyInterpolation::smooth});
    }
    ImGui::SameLine();
    action_button(context, Action::onion_skin, 0, app.panels().onion_skin);
    ImGui::SameLine();
    if (wide_button(context, "-##track", context.unit, false, "Show more of the timeline")) zoom_track(app, 1.6);
    ImGui::SameLine();
    if (wide_button(context, "+##track", context.unit, false, "Show less of the timeline, about its cursor")) {
      zoom_track(app, 1 / 1.6);
    }
    ImGui::SameLine();
    ImGui::BeginDisabled(app.panels().span_s <= 0);
    if (wide_button(context, "<##track", context.unit, false, "Show what comes before")) pan_track(app, -0.5);
    ImGui::SameLine();
    if (wide_button(context, ">##track", context.unit, false, "Show what comes after")) pan_track(app, 0.5);
    ImGui::EndDisabled();
    ImGui::SameLine();
    char text[48];
    std::snprintf(text, sizeof text, "%.2f s   %zu keys", app.panels().time_s, timeline.keys.size());
    text_beside(context, text);
    show_track(context);
  }
  end_panel();
}

void show_player(PanelContext& context, const Area& area) {
  auto& player = context.app.player();
  if (!player) return;
  if (begin_panel(context, "player", area)) {
    if (wide_button(context, player->playing() ? "Pause" : "Go on", 2.4F * context.unit))
      player->set_playing(!player->playing());
    for (const auto& [speed, label] :
         {std::pair{0.5, "x1/2"}, std::pair{1.0, "x1"}, std::pair{4.0, "x4"}, std::pair{16.0, "x16"}}) {
      ImGui::SameLine();
      if (wide_button(context, label, 0, player->speed() == speed)) player->set_speed(speed);
    }
    ImGui::SameLine();
    const bool close = wide_button(context, "Close##player");
    ImGui::SameLine();
    ImGui::ProgressBar(static_cast<float>(player->progress()), {-1, context.unit},
                       player->finished() ? "at its end" : "playing a recording");
    if (close) player.reset();
  }
  end_panel();
}

}  // namespace penpose::app
