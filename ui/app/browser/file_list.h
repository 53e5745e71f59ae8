#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace penpose::app {

enum class FileSort : std::uint8_t { name, date, size };

/// What is listed of a folder, and how.
struct FileView {
  FileSort sort = FileSort::name;       ///< numbers in names as numbers; the newest first; the largest first
  bool hidden = false;                  ///< what begins with a dot, too
  std::vector<std::string> extensions;  ///< of files, in lower case, with their dots; none: every file
  std::string begins;                   ///< the names begin so, in upper or lower case
  friend bool operator==(const FileView&, const FileView&) = default;
};

struct FileEntry {
  std::string name;
  bool is_folder = false;
  std::uintmax_t bytes = 0;
  std::filesystem::file_time_type changed = {};
};

/// So many entries of a folder are read.
inline constexpr std::size_t k_most_entries = 20'000;

/// Folders first. Errors: it is no folder, or cannot be read.
[[nodiscard]] base::Result<std::vector<FileEntry>> list_folder(const std::string& folder, const FileView& view);

/// "12 KB", "3.4 MB".
[[nodiscard]] std::string size_text(std::uintmax_t bytes);
/// "2026-05-31 14:02", by the clock of this place.
[[nodiscard]] std::string date_text(std::filesystem::file_time_type time);

/// Makes a folder, whose path it gives. Errors: no name for a folder, taken, not to be written.
[[nodiscard]] base::Result<std::string> make_folder(const std::string& parent, const std::string& name);

/// What was typed for a place: a path, from a folder on where it does not begin at the root or with "~", up to the last
/// bar, and the name behind it.
struct TypedPath {
  std::string folder;
  std::string name;
};
[[nodiscard]] TypedPath typed_path(const std::string& folder, std::string_view text, std::string_view home);
/// The text as far as what is there allows no other: "Do" becomes "Documents/" where nothing else begins so.
[[nodiscard]] std::string completed_path(const std::string& folder, const std::string& text, std::string_view home,
                                         const FileView& view);

}  // namespace penpose::app
