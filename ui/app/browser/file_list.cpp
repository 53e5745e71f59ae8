#include "ui/app/browser/file_list.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <unistd.h>

#include "core/base/text/letters.h"
#include "ui/files/natural_order.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

bool begins_so(std::string_view name, std::string_view begins) {
  return name.size() >= begins.size() && base::same_but_case(name.substr(0, begins.size()), begins);
}

bool is_wanted(const FileEntry& entry, const FileView& view) {
  if (entry.name.starts_with('.') && !view.hidden && !view.begins.starts_with('.')) return false;
  if (!begins_so(entry.name, view.begins)) return false;
  if (entry.is_folder || view.extensions.empty()) return true;
  const std::string extension = base::lower_case(fs::path(entry.name).extension().string());
  return std::find(view.extensions.begin(), view.extensions.end(), extension) != view.extensions.end();
}

/// Whether a comes before b.
bool before(const FileEntry& a, const FileEntry& b, FileSort sort) {
  if (a.is_folder != b.is_folder) return a.is_folder;
  if (sort == FileSort::date && a.changed != b.changed) return a.changed > b.changed;
  if (sort == FileSort::size && a.bytes != b.bytes) return a.bytes > b.bytes;
  return files::natural_less(base::lower_case(a.name), base::lower_case(b.name));
}

/// How many bytes of two names are the same but for their case.
std::size_t same_bytes(std::string_view a, std::string_view b) {
  std::size_t same = 0;
  while (same < std::min(a.size(), b.size()) && base::lower(a[same]) == base::lower(b[same])) ++same;
  return same;
}

}  // namespace

base::Result<std::vector<FileEntry>> list_folder(const std::string& folder, const FileView& view) {
  std::vector<FileEntry> entries;
  std::error_code code;
  fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, code);
  if (!code && it == fs::directory_iterator() && ::access(folder.c_str(), R_OK) != 0)
    code = std::make_error_code(std::errc::permission_denied);
  if (code) return base::Error{"cannot be looked into: " + code.message(), "", "choose another folder"};
  for (const fs::directory_iterator end; !code && it != end && entries.size() < k_most_entries; it.increment(code)) {
    FileEntry entry;
    std::error_code ignored;
    entry.name = it->path().filename().string();
    entry.is_folder = it->is_directory(ignored);
    if (!is_wanted(entry, view)) continue;
    if (!entry.is_folder) entry.bytes = it->file_size(ignored);
    if (ignored) entry.bytes = 0;
    entry.changed = it->last_write_time(ignored);
    entries.push_back(std::move(entry));
  }
  std::stable_sort(entries.begin(), entries.end(),
                   [&](const FileEntry& a, const FileEntry& b) { return before(a, b, view.sort); });
  return entries;
}

std::string size_text(std::uintmax_t bytes) {
  constexpr std::array k_units{"B", "KB", "MB", "GB", "TB"};
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  while (value >= 999.5 && unit + 1 < k_units.size()) {
    value /= 1000;
    ++unit;
  }
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), unit > 0 && value < 9.95 ? "%.1f %s" : "%.0f %s", value, k_units[unit]);
  return text.data();
}

std::string date_text(fs::file_time_type time) {
  const auto system = std::chrono::file_clock::to_sys(time);
  const std::time_t seconds =
      std::chrono::system_clock::to_time_t(std::chrono::time_point_cast<std::chrono::system_clock::duration>(system));
  std::tm parts{};
  if (::localtime_r(&seconds, &parts) == nullptr) return {};
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M", &parts);
  return text.data();
}

base::Result<std::string> make_folder(const std::string& parent, const std::string& name) {
  if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos)
    return base::Error{"\"" + name + "\" is no name for a folder", "", "type one without a bar"};
  const fs::path path = fs::path(parent) / name;
  std::error_code code;
  if (fs::exists(path, code)) return base::Error{"\"" + name + "\" is there already", "", "type another name"};
  if (!fs::create_directory(path, code))
    return base::Error{"\"" + name + "\" cannot be made: " + code.message(), "", "choose another place"};
  return path.string();
}

TypedPath typed_path(const std::string& folder, std::string_view text, std::string_view home) {
  std::string whole(text);
  if (!home.empty() && (whole == "~" || whole.starts_with("~/")))
    whole = std::string(home) + whole.substr(1) + (whole == "~" ? "/" : "");
  const std::size_t bar = whole.rfind('/');
  if (bar == std::string::npos) return {folder, whole};
  const fs::path path = (fs::path(folder) / whole.substr(0, bar + 1)).lexically_normal();
  std::string at = path.string();
  while (at.size() > 1 && at.ends_with('/')) at.pop_back();
  return {at, whole.substr(bar + 1)};
}

std::string completed_path(const std::string& folder, const std::string& text, std::string_view home,
                           const FileView& view) {
  const TypedPath typed = typed_path(folder, text, home);
  FileView asked = view;
  asked.begins = typed.name;
  const auto found = list_folder(typed.folder, asked);
  if (!found || found->empty()) return text;
  std::string name = found->front().name;
  for (const FileEntry& one : *found) name.resize(same_bytes(name, one.name));
  if (found->size() == 1 && found->front().is_folder) name += '/';
  if (name.size() < typed.name.size()) return text;
  return text.substr(0, text.size() - std::min(text.size(), typed.name.size())) + name;
}

}  // namespace penpose::app
