#include "firmware_io/device/source/exclusive_use.h"

#include <gtest/gtest.h>
#include <vector>

namespace penpose::device {
namespace {

constexpr std::int64_t k_second_us = 1'000'000;

/// A device that one program at a time has for itself.
struct OneDevice {
  bool others = false;      ///< another program has it
  std::vector<bool> asked;  ///< what was asked of the system

  bool grab(bool on) {
    asked.push_back(on);
    return !on || !others;
  }
  void settle(ExclusiveUse& use, std::int64_t now_us) {
    use.settle([this](bool on) { return grab(on); }, now_us);
  }
};

TEST(ExclusiveUse, IsTakenOnceAndGivenBackOnce) {
  OneDevice device;
  ExclusiveUse use;
  EXPECT_TRUE(use.is_settled()) << "nobody asked for it";
  device.settle(use, 0);
  use.want(true);
  EXPECT_FALSE(use.is_settled());
  device.settle(use, 0);
  device.settle(use, 1);
  EXPECT_TRUE(use.is_settled());
  use.want(false);
  device.settle(use, 2);
  device.settle(use, 3);
  EXPECT_EQ(device.asked, (std::vector<bool>{true, false}));
}

TEST(ExclusiveUse, OneThatIsJustLettingGoIsWaitedForWithoutAWord) {
  OneDevice device{true, {}};
  ExclusiveUse use;
  use.want(true);
  device.settle(use, 0);
  EXPECT_FALSE(use.is_settled());
  EXPECT_FALSE(use.is_refused(k_second_us - 1));
  device.others = false;
  device.settle(use, k_second_us - 1);
  EXPECT_TRUE(use.is_settled());
  EXPECT_FALSE(use.is_refused(10 * k_second_us));
}

TEST(ExclusiveUse, OneThatKeepsItIsToldUntilItLetsGoOrNobodyAsks) {
  OneDevice device{true, {}};
  ExclusiveUse use;
  use.want(true);
  device.settle(use, 0);
  device.settle(use, 5 * k_second_us);
  EXPECT_TRUE(use.is_refused(5 * k_second_us));
  use.want(false);
  EXPECT_FALSE(use.is_refused(6 * k_second_us)) << "without the question there is no refusal";
  use.want(true);
  device.settle(use, 7 * k_second_us);
  EXPECT_FALSE(use.is_refused(7 * k_second_us)) << "patience begins anew";
  device.settle(use, 9 * k_second_us);
  EXPECT_TRUE(use.is_refused(9 * k_second_us));
  device.others = false;
  device.settle(use, 10 * k_second_us);
  EXPECT_FALSE(use.is_refused(10 * k_second_us));
}

}  // namespace
}  // namespace penpose::device
