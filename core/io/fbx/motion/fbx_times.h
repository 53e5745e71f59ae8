#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/io/fbx/motion/fbx_take.h"

namespace penpose::io {

/// Where values are read from curves.
struct FbxTimes {
  std::vector<double> times_s;  ///< ascending
  bool steps = false;           ///< every value holds until the next time
};

/// The keys of all curves, moments just before one jumps, and moments of `rate` a second between those where one bends,
/// or moves at all where values `turn`. Where a curve goes on beyond its keys, from `start_s` to `stop_s`. Null: there
/// are more than `most`.
[[nodiscard]] std::optional<FbxTimes> fbx_times(std::span<const FbxCurve* const> curves, bool turn, double rate,
                                                const FbxTake& take, std::size_t most);

}  // namespace penpose::io
