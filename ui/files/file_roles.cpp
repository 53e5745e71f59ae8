#include "ui/files/file_roles.h"

#include <algorithm>
#include <filesystem>
#include <sys/stat.h>

#include "ui/files/files.h"
#include "ui/files/open_file.h"

namespace penpose::files {
namespace {

namespace fs = std::filesystem;

bool is_same_entry(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

}  // namespace

bool same_file(const std::string& a, const std::string& b) {
  const std::string paths[] = {link_target(a), link_target(b)};
  struct stat facts[2] = {};
  const bool there[] = {::stat(paths[0].c_str(), &facts[0]) == 0, ::stat(paths[1].c_str(), &facts[1]) == 0};
  if (there[0] != there[1]) return false;
  if (there[0]) return S_ISREG(facts[0].st_mode) && is_same_entry(facts[0], facts[1]);
  // Neither is there yet: they are one if they have one name in one folder.
  const fs::path names[] = {fs::path(paths[0]).filename(), fs::path(paths[1]).filename()};
  if (names[0] != names[1]) return false;
  for (int i = 0; i < 2; ++i) {
    const std::string folder = fs::path(paths[i]).parent_path().string();
    if (::stat(folder.empty() ? "." : folder.c_str(), &facts[i]) != 0) return paths[0] == paths[1];
  }
  return is_same_entry(facts[0], facts[1]);
}

void FileRoles::reads(const std::string& path) {
  if (!path.empty() && !path.starts_with("builtin:")) read_.push_back(path);
}

bool FileRoles::is_read(const std::string& path) const {
  if (path == k_standard_stream) return false;
  return std::any_of(read_.begin(), read_.end(),
                     [&](const std::string& other) { return other != k_standard_stream && same_file(path, other); });
}

base::Status FileRoles::writes(const std::string& path, std::string_view option) {
  if (path == k_standard_stream && prints_) {
    return base::Error{"the command prints what it did on standard output, so that no file fits in there",
                       std::string(option), "name a file"};
  }
  if (path.empty()) return base::Error{"the name of the file to write is empty", std::string(option), "name a file"};
  const auto is_it = [&](const std::string& other) {
    return path == k_standard_stream || other == k_standard_stream ? path == other : same_file(path, other);
  };
  if (is_read(path)) {
    return base::Error{"is read by this command and is not written over", std::string(option), "choose another name"};
  }
  if (std::any_of(written_.begin(), written_.end(), is_it)) {
    return base::Error{"is written twice by this command", std::string(option), "choose another name"};
  }
  written_.push_back(path);
  return base::Done{};
}

}  // namespace penpose::files
