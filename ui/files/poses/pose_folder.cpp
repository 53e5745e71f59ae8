#include "ui/files/poses/pose_folder.h"

#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "ui/files/files.h"
#include "ui/files/folder_files.h"

namespace penpose::files {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t k_most_pose_bytes = std::uint64_t{1} << 23;
constexpr const char* k_check = "check the folder and its permissions";

base::Error failed(const std::string& what, const std::string& path, const std::string& why) {
  return {what + " (" + why + ")", path, k_check};
}

/// What a pose is called as a file: nothing that leads to another folder, is hidden or is hard to type.
std::string stem_of(const std::string& name) {
  std::string stem;
  for (const char c : name) stem += c == '/' || c == '\\' || c == ':' ? '-' : c;
  return stem.starts_with('.') ? "_" + stem : stem;
}

/// A path in the folder that is free.
std::string free_pose_path(const fs::path& folder, const std::string& stem) {
  std::error_code code;
  fs::path path = folder / (stem + k_pose_extension);
  for (int i = 2; fs::exists(fs::symlink_status(path, code)); ++i)
    path = folder / (stem + " " + std::to_string(i) + k_pose_extension);
  return path.string();
}

std::string stem_of_path(const std::string& path) {
  const std::string name = fs::path(path).filename().string();
  return name.ends_with(k_pose_extension) ? name.substr(0, name.size() - std::strlen(k_pose_extension)) : name;
}

base::Result<std::string> move_to(const std::string& from, const fs::path& folder, const std::string& stem) {
  std::error_code code;
  fs::create_directories(folder, code);
  const std::string to = free_pose_path(folder, stem);
  fs::rename(from, to, code);
  if (code) return failed("cannot be moved to " + to, from, code.message());
  flush_folder_of(to);
  return to;
}

base::Result<poses::KeptPose> read_pose_file(const std::string& path) {
  if (!path.ends_with(".json")) return base::Error{"this is no pose", "", "poses are files *.pose.json"};
  const auto bytes = read_plain_file(path, k_most_pose_bytes);
  if (!bytes) return bytes.error();
  return poses::read_kept_pose(*bytes);
}

}  // namespace

std::string usual_pose_folder() {
  const char* given = std::getenv("XDG_DATA_HOME");
  if (given != nullptr && given[0] == '/') return std::string(given) + "/penpose/poses";
  const char* home = std::getenv("HOME");
  if (home == nullptr || home[0] != '/') return {};
  return std::string(home) + "/.local/share/penpose/poses";
}

base::Result<std::vector<PoseFile>> read_pose_folder(const std::string& folder) {
  const auto files =
      folder_files(folder, [](const fs::path& path) { return !path.filename().string().starts_with('.'); });
  if (!files) return files.error();
  std::vector<PoseFile> out;
  if (!*files) return out;
  for (const std::string& path : **files) {
    if (out.size() == k_most_poses) break;
    out.push_back({path, read_pose_file(path)});
  }
  return out;
}

base::Result<std::string> add_pose(const std::string& folder, const poses::KeptPose& pose) {
  if (!poses::is_pose_name(pose.name))
    return base::Error{"this is no name of a pose", "", "give it 1 to 100 characters"};
  if (folder.empty()) return base::Error{"there is no folder for poses", "", "choose one in Preferences, Folders"};
  std::error_code code;
  fs::create_directories(folder, code);
  if (code) return failed("the folder cannot be made", folder, code.message());
  const std::string path = free_pose_path(folder, stem_of(pose.name));
  const std::string text = poses::write_kept_pose(pose);
  if (auto written = write_file(path, base::as_bytes(text)); !written) return written.error();
  return path;
}

base::Result<std::string> rename_pose(const std::string& path, poses::KeptPose pose, const std::string& name) {
  pose.name = name;
  auto added = add_pose(fs::path(path).parent_path().string(), pose);
  if (!added) return added;
  std::error_code code;
  fs::remove(path, code);
  if (code) return failed("the old file cannot be removed", path, code.message());
  return added;
}

base::Result<std::string> bin_pose(const std::string& path) {
  return move_to(path, fs::path(path).parent_path() / "trash", stem_of_path(path));
}

base::Result<std::string> take_back_pose(const std::string& binned, const std::string& path) {
  return move_to(binned, fs::path(path).parent_path(), stem_of_path(path));
}

}  // namespace penpose::files
