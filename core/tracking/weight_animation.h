#pragma once

#include <string>
#include <vector>

#include "core/animation/track.h"
#include "core/document/time/animation_building.h"
#include "core/io/tracks/map_file.h"

namespace penpose::tracking {

struct WeightAnimation {
  std::vector<double> times_s;
  std::vector<rig::Pose> poses;  ///< within the controls' ranges
  std::vector<std::size_t> held;
  bool drives = false;                          ///< any control, or the head
  std::vector<std::string> unmatched;           ///< names that the model has no control for
  std::vector<std::string> nearest;             ///< a control's name for each of them; empty: none is near
  std::vector<std::string> notes;               ///< on values far outside their controls' ranges
  std::vector<document::Placement> placements;  ///< from HeadYaw, HeadPitch and HeadRoll, where asked for and there
};

/// Values by name straight to parameters: what the map's own list says, else what driven_controls finds. Of several
/// names that drive one control the one that moves it farthest counts, frame by frame. Frames that were not found
/// repeat the one before. Shapes that nothing drives stay as the model's pose has them. `smooth_s`: as
/// animation::smooth_over_time.
[[nodiscard]] WeightAnimation animate_weights(const document::Model& model, const animation::WeightTrack& track,
                                              const io::MapFile& map, bool apply_head, double smooth_s);

}  // namespace penpose::tracking
