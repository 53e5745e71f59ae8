#pragma once

#include <string>
#include <vector>

#include "core/io/project/case_file.h"
#include "tests/judges/measures/measure.h"

namespace penpose::judges {

/// Lines as an artist bends them, which no pose of the rig meets exactly.
struct Gesture {
  io::PoseCase asked;
  std::string hand;
  std::vector<std::vector<std::string>> needed;  ///< of each group a control has to move; joints without ".rx"
  std::vector<std::string> accepted;             ///< controls that may help
  bool still_is_right = false;                   ///< nothing of the rig does what was drawn
};

/// Smiles, frowns, mouths opened, narrowed, widened and aside, smirks, brows, winks and blinks, of those that the rig
/// has controls for. Precondition: the rig has lines.
[[nodiscard]] std::vector<Gesture> gestures(const Rig& rig, Extent extent);

}  // namespace penpose::judges
