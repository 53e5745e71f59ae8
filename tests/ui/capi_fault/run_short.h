#pragma once

#include <functional>
#include <gtest/gtest.h>

#include "tests/support/c_desk.h"
#include "tests/ui/fault/faults.h"

namespace penpose::tests {

/// Calls until one is not short of memory, which must then have worked. Gives how often one failed. `undo` takes back
/// what a call did that did without.
inline std::size_t run_short(
    const char* name, const std::function<std::int32_t(penpose_error*)>& call, const std::function<void()>& check,
    const std::function<void()>& undo = [] {}) {
  // Every number up to here, then ever farther apart: an allocation deep in a loop is like the one before.
  constexpr std::size_t k_each = 400;
  std::size_t shorts = 0;
  for (std::size_t number = 1; number < 2'000'000; number += number < k_each ? 1 : number / 50) {
    // That one alone, and all from it on.
    for (const bool stays : {false, true}) {
      penpose_error error{};
      begin_faults({FaultPlan::Kind::memory, number, stays});
      const std::int32_t status = call(&error);
      const std::size_t calls = end_faults();
      if (calls < number) {
        EXPECT_EQ(status, PENPOSE_OK) << name << ": " << error.message;
        return shorts;
      }
      if (status == PENPOSE_OK) {
        undo();
        continue;
      }
      ++shorts;
      EXPECT_EQ(status, PENPOSE_NO_MEMORY) << name << ", allocation " << number << ": " << error.message;
      EXPECT_EQ(error.status, status);
      EXPECT_STRNE(error.message, "");
      check();
      if (testing::Test::HasFailure()) return shorts;
    }
  }
  ADD_FAILURE() << name << " takes memory without end";
  return shorts;
}

}  // namespace penpose::tests
