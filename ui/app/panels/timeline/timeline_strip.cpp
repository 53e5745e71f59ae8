#include "ui/app/panels/timeline/timeline_strip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/document/time/timeline.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

constexpr double k_least_range_s = 4, k_least_span_s = 0.5;
constexpr float k_names_units = 4.2F, k_most_names_share = 0.3F;

}  // namespace

ShownMoments shown_moments(const TimelineOwners& with) {
  const double last = with.playback.last_s();
  const double all = std::max({k_least_range_s, std::ceil(last + 1), std::ceil(with.playback.time_s())});
  TimelineShown& shown = with.shown();
  if (shown.span_s <= 0 || shown.span_s >= all) {
    shown.span_s = shown.from_s = 0;
    return {0, all};
  }
  // The cursor is in sight wherever it goes.
  const double now = with.playback.time_s();
  if (std::exchange(shown.seen_time_s, now) != now) {
    if (now < shown.from_s) shown.from_s = now;
    if (now > shown.from_s + shown.span_s) shown.from_s = now - shown.span_s;
  }
  shown.from_s = std::clamp(shown.from_s, 0.0, all - shown.span_s);
  return {shown.from_s, shown.span_s};
}

void zoom_track(const TimelineOwners& with, double factor) {
  const ShownMoments now = shown_moments(with);
  const double span = std::max(k_least_span_s, now.span * factor);
  const double share = std::clamp((with.playback.time_s() - now.from) / now.span, 0.0, 1.0);
  with.shown().span_s = span;
  with.shown().from_s = std::max(0.0, with.playback.time_s() - share * span);
}

void pan_track(const TimelineOwners& with, double share) {
  const ShownMoments now = shown_moments(with);
  with.shown().from_s = std::max(0.0, now.from + share * now.span);
}

float names_width(const PanelContext& context, const TimelineOwners& with) {
  if (with.shown().part == TimelinePart::poses) return 0;
  return std::min(k_names_units * context.unit, k_most_names_share * static_cast<float>(context.window.width));
}

Strip place_strip(const PanelContext& context, const TimelineOwners& with, float height) {
  Strip strip;
  strip.shown = shown_moments(with);
  const float names = names_width(context, with);
  strip.from = ImGui::GetCursorScreenPos();
  strip.from.x += names;
  strip.size = {std::max(context.unit, ImGui::GetContentRegionAvail().x - names), height > 0 ? height : context.unit};
  strip.inset = 0.3F * context.unit;
  return strip;
}

Strip begin_strip(PanelContext& context, const TimelineOwners& with, const char* name, const char* tip, float height) {
  const Strip strip = place_strip(context, with, height);
  ImGui::SetCursorScreenPos(strip.from);
  ImGui::InvisibleButton(name, strip.size);
  note(context, name);
  tooltip(context, tip);
  if (ImGui::IsItemHovered() && ImGui::GetIO().MouseWheel != 0) {
    zoom_track(with, std::pow(0.8, static_cast<double>(ImGui::GetIO().MouseWheel)));
  }
  ImGui::GetWindowDrawList()->AddRectFilled(strip.from, strip.to(), ImGui::GetColorU32(ImGuiCol_FrameBg), scaled(4));
  return strip;
}

int frames_apart(const Strip& strip, int rate, float room) {
  const double px = static_cast<double>(strip.width()) / (strip.shown.span * rate);
  for (const int frames : {1, 2, 5, 10, rate, 2 * rate, 3 * rate, 5 * rate, 10 * rate, 60 * rate, 600 * rate}) {
    if (px * frames >= static_cast<double>(room)) return frames;
  }
  return 3600 * rate;
}

std::string axis_number(double value, double step) {
  const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(step) - 1e-6)), 0, 6);
  std::array<char, 48> text{};
  // No "-0".
  std::snprintf(text.data(), text.size(), "%.*f", decimals, std::abs(value) < 1e-3 * step ? 0.0 : value);
  return text.data();
}

void show_cursor(const Strip& strip, const TimelineOwners& with) {
  const float x = strip.x_of(with.playback.time_s());
  ImGui::GetWindowDrawList()->AddLine({x, strip.from.y}, {x, strip.to().y}, ImGui::GetColorU32(ImGuiCol_ButtonActive),
                                      scaled(2));
}

void draw_key(ImVec2 middle, float half, ImU32 color, bool strong) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 left{middle.x - half, middle.y};
  const ImVec2 top{middle.x, middle.y - half};
  const ImVec2 right{middle.x + half, middle.y};
  const ImVec2 bottom{middle.x, middle.y + half};
  list.AddQuadFilled(left, top, right, bottom, color);
  list.AddQuad(left, top, right, bottom, color_of(palette().key_edge), scaled(strong ? 2.5F : 1));
}

float least_apart(const Strip& strip, float half) { return std::max(1.2F * half, strip.size.x / 150); }

KeyRow::KeyRow(const Strip& strip, float middle_y, float half)
    : strip_(strip), y_(middle_y), apart_(least_apart(strip, half)) {}

KeyRow::~KeyRow() { flush(); }

void KeyRow::add(float x, float half, ImU32 color, bool strong) {
  if (x < strip_.from.x - half || x > strip_.to().x + half) return;
  const bool same = run_.keys > 0 && run_.color == color && run_.strong == strong && std::abs(x - run_.to) < apart_;
  if (!same) {
    flush();
    run_ = {x, x, half, color, strong, 0};
  }
  run_.to = x;
  run_.half = std::max(run_.half, half);
  ++run_.keys;
}

void KeyRow::flush() {
  if (run_.keys == 1) {
    draw_key({run_.from, y_}, run_.half, run_.color, run_.strong);
  } else if (run_.keys > 1) {
    const float high = 0.6F * run_.half;
    ImGui::GetWindowDrawList()->AddRectFilled({run_.from - high, y_ - high}, {run_.to + high, y_ + high}, run_.color);
  }
  run_.keys = 0;
}

}  // namespace penpose::app
