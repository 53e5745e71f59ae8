#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include "ui/app/panels/timeline/timeline_strip.h"
#include "ui/app/playback/frames.h"
#include "ui/app/playback/marks/bookmark_steps.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

// The ruler: frames by number, bookmarks as flags, and the part that is played with its two ends.

namespace penpose::app {
namespace {

constexpr float k_end_units = 0.95F;       ///< beside an end of what is played, where the pen takes it
constexpr float k_playhead_units = 0.24F;  ///< half of the playhead's handle
constexpr float k_pulled_units = 0.2F;

/// What the pen does on the ruler, from its press to its release.
struct RulerDrag {
  enum class Does : std::uint8_t { nothing, scrubs, begins, ends, spans, bookmarks };
  Does does = Does::nothing;
  float from_x = 0;
  bool pulled = false;
  double mark_s = 0;      ///< of the bookmark in hand
  bool was_here = false;  ///< the cursor stood on it already
};

/// A bookmark as it lies on the ruler.
struct Flag {
  const document::Bookmark* bookmark = nullptr;
  float x = 0, width = 0;  ///< px of its coloured flag, to the right of its moment
  std::string text;
};

std::vector<Flag> flags_of(PanelContext& context, const document::Bookmarks& bookmarks, const Strip& strip) {
  std::vector<Flag> flags;
  const float least = 0.32F * context.unit;
  for (std::size_t i = 0; i < bookmarks.size(); ++i) {
    Flag flag{&bookmarks[i], strip.x_of(bookmarks[i].time_s), least, {}};
    if (flag.x < strip.from.x - 1 || flag.x > strip.to().x) continue;
    // Its name, as far as there is room up to the next one.
    const float end = i + 1 < bookmarks.size() ? strip.x_of(bookmarks[i + 1].time_s) - scaled(3) : strip.to().x;
    if (!bookmarks[i].name.empty() && end - flag.x > context.unit) {
      flag.text = fitted_text(bookmarks[i].name, end - flag.x - scaled(8));
      flag.width = ImGui::CalcTextSize(flag.text.c_str()).x + scaled(8);
    }
    flags.push_back(std::move(flag));
  }
  return flags;
}

/// Px from the top of the ruler that flags take.
float flag_height(const Strip& strip) { return 0.5F * strip.size.y; }

const Flag* flag_below(const std::vector<Flag>& flags, const Strip& strip, ImVec2 at, float reach) {
  const Flag* hit = nullptr;
  if (at.y > strip.from.y + flag_height(strip) + scaled(4)) return hit;
  for (const Flag& flag : flags) {
    if (at.x >= flag.x - 0.15F * reach && at.x <= flag.x + std::max(flag.width, 0.6F * reach)) hit = &flag;
  }
  return hit;
}

/// The end of what is played that the pen would take: outside of it, so that the frames within stay to be scrubbed.
RulerDrag::Does end_below(PanelContext& context, const TimelineOwners& with, const Strip& strip, float x) {
  const LoopRange& loop = with.playback.loop();
  const float reach = k_end_units * context.unit;
  const float head = strip.x_of(with.playback.time_s());
  if (std::abs(head - x) < k_playhead_units * context.unit) return RulerDrag::Does::nothing;
  if (loop.from_s && x <= strip.x_of(*loop.from_s) + 3 && x > strip.x_of(*loop.from_s) - reach)
    return RulerDrag::Does::begins;
  if (loop.to_s && x >= strip.x_of(*loop.to_s) - 3 && x < strip.x_of(*loop.to_s) + reach) return RulerDrag::Does::ends;
  return RulerDrag::Does::nothing;
}

void press_ruler(PanelContext& context, const TimelineOwners& with, const Strip& strip, const std::vector<Flag>& flags,
                 RulerDrag& drag) {
  const ImGuiIO& io = ImGui::GetIO();
  drag = {};
  drag.from_x = io.MousePos.x;
  const Flag* flag = flag_below(flags, strip, io.MousePos, context.unit);
  if (io.KeyShift) {
    drag.does = RulerDrag::Does::spans;
  } else if (flag != nullptr) {
    drag.does = RulerDrag::Does::bookmarks;
    drag.mark_s = flag->bookmark->time_s;
    drag.was_here = bookmark_at(with.editing.document(), with.playback.time_s()) == flag->bookmark;
  } else {
    drag.does = end_below(context, with, strip, io.MousePos.x);
    if (drag.does == RulerDrag::Does::nothing) drag.does = RulerDrag::Does::scrubs;
  }
}

void pull_ruler(const TimelineOwners& with, const Strip& strip, const RulerDrag& drag) {
  const double time_s = on_frame(strip.time_of(ImGui::GetIO().MousePos.x), with.playback.rate());
  LoopRange& loop = with.playback.loop();
  using enum RulerDrag::Does;
  if (drag.does == scrubs) with.playback.scrub(time_s);
  if (!drag.pulled) return;
  if (drag.does == begins) loop.begin_at(time_s);
  if (drag.does == ends) loop.end_at(time_s);
  if (drag.does != spans) return;
  const double begun_s = on_frame(strip.time_of(drag.from_x), with.playback.rate());
  if (begun_s == time_s) return;
  loop.from_s = std::min(begun_s, time_s);
  loop.to_s = std::max(begun_s, time_s);
}

void release_ruler(const TimelineOwners& with, const Strip& strip, const RulerDrag& drag) {
  using enum RulerDrag::Does;
  if (drag.does == scrubs) return with.playback.end_scrub();
  if (drag.does != bookmarks) return;
  const double to_s = on_frame(strip.time_of(ImGui::GetIO().MousePos.x), with.playback.rate());
  const document::Bookmark* mark = bookmark_at(with.editing.document(), drag.mark_s);
  if (mark == nullptr) return;
  if (drag.pulled) {
    if (to_s != drag.mark_s) with.editing.perform(document::MoveBookmark{drag.mark_s, to_s});
  } else if (drag.was_here) {
    edit_bookmark(*mark, with.dialogs);
  } else {
    with.playback.go_to(drag.mark_s);
  }
}

/// The part that is played, where it is not all, with a bracket at each end to take it by.
void draw_range(PanelContext& context, const TimelineOwners& with, const Strip& strip) {
  const LoopRange& loop = with.playback.loop();
  if (!loop.any()) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float from = strip.x_of(loop.begin_s());
  const float to = strip.x_of(loop.end_s(with.playback.last_s()));
  const float wide = 0.3F * context.unit;
  const ImU32 color = ImGui::GetColorU32(ImGuiCol_ButtonActive);
  list.AddRectFilled({from, strip.from.y}, {to, strip.to().y}, ImGui::GetColorU32(ImGuiCol_ButtonActive, 0.25F));
  const auto bracket = [&](float x, float outwards, const char* name) {
    list.AddLine({x, strip.from.y}, {x, strip.to().y}, color, scaled(2));
    const float top = strip.from.y + 0.42F * strip.size.y;
    list.AddQuadFilled({x, top}, {x + outwards, top + 0.25F * strip.size.y}, {x + outwards, strip.to().y},
                       {x, strip.to().y}, color);
    const double reach = static_cast<double>(k_end_units * context.unit);
    const auto at = static_cast<double>(x);
    context.targets[name] = {outwards < 0 ? at - reach : at, static_cast<double>(strip.from.y),
                             outwards < 0 ? at : at + reach, static_cast<double>(strip.to().y)};
  };
  if (loop.from_s) bracket(from, -wide, "in point");
  if (loop.to_s) bracket(to, wide, "out point");
}

void draw_numbers(PanelContext& context, const TimelineOwners& with, const Strip& strip) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const int rate = with.playback.rate();
  const ImU32 faint = ImGui::GetColorU32(ImGuiCol_TextDisabled);
  const int apart = frames_apart(strip, rate, 1.3F * context.unit);
  const int marks = frames_apart(strip, rate, 0.2F * context.unit);
  const auto first = static_cast<int>(std::floor(strip.shown.from * rate / apart)) * apart;
  const auto last = static_cast<int>(std::ceil((strip.shown.from + strip.shown.span) * rate));
  for (int frame = first; frame <= last; frame += std::min(marks, apart)) {
    const float x = strip.x_of(time_of_frame(frame, rate));
    const bool numbered = frame % apart == 0;
    list.AddLine({x, strip.from.y + (numbered ? 0.55F : 0.8F) * strip.size.y}, {x, strip.to().y}, faint);
    if (!numbered) continue;
    const std::string number = std::to_string(frame);
    const float wide = ImGui::CalcTextSize(number.c_str()).x;
    const float left = std::min(x - 0.5F * wide, strip.to().x - wide - 1);
    list.AddText({std::max(left, strip.from.x + 1), strip.from.y + scaled(2)}, faint, number.c_str());
  }
}

void draw_flags(PanelContext& context, const Strip& strip, const std::vector<Flag>& flags, const RulerDrag& drag) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const Flag& flag : flags) {
    const bool held = drag.does == RulerDrag::Does::bookmarks && drag.pulled && flag.bookmark->time_s == drag.mark_s;
    const float x = held ? ImGui::GetIO().MousePos.x : flag.x;
    const ImU32 color = bookmark_color(flag.bookmark->color);
    const float foot = strip.from.y + flag_height(strip);
    list.AddLine({x, strip.from.y}, {x, strip.to().y}, color, scaled(2));
    if (flag.text.empty()) {
      list.AddTriangleFilled({x, strip.from.y}, {x + flag.width, 0.5F * (strip.from.y + foot)}, {x, foot}, color);
    } else {
      list.AddRectFilled({x, strip.from.y}, {x + flag.width, foot + 1}, color, scaled(3),
                         ImDrawFlags_RoundCornersRight);
      list.AddText({x + scaled(4), strip.from.y + 0.5F * (foot - strip.from.y - ImGui::GetFontSize())},
                   color_of(palette().panel), flag.text.c_str());
    }
    std::string label = "bookmark ";
    context.targets[label.append(flag.bookmark->name)] = {static_cast<double>(x), static_cast<double>(strip.from.y),
                                                          static_cast<double>(x + flag.width),
                                                          static_cast<double>(foot)};
  }
}

/// The playhead, with a handle to see it by.
void draw_playhead(PanelContext& context, const TimelineOwners& with, const Strip& strip) {
  const float x = strip.x_of(with.playback.time_s());
  const float half = k_playhead_units * context.unit;
  const ImU32 accent = color_of(with.performer.performing() ? palette().record : palette().accent);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddTriangleFilled({x - half, strip.from.y}, {x + half, strip.from.y}, {x, strip.from.y + 1.6F * half}, accent);
  list.AddLine({x, strip.from.y}, {x, strip.to().y}, accent, scaled(2));
}

}  // namespace

ImU32 bookmark_color(std::uint32_t number, float alpha) {
  const auto& colors = palette().curves;
  static_assert(std::tuple_size_v<std::remove_cvref_t<decltype(colors)>> == document::k_bookmark_colors);
  return color_of(colors[number % colors.size()], alpha);
}

void show_ruler(PanelContext& context, const TimelineOwners& with) {
  const Strip strip = begin_strip(
      context, with, "ruler", "Drag to go through time, with Shift to set what is played; the right button has more");
  RulerDrag& drag = with.panels.own.of<RulerDrag>();
  const bool pressed = ImGui::IsItemActivated();
  const bool active = ImGui::IsItemActive();
  const bool released = ImGui::IsItemDeactivated();
  if (ImGui::IsItemHovered() && ImGui::IsMouseClicked(1)) ImGui::OpenPopup("marks menu");
  const auto held = with.editing.document().bookmarks;
  const auto flags = held ? flags_of(context, *held, strip) : std::vector<Flag>();
  if (pressed) press_ruler(context, with, strip, flags, drag);
  if (std::abs(ImGui::GetIO().MousePos.x - drag.from_x) > k_pulled_units * context.unit) drag.pulled = true;
  if (active) pull_ruler(with, strip, drag);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(strip.from, strip.to(), true);
  draw_range(context, with, strip);
  draw_numbers(context, with, strip);
  draw_flags(context, strip, flags, active ? drag : RulerDrag());
  // Where a tour asks to go.
  if (const auto asked = with.tour.active() ? with.tour.asked_time() : std::nullopt) {
    const auto at = static_cast<double>(strip.x_of(*asked));
    const double half_wide = 0.5 * static_cast<double>(context.unit);
    context.targets["tour time"] = {at - half_wide, static_cast<double>(strip.from.y), at + half_wide,
                                    static_cast<double>(strip.to().y)};
  }
  draw_playhead(context, with, strip);
  list.PopClipRect();
  if (released) release_ruler(with, strip, std::exchange(drag, {}));
  show_marks_menu(context, with, "marks menu");
}

}  // namespace penpose::app
