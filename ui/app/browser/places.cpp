#include "ui/app/browser/places.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "core/base/text/letters.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t k_most_recent_folders = 4;
constexpr std::size_t k_most_text = std::size_t{1} << 20;
constexpr std::array<std::pair<std::string_view, const char*>, 4> k_named_folders{{{"XDG_DESKTOP_DIR=", "Desktop"},
                                                                                   {"XDG_DOCUMENTS_DIR=", "Documents"},
                                                                                   {"XDG_PICTURES_DIR=", "Pictures"},
                                                                                   {"XDG_DOWNLOAD_DIR=", "Downloads"}}};
/// Where systems mount what people plug in.
constexpr std::array<std::string_view, 3> k_volumes{"/media/", "/run/media/", "/mnt/"};

template <typename Each>
void each_line(std::string_view text, const Each& each) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    each(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// The folder of a line such as XDG_DESKTOP_DIR="$HOME/Desktop"; empty where it says none.
std::string user_folder(std::string_view text, std::string_view name, const std::string& home) {
  std::string found;
  each_line(text, [&](std::string_view line) {
    if (!line.starts_with(name)) return;
    std::string_view value = line.substr(name.size());
    if (value.size() < 2 || value.front() != '"' || value.back() != '"') return;
    value = value.substr(1, value.size() - 2);
    constexpr std::string_view k_home = "$HOME/";
    if (value.starts_with(k_home)) {
      found = home + "/" + std::string(value.substr(k_home.size()));
    } else if (value.starts_with('/')) {
      found = value;
    }
  });
  return found;
}

/// A path as mountinfo writes it, where a blank is \040.
std::string unescaped(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto digit = [&](std::size_t at) { return text[at] >= '0' && text[at] <= '7'; };
    if (text[i] == '\\' && i + 3 < text.size() && digit(i + 1) && digit(i + 2) && digit(i + 3)) {
      out += static_cast<char>((text[i + 1] - '0') * 64 + (text[i + 2] - '0') * 8 + (text[i + 3] - '0'));
      i += 3;
    } else {
      out += text[i];
    }
  }
  return out;
}

/// Where a line of mountinfo mounts: its fifth word.
std::string mount_point(std::string_view line) {
  for (int word = 0; word < 4; ++word) {
    const std::size_t blank = line.find(' ');
    if (blank == std::string_view::npos) return {};
    line.remove_prefix(blank + 1);
  }
  return unescaped(line.substr(0, line.find(' ')));
}

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text;
  std::array<char, 4096> piece{};
  while (file && text.size() < k_most_text) {
    file.read(piece.data(), piece.size());
    text.append(piece.data(), static_cast<std::size_t>(file.gcount()));
  }
  return text;
}

}  // namespace

std::string home_folder() {
  const char* home = std::getenv("HOME");
  return home != nullptr ? home : "";
}

std::vector<FilePlace> file_places(const PlaceSources& sources) {
  std::vector<FilePlace> places;
  const auto add = [&places](FilePlace::Kind kind, const std::string& label, const std::string& path) {
    const bool there =
        std::any_of(places.begin(), places.end(), [&](const FilePlace& one) { return one.path == path; });
    if (!path.empty() && !there) places.push_back({kind, label, path});
    return !path.empty() && !there;
  };
  add(FilePlace::Kind::home, "Home", sources.home);
  for (const auto& [name, label] : k_named_folders) {
    const std::string usual = sources.home.empty() ? "" : sources.home + "/" + label;
    const std::string path = user_folder(sources.user_folders, name, sources.home);
    add(FilePlace::Kind::named, label, path.empty() ? usual : path);
  }
  if (!sources.project.empty())
    add(FilePlace::Kind::project, "Project", fs::path(sources.project).parent_path().string());
  each_line(sources.mounts, [&](std::string_view line) {
    const std::string path = mount_point(line);
    const bool volume = std::any_of(k_volumes.begin(), k_volumes.end(), [&](std::string_view root) {
      return path.size() > root.size() && path.starts_with(root);
    });
    if (volume) add(FilePlace::Kind::volume, fs::path(path).filename().string(), path);
  });
  std::size_t count = 0;
  for (const std::string& file : sources.recent) {
    const fs::path folder = fs::path(file).parent_path();
    if (count < k_most_recent_folders && add(FilePlace::Kind::recent, folder.filename().string(), folder.string()))
      ++count;
  }
  return places;
}

std::vector<FilePlace> places_here(const std::string& project, std::span<const std::string> recent) {
  PlaceSources sources;
  sources.home = home_folder();
  const char* config = std::getenv("XDG_CONFIG_HOME");
  const bool set = config != nullptr && *config == '/';
  sources.user_folders = text_of((set ? std::string(config) : sources.home + "/.config") + "/user-dirs.dirs");
  sources.mounts = text_of("/proc/self/mountinfo");
  sources.project = project;
  sources.recent = recent;
  auto places = file_places(sources);
  std::erase_if(places, [](const FilePlace& one) {
    std::error_code code;
    return !fs::is_directory(one.path, code);
  });
  return places;
}

}  // namespace penpose::app
