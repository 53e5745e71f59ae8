#include <atomic>
#include <gtest/gtest.h>
#include <thread>

#include "tests/support/c_desk.h"

// What the sanitizer of threads looks at: handles of one library in the hands of several threads.

namespace penpose::tests {
namespace {

constexpr int k_threads = 4;
constexpr int k_rounds = 20;

TEST(CThreads, EachWithAHandleOfItsOwn) {
  CDesk desk;
  const std::uint32_t curve = desk.place_lift(0.6);
  std::vector<std::string> states(k_threads);
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < k_threads; ++t) {
      threads.emplace_back([&, t] {
        for (int round = 0; round < k_rounds; ++round) {
          penpose_handle mine = 0;
          penpose_error error;
          char state[33];
          std::vector<double> xyz(desk.sheet_arrays.positions.size());
          EXPECT_EQ(penpose_character_copy(desk.open, desk.sheet, &mine, &error), PENPOSE_OK) << error.message;
          EXPECT_EQ(penpose_record(desk.open, mine, "sheet", &error), PENPOSE_OK) << error.message;
          EXPECT_EQ(penpose_solve(desk.open, mine, round % 2, &error), PENPOSE_OK) << error.message;
          EXPECT_EQ(penpose_evaluate(desk.open, mine, nullptr, 0, xyz.data(), xyz.size() / 3, &error), PENPOSE_OK);
          EXPECT_EQ(penpose_state(desk.open, mine, state, &error), PENPOSE_OK) << error.message;
          EXPECT_EQ(penpose_free(desk.open, mine, &error), PENPOSE_OK) << error.message;
          if (round == 0) states[static_cast<std::size_t>(t)] = state;
        }
      });
    }
  }
  for (const std::string& state : states) EXPECT_EQ(state, states.front());
  EXPECT_EQ(desk.pose()[0], 0) << curve;
}

TEST(CThreads, CallsWithOneHandleWaitForEachOther) {
  CDesk desk;
  static_cast<void>(desk.place_lift(0.6));
  std::atomic<int> wrong = 0;
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < k_threads; ++t) {
      threads.emplace_back([&] {
        for (int round = 0; round < k_rounds; ++round) {
          double values[2];
          if (penpose_solve(desk.open, desk.sheet, PENPOSE_PRESET_EXACT, nullptr) != PENPOSE_OK) ++wrong;
          if (penpose_get_pose(desk.open, desk.sheet, values, 2, nullptr) != PENPOSE_OK) ++wrong;
          // Half of a pose would be neither at rest nor solved.
          const bool whole = values[0] == 0 || (values[0] > 0.59 && values[0] < 0.61);
          if (!whole) ++wrong;
          if (penpose_reset(desk.open, desk.sheet, nullptr) != PENPOSE_OK) ++wrong;
        }
      });
    }
  }
  EXPECT_EQ(wrong, 0);
}

TEST(CThreads, AHandleThatIsFreedMeanwhileIsFoundOrNot) {
  CDesk desk;
  static_cast<void>(desk.place_lift(0.6));
  for (int round = 0; round < k_rounds; ++round) {
    penpose_handle shared = 0;
    ASSERT_EQ(penpose_character_copy(desk.open, desk.sheet, &shared, nullptr), PENPOSE_OK);
    std::int32_t solved = -1;
    std::int32_t freed = -1;
    {
      const std::jthread solver([&] { solved = penpose_solve(desk.open, shared, 1, nullptr); });
      const std::jthread freer([&] { freed = penpose_free(desk.open, shared, nullptr); });
    }
    EXPECT_EQ(freed, PENPOSE_OK);
    EXPECT_TRUE(solved == PENPOSE_OK || solved == PENPOSE_BAD_HANDLE) << solved;
  }
}

}  // namespace
}  // namespace penpose::tests
