#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/document/time/timeline.h"
#include "ui/app/panels/timeline/sheet_names.h"
#include "ui/app/panels/timeline/timeline_strip.h"
#include "ui/app/playback/frames.h"
#include "ui/app/playback/sheet/sheet_rows.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

constexpr float k_sheet_key_units = 0.2F;

/// The sheet as it lies on the panel.
struct Sheet {
  Strip strip;
  float row_height = 0;
  float first_y = 0;  ///< of the first row, which may be scrolled out of sight
  std::span<const SheetRow> rows;
  [[nodiscard]] float middle_of(std::size_t row) const {
    return first_y + (static_cast<float>(row) + 0.5F) * row_height;
  }
};

/// Where a key is shown while keys are dragged.
double shown_moment(const TimelineOwners& with, const Strip& strip, double time_s, bool selected) {
  const KeyDrag& drag = with.shown().drag;
  if (!selected || !drag.pulled) return time_s;
  const KeySelection& keys = with.keys.selected();
  const double now_s = strip.time_of(ImGui::GetIO().MousePos.x);
  const int rate = with.playback.rate();
  if (drag.does == KeyDrag::Does::moves) return on_frame(time_s + now_s - drag.begin_s, rate);
  const bool to = drag.does == KeyDrag::Does::scales_to;
  if (!to && drag.does != KeyDrag::Does::scales_from) return time_s;
  const auto [about_s, scale] = scaled_selection(keys, now_s, to, rate);
  return on_frame(about_s + (time_s - about_s) * scale, rate);
}

/// The key of a row nearest to the pointer, within reach.
struct HitKey {
  double time_s = 0;
  std::size_t row = 0;
};
std::optional<HitKey> key_below(const TimelineOwners& with, const Sheet& sheet, ImVec2 at, float reach) {
  std::optional<HitKey> hit;
  const auto row = static_cast<std::ptrdiff_t>(std::floor((at.y - sheet.first_y) / sheet.row_height));
  if (row < 0 || row >= static_cast<std::ptrdiff_t>(sheet.rows.size())) return hit;
  float nearest = reach;
  for (const document::PoseKey& key : with.editing.document().timeline->keys) {
    const auto& controls = sheet.rows[static_cast<std::size_t>(row)].controls;
    const float away = std::abs(sheet.strip.x_of(key.time_s) - at.x);
    if (away >= nearest ||
        std::none_of(controls.begin(), controls.end(), [&](std::size_t one) { return key.controls.has(one); }))
      continue;
    nearest = away;
    hit = HitKey{key.time_s, static_cast<std::size_t>(row)};
  }
  return hit;
}

void select_key(const TimelineOwners& with, const Sheet& sheet, const HitKey& hit, bool add) {
  KeySelection& keys = with.keys.selected();
  const auto& controls = sheet.rows[hit.row].controls;
  const auto& timeline = *with.editing.document().timeline;
  const auto key = std::find_if(timeline.keys.begin(), timeline.keys.end(),
                                [&](const document::PoseKey& one) { return one.time_s == hit.time_s; });
  const bool all_in = std::all_of(controls.begin(), controls.end(), [&](std::size_t one) {
    return !key->controls.has(one) || keys.has(hit.time_s, one);
  });
  if (!add && !all_in) keys.clear();
  for (const std::size_t one : controls) {
    if (!key->controls.has(one)) continue;
    if (add && all_in) {
      keys.remove(hit.time_s, one);
    } else {
      keys.add(hit.time_s, one);
    }
  }
}

void select_boxed(const TimelineOwners& with, const Sheet& sheet, ImVec2 a, ImVec2 b, bool add) {
  KeySelection& keys = with.keys.selected();
  if (!add) keys.clear();
  const auto [left, right] = std::minmax(a.x, b.x);
  const auto [top, bottom] = std::minmax(a.y, b.y);
  for (const document::PoseKey& key : with.editing.document().timeline->keys) {
    const float x = sheet.strip.x_of(key.time_s);
    if (x < left || x > right) continue;
    for (std::size_t row = 0; row < sheet.rows.size(); ++row) {
      // A folded group stands for its controls; an open one does not, they are below it.
      const bool stands = !sheet.rows[row].group || sheet.rows[row].folded;
      if (!stands || sheet.middle_of(row) < top || sheet.middle_of(row) > bottom) continue;
      for (const std::size_t one : sheet.rows[row].controls) {
        if (key.controls.has(one)) keys.add(key.time_s, one);
      }
    }
  }
}

/// What the pen does on the rows.
void use_sheet(PanelContext& context, const TimelineOwners& with, const Sheet& sheet) {
  KeyDrag& drag = with.shown().drag;
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 at = io.MousePos;
  if (ImGui::IsItemActivated()) {
    drag = {};
    drag.from = {at.x, at.y};
    drag.begin_s = sheet.strip.time_of(at.x);
    if (const auto end = selection_end_below(context, with, sheet.strip, at)) {
      drag.does = *end ? KeyDrag::Does::scales_to : KeyDrag::Does::scales_from;
    } else if (const auto hit = key_below(with, sheet, at, 0.5F * context.unit)) {
      drag.does = KeyDrag::Does::moves;
      select_key(with, sheet, *hit, io.KeyShift);
    } else {
      drag.does = KeyDrag::Does::boxes;
    }
  }
  const float away = std::hypot(at.x - drag.from.first, at.y - drag.from.second);
  if (ImGui::IsItemActive() && away > 0.3F * context.unit) drag.pulled = true;
  if (!ImGui::IsItemDeactivated()) return;
  const KeyDrag done = std::exchange(drag, {});
  const double now_s = sheet.strip.time_of(at.x);
  const int rate = with.playback.rate();
  if (done.does == KeyDrag::Does::boxes) {
    if (done.pulled) {
      select_boxed(with, sheet, {done.from.first, done.from.second}, at, io.KeyShift);
    } else {
      with.keys.selected().clear();
      with.playback.go_to(on_frame(now_s, rate));
    }
    return;
  }
  if (!done.pulled) return;
  if (done.does == KeyDrag::Does::moves) {
    const double by_s = on_frame(now_s - done.begin_s, rate);
    if (by_s != 0) with.keys.move_selected(std::max(by_s, -with.keys.selected().first_s()), 0, 1, io.KeyCtrl);
    return;
  }
  const auto [about_s, scale] =
      scaled_selection(with.keys.selected(), now_s, done.does == KeyDrag::Does::scales_to, rate);
  if (scale > 0 && scale != 1) with.keys.move_selected(0, about_s, scale, false);
}

void draw_rows(PanelContext& context, const TimelineOwners& with, const Sheet& sheet) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto& timeline = *with.editing.document().timeline;
  const KeySelection& selected = with.keys.selected();
  const float half = k_sheet_key_units * context.unit;
  for (std::size_t row = 0; row < sheet.rows.size(); ++row) {
    const float y = sheet.middle_of(row);
    if (y + sheet.row_height < sheet.strip.from.y || y - sheet.row_height > sheet.strip.to().y) continue;
    const SheetRow& one = sheet.rows[row];
    if (one.group) {
      list.AddRectFilled({sheet.strip.from.x, y - 0.5F * sheet.row_height},
                         {sheet.strip.to().x, y + 0.5F * sheet.row_height}, ImGui::GetColorU32(ImGuiCol_Text, 0.06F));
    }
    KeyRow keys(sheet.strip, y, half);
    for (const document::PoseKey& key : timeline.keys) {
      const bool may_be_chosen =
          !selected.empty() && key.time_s >= selected.first_s() && key.time_s <= selected.last_s();
      const float x = sheet.strip.x_of(key.time_s);
      const bool outside = x < sheet.strip.from.x - half || x > sheet.strip.to().x + half;
      if (outside && !may_be_chosen) continue;
      const auto any = [&](auto has) { return std::any_of(one.controls.begin(), one.controls.end(), has); };
      if (!any([&](std::size_t control) { return key.controls.has(control); })) continue;
      const bool chosen = may_be_chosen && any([&](std::size_t control) { return selected.has(key.time_s, control); });
      keys.add(chosen ? sheet.strip.x_of(shown_moment(with, sheet.strip, key.time_s, true)) : x, half,
               chosen      ? color_of(palette().key_selected)
               : one.group ? color_of(palette().key_group)
                           : color_of(palette().key),
               chosen);
    }
  }
}

}  // namespace

void show_dope_sheet(PanelContext& context, const TimelineOwners& with, float height) {
  Sheet sheet;
  sheet.rows = rows_of(with);
  sheet.row_height = 0.92F * context.unit;
  const float most = std::max(0.0F, static_cast<float>(sheet.rows.size()) * sheet.row_height - height);
  with.shown().scrolled = std::clamp(with.shown().scrolled, 0.0F, most);
  const ImVec2 corner = ImGui::GetCursorPos();
  show_row_names(context, with, sheet.rows, sheet.row_height, height);
  ImGui::SetCursorPos(corner);
  sheet.strip = begin_strip(context, with, "sheet",
                            "Touch a key to select it, drag to select many; drag those to move them, with Ctrl copies; "
                            "the ends of the bar scale them in time",
                            height);
  sheet.first_y = sheet.strip.from.y - with.shown().scrolled;
  use_sheet(context, with, sheet);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(sheet.strip.from, sheet.strip.to(), true);
  show_cursor(sheet.strip, with);
  draw_rows(context, with, sheet);
  show_selection_bar(context, with, sheet.strip);
  const KeyDrag& drag = with.shown().drag;
  if (drag.does == KeyDrag::Does::boxes && drag.pulled) {
    const ImVec2 from{drag.from.first, drag.from.second};
    list.AddRectFilled(from, ImGui::GetIO().MousePos, ImGui::GetColorU32(ImGuiCol_ButtonActive, 0.2F));
    list.AddRect(from, ImGui::GetIO().MousePos, ImGui::GetColorU32(ImGuiCol_ButtonActive));
  }
  if (sheet.rows.empty()) {
    list.AddText({sheet.strip.from.x + sheet.strip.inset, sheet.strip.from.y + 0.3F * context.unit},
                 ImGui::GetColorU32(ImGuiCol_TextDisabled), "Nothing is keyed yet: pose the face, then press Key");
  }
  list.PopClipRect();
}

}  // namespace penpose::app
