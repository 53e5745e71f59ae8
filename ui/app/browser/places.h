#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace penpose::app {

/// A folder that dialogs of files offer.
struct FilePlace {
  enum class Kind : std::uint8_t { home, named, project, volume, recent };
  Kind kind = Kind::home;
  std::string label;
  std::string path;
};

/// What the places are made of.
struct PlaceSources {
  std::string home;
  std::string user_folders;             ///< the text of $XDG_CONFIG_HOME/user-dirs.dirs
  std::string mounts;                   ///< the text of /proc/self/mountinfo
  std::string project;                  ///< a file; empty: there is none
  std::span<const std::string> recent;  ///< files, the last one first
};

/// Home, desktop, documents and so on as xdg-user-dirs keeps them, the project's folder, mounted volumes, and folders
/// of recent files. What is listed before is not listed again. Whether the folders are there is not looked at.
[[nodiscard]] std::vector<FilePlace> file_places(const PlaceSources& sources);
/// The same as they are on this machine; what is no folder is left out.
[[nodiscard]] std::vector<FilePlace> places_here(const std::string& project, std::span<const std::string> recent);
/// $HOME; empty where there is none.
[[nodiscard]] std::string home_folder();

}  // namespace penpose::app
