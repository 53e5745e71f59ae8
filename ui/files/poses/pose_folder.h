#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/poses/kept_pose.h"

namespace penpose::files {

/// What files of poses end with.
inline constexpr const char* k_pose_extension = ".pose.json";
/// So many files of a folder are looked at.
inline constexpr std::size_t k_most_poses = 1000;

/// Where poses are kept: $XDG_DATA_HOME/penpose/poses (~/.local/share/penpose/poses); empty where there is neither a
/// variable nor a home.
[[nodiscard]] std::string usual_pose_folder();

/// A file of a folder of poses: its pose, or why it is none.
struct PoseFile {
  std::string path;
  base::Result<poses::KeptPose> pose;
};

/// The files of a folder, in the order of their names; none where there is no such folder. Hidden files and folders in
/// it are left out. Errors: it cannot be read.
[[nodiscard]] base::Result<std::vector<PoseFile>> read_pose_folder(const std::string& folder);

/// Writes a pose into a folder, which is made where it is missing, as a new file that is called like the pose. Gives
/// its path. Errors: no such name, those of the file system.
[[nodiscard]] base::Result<std::string> add_pose(const std::string& folder, const poses::KeptPose& pose);

/// Gives a pose another name, and its file. Gives the new path; where that fails all stays. Errors as add_pose.
[[nodiscard]] base::Result<std::string> rename_pose(const std::string& path, poses::KeptPose pose,
                                                    const std::string& name);

/// Moves a file into the folder "trash" beside it and gives its path there. Errors: those of the file system.
[[nodiscard]] base::Result<std::string> bin_pose(const std::string& path);
/// Moves it back to where it was, or beside what is there by now, and gives that path.
[[nodiscard]] base::Result<std::string> take_back_pose(const std::string& binned, const std::string& path);

}  // namespace penpose::files
