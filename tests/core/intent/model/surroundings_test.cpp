#include "core/intent/model/surroundings.h"

#include <gtest/gtest.h>
#include <limits>

namespace penpose::intent {
namespace {

using geometry::ModelPoint;
using Numbers = std::vector<std::uint32_t>;

std::vector<ModelPoint> row_of(std::size_t count) {
  std::vector<ModelPoint> places;
  for (std::size_t i = 0; i < count; ++i) places.emplace_back(static_cast<double>(count - 1 - i), 0.0, 0.0);
  return places;
}

TEST(Surroundings, FindsWhatLiesWithinReachOfAnyPlace) {
  const Surroundings around(row_of(20));  // vertex v at x = 19 - v
  const std::vector<ModelPoint> places{{3, 0.5, 0}, {10, 0, 0}};
  EXPECT_EQ(around.near(places, 1.0, 100), (Numbers{8, 9, 10, 16}));
  EXPECT_EQ(around.near(places, 1.2, 100), (Numbers{8, 9, 10, 15, 16, 17}));
  EXPECT_TRUE(around.near({}, 5.0, 100).empty());
}

TEST(Surroundings, TakesNoMoreThanAskedForEvenly) {
  const Surroundings around(row_of(20));
  const std::vector<ModelPoint> places{{9.5, 0, 0}};
  const auto few = around.near(places, 30.0, 4);
  EXPECT_EQ(few, (Numbers{0, 5, 10, 15}));
}

TEST(Surroundings, WhatIsNotFiniteIsNowhere) {
  auto places = row_of(4);
  places[1].y = std::numeric_limits<double>::quiet_NaN();
  const Surroundings around(places);
  EXPECT_EQ(around.near(std::vector<ModelPoint>{{1, 0, 0}}, 10, 100), (Numbers{0, 2, 3}));
}

}  // namespace
}  // namespace penpose::intent
