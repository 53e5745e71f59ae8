#pragma once

#include <cstddef>

namespace penpose::tests {

/// What fails in this program while a plan is under way: allocations with new, or calls that open, read, write and name
/// files (the build puts ours before the system's). The calls are counted from 1; the one of the plan's number fails,
/// all after it too where `stays`, as on a disk that is full.
struct FaultPlan {
  enum class Kind { none, memory, files };
  Kind kind = Kind::none;
  std::size_t number = 0;  ///< 0: none fails, all are counted
  bool stays = false;
};

void begin_faults(const FaultPlan& plan);
/// Ends the plan and gives how many calls of its kind there were.
std::size_t end_faults();

}  // namespace penpose::tests
