#include "core/curve/nearest_place.h"

#include <gtest/gtest.h>
#include <vector>

namespace penpose::curve {
namespace {

TEST(NearestPlace, IsOnTheSegmentThatIsNearest) {
  const std::vector<PxPoint> corner{{0, 0}, {10, 0}, {10, 20}};
  const PolylinePlace on_second = nearest_place(corner, {12, 5});
  EXPECT_EQ(on_second.segment, 1U);
  EXPECT_DOUBLE_EQ(on_second.fraction, 0.25);
  const PolylinePlace before = nearest_place(corner, {-3, 1});
  EXPECT_EQ(before.segment, 0U);
  EXPECT_EQ(before.fraction, 0);
}

TEST(NearestPlace, OfEquallyNearOnesTheFirst) {
  const std::vector<PxPoint> there_and_back{{0, 0}, {10, 0}, {0, 0}};
  const PolylinePlace place = nearest_place(there_and_back, {4, 1});
  EXPECT_EQ(place.segment, 0U);
  EXPECT_DOUBLE_EQ(place.fraction, 0.4);
}

}  // namespace
}  // namespace penpose::curve
