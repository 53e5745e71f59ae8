#include "ui/files/folder_files.h"

#include <algorithm>
#include <system_error>

#include "ui/files/natural_order.h"

namespace penpose::files {

namespace fs = std::filesystem;

base::Result<std::optional<std::vector<std::string>>> folder_files(const std::string& path,
                                                                   const std::function<bool(const fs::path&)>& wanted) {
  std::error_code code;
  const bool is_folder = fs::is_directory(path, code);
  // What is not there is told by whoever opens it.
  if (!is_folder && (!code || code == std::errc::no_such_file_or_directory)) {
    return std::optional<std::vector<std::string>>();
  }
  std::vector<std::string> files;
  if (!code) {
    for (fs::directory_iterator entry(path, code), end; !code && entry != end; entry.increment(code)) {
      std::error_code unknown;
      const bool plain = entry->is_regular_file(unknown);
      if (plain && wanted(entry->path())) files.push_back(entry->path().string());
    }
  }
  if (code) return base::Error{"cannot be read (" + code.message() + ")", "", "check the name and the permissions"};
  std::sort(files.begin(), files.end(), natural_less);
  return std::optional(std::move(files));
}

}  // namespace penpose::files
