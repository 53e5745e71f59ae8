#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/rig/rig.h"

// Ways for a face to leave the program while it moves. The window and `replay` tell of every frame; a way out sends it
// on. It is a file NAME_way_out.cpp below this folder, which the build finds, with `WayOut NAME_way_out()` at its end.

namespace penpose::live {

/// A pose as it is shown.
struct FramePose {
  std::span<const rig::Parameter> parameters;
  std::span<const double> values;  ///< one a parameter, within its range
  double time_s = 0;               ///< of a clock that never goes back
};

/// Takes every frame's pose. It is called on the thread that shows them and must not wait for anybody.
using Listener = std::function<void(const FramePose&)>;

struct WayOut {
  std::string_view name;   ///< as "--live NAME=WHERE" gives it
  std::string_view where;  ///< what stands for WHERE in --help: "HOST:PORT"
  std::function<base::Result<Listener>(std::string_view where)> open;
};

/// All that there are, by their names.
[[nodiscard]] const std::vector<WayOut>& ways_out();

/// What "NAME=WHERE" opens, of these ways; a listener that does nothing for an empty text. Errors: no such way; those
/// of the way.
[[nodiscard]] base::Result<Listener> open_way_out(std::string_view text, std::span<const WayOut> ways);

}  // namespace penpose::live
