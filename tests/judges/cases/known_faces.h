#pragma once

#include <string>
#include <vector>

#include "core/io/project/case_file.h"
#include "tests/judges/measures/measure.h"

namespace penpose::judges {

/// Lines that a hand drew of a face whose pose is known.
struct KnownFace {
  io::PoseCase asked;  ///< its `weights` are empty: the program is not to see them
  std::string hand;
  rig::Pose truth;  ///< all parameters; the rest pose where lines are redrawn where they are
  double true_controls = 0;
};

/// Each known pose of the rig drawn by several hands, and lines redrawn where they are. Lines that the pose moves are
/// drawn, at most six of them. Precondition: the rig has lines.
[[nodiscard]] std::vector<KnownFace> known_faces(const Rig& rig, Extent extent);

/// The pose with these values, all else at rest. Precondition: the rig has the controls.
[[nodiscard]] rig::Pose pose_of(const rig::Rig& rig, const std::vector<std::pair<std::string, double>>& values);

/// The questions alone, as a file of cases holds them.
template <typename Case>
[[nodiscard]] io::CaseFile file_of(const std::vector<Case>& cases) {
  io::CaseFile file;
  for (const Case& one : cases) file.cases.push_back(one.asked);
  return file;
}

}  // namespace penpose::judges
