#include "core/geometry/space.h"

#include <gtest/gtest.h>

namespace penpose::geometry {
namespace {

TEST(Space, MeasuresDistances) {
  EXPECT_EQ(distance(PxPoint{1, 2}, PxPoint{4, 6}), 5.0);
  EXPECT_EQ(distance(ModelPoint{1, 1, 1}, ModelPoint{3, 4, 7}), 7.0);
  EXPECT_EQ(length({2, 3, 6}), 7.0);
}

TEST(Space, PxPointsAddAndScale) {
  EXPECT_EQ((PxPoint{1, 2} + PxPoint{3, 5}), (PxPoint{4, 7}));
  EXPECT_EQ((PxPoint{1, 2} - PxPoint{3, 5}), (PxPoint{-2, -3}));
  EXPECT_EQ((PxPoint{1, 2} * 3.0), (PxPoint{3, 6}));
}

TEST(Space, AVectorWithoutLengthFallsBack) {
  EXPECT_EQ(normalized({0, 0, 5}), (ModelVector{0, 0, 1}));
  EXPECT_EQ(normalized({0, -2, 0}), (ModelVector{0, -1, 0}));
  EXPECT_EQ(normalized({0, 0, 0}), (ModelVector{0, 0, 1}));
  EXPECT_EQ(normalized({0, 0, 0}, {1, 0, 0}), (ModelVector{1, 0, 0}));
}

TEST(Box, GrowsAroundWhatIsAdded) {
  Box box;
  EXPECT_TRUE(box.empty());
  EXPECT_EQ(box.diagonal(), 0.0);
  box.add({1, 2, 3});
  EXPECT_FALSE(box.empty());
  EXPECT_EQ(box.diagonal(), 0.0);
  EXPECT_EQ(box.center(), (ModelPoint{1, 2, 3}));
  box.add({-1, 5, 9});
  EXPECT_EQ(box.minimum, (ModelPoint{-1, 2, 3}));
  EXPECT_EQ(box.maximum, (ModelPoint{1, 5, 9}));
  EXPECT_EQ(box.center(), (ModelPoint{0, 3.5, 6}));
  EXPECT_EQ(box.diagonal(), 7.0);
}

}  // namespace
}  // namespace penpose::geometry
