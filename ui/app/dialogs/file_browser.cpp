#include "ui/app/dialogs/file_browser.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/base/text/letters.h"
#include "ui/app/widgets/internal/widgets.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

bool has_extension(const fs::path& path, std::span<const std::string> extensions) {
  const std::string extension = base::lower_case(path.extension().string());
  return std::find(extensions.begin(), extensions.end(), extension) != extensions.end();
}

/// Folders first, then files with some extensions, by name.
std::vector<fs::directory_entry> entries_of(const std::string& folder, std::span<const std::string> extensions) {
  std::vector<fs::directory_entry> entries;
  std::error_code code;
  for (fs::directory_iterator it(folder, code), end; !code && it != end; it.increment(code)) {
    if (it->path().filename().string().starts_with('.')) continue;
    std::error_code ignored;
    if (it->is_directory(ignored) || has_extension(it->path(), extensions)) entries.push_back(*it);
  }
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    std::error_code ignored;
    const bool a_folder = a.is_directory(ignored);
    const bool b_folder = b.is_directory(ignored);
    return a_folder != b_folder ? a_folder : a.path().filename() < b.path().filename();
  });
  return entries;
}

}  // namespace

std::string browse(PanelContext& context, Dialogs& dialogs, float height, std::span<const std::string> extensions) {
  std::string& folder = dialogs.state<FileChoice>().folder;
  std::string chosen;
  ImGui::TextUnformatted(folder.c_str());
  begin_list(context, "files", {0, height}, true);
  if (wide_button(context, "..##parent", -1)) folder = fs::path(folder).parent_path().string();
  for (const auto& entry : entries_of(folder, extensions)) {
    std::error_code ignored;
    const bool is_folder = entry.is_directory(ignored);
    const std::string name = entry.path().filename().string() + (is_folder ? "/" : "");
    if (!wide_button(context, name.c_str(), -1)) continue;
    if (is_folder) {
      folder = entry.path().string();
      break;
    }
    chosen = entry.path().string();
  }
  ImGui::EndChild();
  return chosen;
}

}  // namespace penpose::app
