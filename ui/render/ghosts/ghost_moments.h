#pragma once

#include <cstdint>
#include <vector>

#include "core/document/time/timeline.h"

namespace penpose::render {

/// How the face is shown as it is at other moments: by its lines, or also as a translucent surface.
enum class GhostStyle : std::uint8_t { contours, faces };
/// At which moments: at keys, or every so many frames.
enum class GhostSteps : std::uint8_t { keys, frames };

/// The most ghosts on one side of a moment, and the most frames from one to the next.
inline constexpr int k_most_ghosts = 9;
inline constexpr int k_most_ghost_frames = 48;

struct GhostLook {
  GhostStyle style = GhostStyle::contours;
  GhostSteps steps = GhostSteps::keys;
  int before = 1;  ///< so many, 0..k_most_ghosts
  int after = 1;
  int every = 2;  ///< frames from one to the next, 1..k_most_ghost_frames
  friend bool operator==(const GhostLook&, const GhostLook&) = default;
};

struct GhostMoment {
  double time_s = 0;
  int away = -1;  ///< the nearest one before is -1, the nearest one after 1
  friend bool operator==(const GhostMoment&, const GhostMoment&) = default;
};

/// The moments whose faces are shown beside that of a moment, ascending. Between keys the face moves, so that none lies
/// before the first key or after the last one. `rate`: frames a second.
[[nodiscard]] std::vector<GhostMoment> ghost_moments(const document::Timeline& timeline, double time_s, double rate,
                                                     const GhostLook& look);

}  // namespace penpose::render
