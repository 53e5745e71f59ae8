#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/rig/rig.h"

// Live outputs send a face to other programs while it moves. The window and `replay` pass every frame to them. Each is
// a file NAME_live_output.cpp below this folder, which the build finds, with `LiveOutput NAME_live_output()` at its
// end.

namespace penpose::live {

/// A pose as it is shown.
struct FramePose {
  std::span<const rig::Parameter> parameters;
  std::span<const double> values;  ///< one a parameter, within its range
  double time_s = 0;               ///< of a clock that never goes back
};

/// Takes every frame's pose. It is called on the thread that shows them and must not wait for anybody.
using Listener = std::function<void(const FramePose&)>;

struct LiveOutput {
  std::string_view name;   ///< as "--live NAME=WHERE" gives it
  std::string_view where;  ///< what stands for WHERE in --help: "HOST:PORT"
  std::function<base::Result<Listener>(std::string_view where)> open;
};

/// All of them, by name.
[[nodiscard]] const std::vector<LiveOutput>& live_outputs();

/// Opens "NAME=WHERE" among these outputs; for an empty text, a listener that does nothing. Errors: no such output;
/// those of the output.
[[nodiscard]] base::Result<Listener> open_live_output(std::string_view text, std::span<const LiveOutput> outputs);

}  // namespace penpose::live
