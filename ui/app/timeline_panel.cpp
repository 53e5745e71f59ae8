#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ui/app/panels.h"
#include "ui/app/widgets.h"

namespace penpose::app {
namespace {

constexpr double k_least_range_s = 4;
constexpr double k_snap_s = 1.0 / 24;

/// Moments between keys lie on frames of a film.
double on_frame(double time_s) { return std::round(time_s / k_snap_s) * k_snap_s; }

void show_track(PanelContext& context) {
  App& app = context.app;
  const document::Timeline& timeline = *app.workspace().document().timeline;
  const double last = timeline.keys.empty() ? 0 : timeline.keys.back().time_s;
  const double range = std::max({k_least_range_s, std::ceil(last + 1), std::ceil(app.panels().time_s)});
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const ImVec2 size{std::max(context.unit, ImGui::GetContentRegionAvail().x), context.unit};
  ImGui::InvisibleButton("track", size);
  note(context, "track");
  tooltip("Drag to scrub; the pose at this moment is kept with Key");
  const float inset = 0.3F * context.unit;
  const float width = size.x - 2 * inset;
  const auto x_of = [&](double time_s) { return from.x + inset + static_cast<float>(time_s / range) * width; };
  if (ImGui::IsItemActive()) {
    double time = on_frame(
        std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - from.x - inset) / width), 0.0, 1.0) * range);
    for (const auto& key : timeline.keys) {
      if (std::abs(x_of(key.time_s) - ImGui::GetIO().MousePos.x) < 0.25F * context.unit) time = key.time_s;
    }
    app.scrub(time);
  }
  if (ImGui::IsItemDeactivated()) app.end_scrub();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 ink = ImGui::GetColorU32(ImGuiCol_Text);
  const ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  list.AddRectFilled(from, {from.x + size.x, from.y + size.y}, ImGui::GetColorU32(ImGuiCol_FrameBg), 4);
  const double step = range > 60 ? 10 : range > 20 ? 5 : 1;
  for (double t = 0; t <= range + 1e-9; t += step) {
    list.AddLine({x_of(t), from.y + 0.7F * size.y}, {x_of(t), from.y + size.y}, faint);
    char text[16];
    std::snprintf(text, sizeof text, "%.0f s", t);
    list.AddText({x_of(t) + 3, from.y + size.y - ImGui::GetFontSize()}, faint, text);
  }
  const float middle = from.y + 0.38F * size.y;
  const float half = 0.22F * context.unit;
  for (const auto& key : timeline.keys) {
    const float x = x_of(key.time_s);
    list.AddQuadFilled({x - half, middle}, {x, middle - half}, {x + half, middle}, {x, middle + half},
                       IM_COL32(255, 176, 0, 255));
  }
  const float cursor = x_of(app.panels().time_s);
  list.AddLine({cursor, from.y}, {cursor, from.y + size.y}, ink, 2);
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
