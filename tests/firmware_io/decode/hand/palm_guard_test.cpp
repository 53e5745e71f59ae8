#include "firmware_io/decode/hand/palm_guard.h"

#include <gtest/gtest.h>

namespace penpose::decode {
namespace {

constexpr std::int64_t k_hold_us = 500'000;

std::vector<std::uint32_t> ids(std::span<const TouchContact> contacts) {
  std::vector<std::uint32_t> list;
  for (const TouchContact& one : contacts) list.push_back(one.id);
  return list;
}
using Ids = std::vector<std::uint32_t>;

TEST(PalmGuard, FingersComeThroughWhereNoPenIs) {
  PalmGuard guard(k_hold_us);
  const std::vector<TouchContact> two{{1, 10, 20}, {2, 30, 40}};
  EXPECT_EQ(ids(guard.let_through(two, 0)), (Ids{1, 2}));
}

TEST(PalmGuard, AHandIsHeldBackWhileThePenIsNearAndForAMomentAfter) {
  PalmGuard guard(k_hold_us);
  guard.pen(true, 1'000'000);
  EXPECT_TRUE(guard.let_through(std::vector<TouchContact>{{1, 0, 0}}, 1'100'000).empty());
  guard.pen(false, 2'000'000);
  EXPECT_TRUE(guard.let_through(std::vector<TouchContact>{{2, 0, 0}}, 2'000'000 + k_hold_us - 1).empty());
  EXPECT_EQ(ids(guard.let_through(std::vector<TouchContact>{{3, 0, 0}}, 2'000'000 + k_hold_us)), Ids{3});
}

TEST(PalmGuard, APalmIsOneUntilItIsLifted) {
  PalmGuard guard(k_hold_us);
  guard.pen(true, 0);
  EXPECT_TRUE(guard.let_through(std::vector<TouchContact>{{1, 0, 0}}, 0).empty());
  guard.pen(false, 1000);
  const std::vector<TouchContact> both{{1, 0, 0}, {2, 0, 0}};
  EXPECT_EQ(ids(guard.let_through(both, 10'000'000)), Ids{2});
  EXPECT_TRUE(guard.let_through({}, 10'000'001).empty());
  EXPECT_EQ(ids(guard.let_through(both, 10'000'002)), (Ids{1, 2}));
}

TEST(PalmGuard, AFingerThatWasDownBeforeThePenCameIsHeldBackFromThenOn) {
  PalmGuard guard(k_hold_us);
  const std::vector<TouchContact> one{{1, 0, 0}};
  EXPECT_EQ(guard.let_through(one, 0).size(), 1u);
  guard.pen(true, 10);
  EXPECT_TRUE(guard.let_through(one, 20).empty());
  guard.pen(false, 30);
  EXPECT_TRUE(guard.let_through(one, 30 + 2 * k_hold_us).empty());
}

TEST(PalmGuard, APenThatStaysAwayHoldsNothingBack) {
  PalmGuard guard(k_hold_us);
  guard.pen(false, 100);
  EXPECT_FALSE(guard.holds_back(100));
  guard.pen(true, 200);
  EXPECT_TRUE(guard.holds_back(10'000'000));
  guard.reset();
  EXPECT_FALSE(guard.holds_back(10'000'000));
}

}  // namespace
}  // namespace penpose::decode
