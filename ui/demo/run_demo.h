#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/document/document.h"
#include "replay/session/session_player.h"

namespace penpose::demo {

/// A pose of the session that has a name, and how it was reached.
struct NamedPose {
  std::string name;
  rig::Pose pose;
  std::size_t curves = 0;       ///< pairs of reference and target
  double distance_at_rest = 0;  ///< sum of the distances between references and targets, metres
  double distance = 0;          ///< and in the pose
};

/// What the demo makes of the built-in head.
struct Demo {
  document::Document document;  ///< articulated and posed, its key poses on the timeline
  std::vector<NamedPose> poses;
  std::uint64_t reports = 0;  ///< of the pen
  std::size_t strokes = 0;
  std::size_t states_checked = 0;  ///< states of the recording that were found equal
};

/// Replays the bundled session from its raw pen reports: the deformers are sketched on the bare head, then it is posed
/// line by line. Errors: a replay that does not end in the states that were recorded.
[[nodiscard]] base::Result<Demo> run_demo();

}  // namespace penpose::demo
