#pragma once

#include <cstdint>
#include <span>

#include "tests/judges/rigs/rig.h"
#include "tests/judges/table/outcome.h"

namespace penpose::judges {

/// How many cases are looked at: `brief` takes a part of them, the same ones every time.
enum class Extent : std::uint8_t { brief, whole };

/// A way to judge the program on a rig, the same bits on every machine but for times.
struct Measure {
  const char* name;
  bool (*applies)(const Rig& rig);
  std::vector<Outcome> (*judge)(const Rig& rig, Extent extent);
};

/// Whole faces of known poses, drawn by several hands (intent_cases.h).
[[nodiscard]] Measure intent_measure();
/// Lines that no pose of the rig meets (gesture_cases.h).
[[nodiscard]] Measure gesture_measure();
/// Limbs of known poses.
[[nodiscard]] Measure body_measure();
/// Exact targets, by the preset that sums distances and by the one that asks what was meant.
[[nodiscard]] Measure exact_measure();
[[nodiscard]] Measure meant_measure();

/// All of them, in the order of the table.
[[nodiscard]] std::span<const Measure> all_measures();

}  // namespace penpose::judges
