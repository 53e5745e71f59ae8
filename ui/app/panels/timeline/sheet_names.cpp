#include "ui/app/panels/timeline/sheet_names.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "ui/app/controls/control_parts.h"
#include "ui/app/playback/frames.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

constexpr std::size_t k_most_curves = 16;
constexpr float k_bar_units = 0.16F, k_bar_end_units = 0.35F;

/// The rows as of the last timeline, of which each frame would look at every key.
struct KnownRows {
  std::shared_ptr<const document::Timeline> timeline;
  std::shared_ptr<const rig::CharacterRig> rig;
  std::set<std::string> folded;
  bool all = false;
  std::vector<SheetRow> rows;
};

/// The colour of its curve stands before its name.
bool draws_curve(const TimelineOwners& with, const SheetRow& row) {
  return with.shown().part == TimelinePart::curves && !row.group && with.shown().chosen.count(row.controls.front()) > 0;
}

void touch_row(const TimelineOwners& with, const SheetRow& row) {
  TimelineShown& shown = with.shown();
  if (row.group && ImGui::GetIO().KeyShift && shown.part == TimelinePart::sheet) {
    for (const document::PoseKey& key : with.editing.document().timeline->keys) {
      for (const std::size_t control : row.controls) {
        if (key.controls.has(control)) with.keys.selected().add(key.time_s, control);
      }
    }
    return;
  }
  if (row.group) {
    if (shown.folded.erase(row.name) == 0) shown.folded.insert(row.name);
    return;
  }
  const std::size_t control = row.controls.front();
  if (shown.part == TimelinePart::curves) {
    if (shown.chosen.erase(control) > 0) return;
    if (shown.chosen.size() >= k_most_curves)
      return with.notices.tell("too many curves to tell apart: hide one first by touching its name");
    shown.chosen.insert(control);
    return;
  }
  KeySelection& keys = with.keys.selected();
  if (!ImGui::GetIO().KeyShift) keys.clear();
  for (const document::PoseKey& key : with.editing.document().timeline->keys) {
    if (key.controls.has(control)) keys.add(key.time_s, control);
  }
}

}  // namespace

const std::vector<SheetRow>& rows_of(const TimelineOwners& with) {
  const document::Document& document = with.editing.document();
  const auto& parts = with.panels.own.of<ControlParts>().of(document, with.editing.features());
  KnownRows& known = with.panels.own.of<KnownRows>();
  const TimelineShown& shown = with.shown();
  if (known.timeline != document.timeline || known.rig != document.model->rig || known.folded != shown.folded ||
      known.all != shown.all_rows) {
    known = {document.timeline, document.model->rig, shown.folded, shown.all_rows, {}};
    known.rows = sheet_rows(document, parts, with.editing.words(), shown.folded, shown.all_rows);
  }
  return known.rows;
}

void show_row_names(PanelContext& context, const TimelineOwners& with, std::span<const SheetRow> rows, float row_height,
                    float height) {
  const float width = names_width(context, with) - context.gap;
  ImGui::BeginChild("row names", {width, height}, false,
                    ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  TimelineShown& shown = with.shown();
  const ImVec2 from = ImGui::GetCursorScreenPos();
  ImGui::InvisibleButton("##names", {width, height});
  if (ImGui::IsItemHovered()) shown.scrolled -= ImGui::GetIO().MouseWheel * row_height;
  const ImVec2 at = ImGui::GetIO().MousePos;
  if (ImGui::IsItemActivated()) {
    shown.drag = {};
    shown.drag.from = {at.x, at.y};
    shown.drag.value = static_cast<double>(shown.scrolled);
  }
  if (ImGui::IsItemActive()) {
    if (std::abs(at.y - shown.drag.from.second) > 0.3F * context.unit) shown.drag.pulled = true;
    if (shown.drag.pulled) shown.scrolled = static_cast<float>(shown.drag.value) + shown.drag.from.second - at.y;
  }
  const float most = std::max(0.0F, static_cast<float>(rows.size()) * row_height - height);
  shown.scrolled = std::clamp(shown.scrolled, 0.0F, most);
  const bool touched = ImGui::IsItemDeactivated() && !shown.drag.pulled;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  std::optional<std::size_t> pointed;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SheetRow& row = rows[i];
    const float top = from.y - shown.scrolled + static_cast<float>(i) * row_height;
    if (top + row_height <= from.y || top >= from.y + height) continue;
    const Area area{static_cast<double>(from.x), static_cast<double>(std::max(from.y, top)),
                    static_cast<double>(from.x + width),
                    static_cast<double>(std::min(from.y + height, top + row_height))};
    context.targets[(row.group ? "group " : "row ") + row.name] = area;
    if (!row.group && at.y >= top && at.y < top + row_height) pointed = row.controls.front();
    if (touched && at.y >= top && at.y < top + row_height) touch_row(with, row);
    const float y = top + 0.5F * (row_height - ImGui::GetFontSize());
    float x = from.x + (row.group ? 0 : 0.5F * context.unit);
    if (row.group) {
      const float half = 0.16F * context.unit;
      const ImVec2 middle{x + 1.4F * half, top + 0.5F * row_height};
      if (row.folded) {
        list.AddTriangleFilled({middle.x - half, middle.y - half}, {middle.x + half, middle.y},
                               {middle.x - half, middle.y + half}, ImGui::GetColorU32(ImGuiCol_Text));
      } else {
        list.AddTriangleFilled({middle.x - half, middle.y - half}, {middle.x + half, middle.y - half},
                               {middle.x, middle.y + half}, ImGui::GetColorU32(ImGuiCol_Text));
      }
      x += 3 * half;
    }
    if (draws_curve(with, row)) {
      const float side = 0.5F * ImGui::GetFontSize();
      const float above = top + 0.5F * (row_height - side);
      list.AddRectFilled({x, above}, {x + side, above + side}, curve_color(with, row.controls.front()), scaled(2));
      x += side + context.gap;
    }
    list.AddText({x, y}, ImGui::GetColorU32(ImGuiCol_Text), fitted_name(row.shown, from.x + width - x).c_str());
  }
  if (pointed) {
    const auto parameters = with.editing.document().model->rig->parameters();
    const document::ControlWords& words = with.editing.words()[*pointed];
    // The names have little room.
    tooltip(context, (words.text() + "\n" + tip_of_control(words, parameters[*pointed].name)).c_str());
  }
  ImGui::EndChild();
}

void show_selection_bar(PanelContext& context, const TimelineOwners& with, const Strip& strip) {
  const KeySelection& keys = with.keys.selected();
  if (keys.empty() || keys.first_s() == keys.last_s()) return;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float from = strip.x_of(keys.first_s());
  const float to = strip.x_of(keys.last_s());
  const float height = k_bar_units * context.unit;
  const float end = k_bar_end_units * context.unit;
  const ImU32 color = ImGui::GetColorU32(ImGuiCol_ButtonActive);
  list.AddRectFilled({from, strip.from.y}, {to, strip.from.y + height}, color);
  list.AddRectFilled({from - scaled(3), strip.from.y}, {from + scaled(3), strip.from.y + 2 * end}, color, scaled(3));
  list.AddRectFilled({to - scaled(3), strip.from.y}, {to + scaled(3), strip.from.y + 2 * end}, color, scaled(3));
  const auto note_end = [&](const char* name, float x) {
    context.targets[name] = {static_cast<double>(x - end), static_cast<double>(strip.from.y),
                             static_cast<double>(x + end), static_cast<double>(strip.from.y + 2 * end)};
  };
  note_end("first selected key", from);
  note_end("last selected key", to);
}

std::optional<bool> selection_end_below(const PanelContext& context, const TimelineOwners& with, const Strip& strip,
                                        ImVec2 at) {
  const KeySelection& keys = with.keys.selected();
  const float end = k_bar_end_units * context.unit;
  if (keys.empty() || keys.first_s() == keys.last_s() || at.y > strip.from.y + 2 * end) return std::nullopt;
  if (std::abs(at.x - strip.x_of(keys.last_s())) < end) return true;
  if (std::abs(at.x - strip.x_of(keys.first_s())) < end) return false;
  return std::nullopt;
}

std::pair<double, double> scaled_selection(const KeySelection& keys, double to_s, bool last, int rate) {
  const double first_s = keys.first_s();
  const double last_s = keys.last_s();
  const double least = time_of_frame(1, rate);
  if (last) return {first_s, std::max(least, on_frame(to_s, rate) - first_s) / (last_s - first_s)};
  return {last_s, std::max(least, last_s - on_frame(to_s, rate)) / (last_s - first_s)};
}

}  // namespace penpose::app
