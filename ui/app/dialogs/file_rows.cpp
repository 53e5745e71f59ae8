#include "ui/app/dialogs/file_rows.h"

#include <algorithm>
#include <filesystem>

#include "ui/app/widgets/internal/file_pictures.h"
#include "ui/app/widgets/internal/icon.h"
#include "ui/app/widgets/internal/theme.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

/// A row with a picture is so many targets high, and its details show from so many on.
constexpr float k_high = 1.3F;
constexpr float k_details = 9;

constexpr std::string_view k_folder = "M3 19L3 5L9 5L11 8L21 8L21 19Z";
constexpr std::string_view k_file = "M6 3L14 3L19 8L19 21L6 21Z M14 3L14 8L19 8";
constexpr std::string_view k_home = "M3 12L12 4L21 12M6 10L6 20L18 20L18 10";
constexpr std::string_view k_volume = "M4 8L20 8L20 17L4 17Z M15 12.5L17 12.5";

std::int64_t stamp_of(const FileEntry& entry) {
  return static_cast<std::int64_t>(entry.changed.time_since_epoch().count());
}

struct RowPlace {
  ImVec2 least;
  ImVec2 most;
  ImU32 ink;
};

/// Date and size at the right, where there is room. Px that they take.
float draw_details(PanelContext& context, const FileEntry& entry, const RowPlace& row) {
  if (row.most.x - row.least.x < k_details * context.unit) return 0;
  const std::string text =
      entry.is_folder ? date_text(entry.changed) : size_text(entry.bytes) + "   " + date_text(entry.changed);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  const float pad = 0.22F * context.unit;
  ImGui::GetWindowDrawList()->AddText({row.most.x - pad - size.x, 0.5F * (row.least.y + row.most.y - size.y)},
                                      ImGui::GetColorU32(ImGuiCol_TextDisabled), text.c_str());
  return size.x + 2 * pad;
}

void draw_row(PanelContext& context, const std::string& folder, const FileEntry& entry, const RowPlace& row) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(row.least, row.most, true);
  const float side = row.most.y - row.least.y - 2;
  const float middle = 0.5F * (row.least.y + row.most.y);
  const std::string path = (fs::path(folder) / entry.name).string();
  const auto picture = !entry.is_folder && Thumbnails::may_have(entry.name)
                           ? context.file_pictures.place_of(path, stamp_of(entry))
                           : std::nullopt;
  if (picture) {
    list.AddImage(ImGui::GetIO().Fonts->TexID, {row.least.x + 1, row.least.y + 1},
                  {row.least.x + 1 + side, row.least.y + 1 + side}, picture->first, picture->second);
  } else {
    draw_icon(list, entry.is_folder ? k_folder : k_file, {row.least.x + 1 + 0.5F * side, middle}, 0.56F * context.unit,
              row.ink);
  }
  const float details = draw_details(context, entry, row);
  const float from = row.least.x + side + context.gap;
  const std::string text = fitted_text(entry.name + (entry.is_folder ? "/" : ""), row.most.x - from - details);
  list.AddText({from, middle - 0.5F * ImGui::GetFontSize()}, row.ink, text.c_str());
  list.PopClipRect();
}

bool show_row(PanelContext& context, const std::string& folder, const FileEntry& entry, bool chosen) {
  const std::string label = entry.name + (entry.is_folder ? "/" : "");
  ImGui::PushStyleColor(ImGuiCol_Button, vec_of(palette().chosen, chosen ? 1 : 0));
  ImGui::PushID(label.c_str());
  const bool pressed = ImGui::Button("##row", {ImGui::GetContentRegionAvail().x, k_high * context.unit});
  ImGui::PopID();
  ImGui::PopStyleColor();
  note(context, label.c_str());
  draw_row(context, folder, entry,
           {ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
            color_of(ImGui::IsItemActive() ? palette().on_accent : palette().ink)});
  return pressed;
}

}  // namespace

std::string_view icon_of(FilePlace::Kind kind) {
  switch (kind) {
    case FilePlace::Kind::home:
      return k_home;
    case FilePlace::Kind::volume:
      return k_volume;
    case FilePlace::Kind::project:
      return icon_of(Action::save);
    case FilePlace::Kind::recent:
      return icon_of(Action::recent);
    case FilePlace::Kind::named:
      break;
  }
  return k_folder;
}

std::optional<FileEntry> show_file_rows(PanelContext& context, const FileBrowser& browser, bool follows) {
  const float step = k_high * context.unit + ImGui::GetStyle().ItemSpacing.y;
  if (follows && browser.chosen) {
    const float at = static_cast<float>(*browser.chosen) * step;
    const float seen = std::max(0.0F, ImGui::GetWindowHeight() - 2 * step);
    ImGui::SetScrollY(std::clamp(ImGui::GetScrollY(), at - seen, at));
  }
  if (browser.entries.empty() && browser.error.empty()) ImGui::TextDisabled("Nothing of that kind is here.");
  std::optional<FileEntry> pressed;
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(browser.entries.size()), step);
  while (clipper.Step()) {
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
      const FileEntry& entry = browser.entries[static_cast<std::size_t>(i)];
      if (show_row(context, browser.folder, entry, browser.chosen == static_cast<std::size_t>(i))) pressed = entry;
    }
  }
  return pressed;
}

void show_folder_line(PanelContext& context, const std::string& text) {
  const float width = ImGui::GetContentRegionAvail().x - context.gap;
  std::size_t from = 0;
  const auto shown = [&] { return from == 0 ? text : "\u2026" + text.substr(from); };
  while (from < text.size() && ImGui::CalcTextSize(shown().c_str()).x > width) {
    ++from;
    // Not in the middle of a letter.
    while (from < text.size() && (static_cast<unsigned char>(text[from]) & 0xC0U) == 0x80U) ++from;
  }
  ImGui::TextUnformatted(shown().c_str());
}

}  // namespace penpose::app
