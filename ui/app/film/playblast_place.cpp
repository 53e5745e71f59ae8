#include "ui/app/film/playblast_place.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "core/base/numbers.h"
#include "ui/files/files.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr ? value : "";
}

/// The value of a line XDG_VIDEOS_DIR="$HOME/Videos"; empty: there is none.
std::string named_videos(std::string_view text, const std::string& home) {
  constexpr std::string_view k_name = "XDG_VIDEOS_DIR=\"";
  constexpr std::string_view k_home_word = "$HOME";
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = base::trim(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!line.starts_with(k_name) || !line.ends_with('"') || line.size() <= k_name.size()) continue;
    line.remove_prefix(k_name.size());
    line.remove_suffix(1);
    if (line.starts_with('/')) return std::string(line);
    if (line.starts_with(k_home_word)) return home + std::string(line.substr(k_home_word.size()));
  }
  return {};
}

}  // namespace

std::string film_folder(const std::string& project) {
  std::error_code code;
  if (!project.empty()) {
    const fs::path folder = fs::absolute(project, code).parent_path();
    return folder.string();
  }
  std::string home = variable("HOME");
  if (home.empty()) home = "/";
  std::string config = variable("XDG_CONFIG_HOME");
  if (config.empty()) config = home + "/.config";
  const auto lines = files::read_plain_file(config + "/user-dirs.dirs", files::k_most_settings_bytes);
  const std::string named = lines ? named_videos(std::string(lines->begin(), lines->end()), home) : std::string();
  for (const std::string& folder : {named, home + "/Videos"}) {
    if (!folder.empty() && fs::is_directory(folder, code)) return folder;
  }
  return home;
}

std::string film_stem(const std::string& project, const std::string& opened) {
  constexpr std::string_view k_own_end = ".penpose";
  const std::string& from = project.empty() ? opened : project;
  if (from.empty() || from.starts_with("builtin:")) return "head";
  std::string stem = fs::path(from).stem().string();
  if (stem.size() > k_own_end.size() && stem.ends_with(k_own_end)) stem.resize(stem.size() - k_own_end.size());
  return stem;
}

}  // namespace penpose::app
