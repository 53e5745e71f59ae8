#pragma once

#include <cstdint>
#include <optional>

#include "ui/app/input/trace_player.h"

namespace penpose::app {

/// A trace or a session that is played in place of tablets, if one is.
struct Player {
  std::optional<TracePlayer> trace;
  std::int64_t began_us = 0;  ///< of the clock

  /// Strokes, views and commands come from a session.
  [[nodiscard]] bool plays_session() const { return trace && trace->is_session() && !trace->finished(); }
};

}  // namespace penpose::app
