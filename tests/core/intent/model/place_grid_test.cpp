#include "core/intent/model/place_grid.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::intent {
namespace {

using geometry::ModelPoint;

std::vector<std::size_t> visited(const PlaceGrid& grid, const ModelPoint& place, std::uint32_t begin = 0,
                                 std::uint32_t end = 100000) {
  std::vector<std::size_t> out;
  grid.visit_near(place, begin, end, [&](std::size_t i) { out.push_back(i); });
  std::stable_sort(out.begin(), out.end());
  return out;
}

TEST(PlaceGrid, GivesEveryPlaceWithinReachOnce) {
  tests::Random random(3);
  for (const double reach : {0.001, 0.05, 0.3, 5.0}) {
    std::vector<ModelPoint> places;
    for (int i = 0; i < 400; ++i) places.push_back(ModelPoint{7, 0, -2} + random.vector(1) * ModelPoint{1, 1, 0.1});
    // Some lie a whole number of cells apart.
    for (int i = 0; i < 50; ++i) places.push_back(places[0] + ModelPoint{reach, 0, 0} * static_cast<double>(i - 25));
    const PlaceGrid grid(places, reach);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const ModelPoint place = i % 3 == 0 ? places[i] + random.vector(reach) : places[i];
      const auto found = visited(grid, place);
      EXPECT_TRUE(std::adjacent_find(found.begin(), found.end()) == found.end());
      for (std::size_t k = 0; k < places.size(); ++k) {
        if (geometry::distance(place, places[k]) <= reach) {
          EXPECT_TRUE(std::binary_search(found.begin(), found.end(), k)) << reach << " " << i << " " << k;
        }
      }
    }
  }
}

TEST(PlaceGrid, LooksAtFewOfManyPlaces) {
  tests::Random random(4);
  std::vector<ModelPoint> places;
  for (int i = 0; i < 10000; ++i) places.push_back(random.vector(1));
  const PlaceGrid grid(places, 0.05);
  EXPECT_LT(visited(grid, {0.1, 0.2, 0.3}).size(), 100U);
}

TEST(PlaceGrid, GivesOnlyTheNumbersAskedFor) {
  const std::vector<ModelPoint> places(10, ModelPoint{1, 1, 1});
  const PlaceGrid grid(places, 1);
  EXPECT_EQ(visited(grid, {1, 1, 1}, 3, 6), (std::vector<std::size_t>{3, 4, 5}));
  EXPECT_EQ(visited(grid, {1, 1, 1}, 8).size(), 2U);
  EXPECT_TRUE(visited(grid, {1, 1, 1}, 5, 5).empty());
}

TEST(PlaceGrid, KnowsNoPlaceThatIsNoNumber) {
  const std::vector<ModelPoint> places{{NAN, 0, 0}, {1, 2, 3}, {0, INFINITY, 0}};
  const PlaceGrid grid(places, 1e6);
  EXPECT_EQ(visited(grid, {0, 0, 0}), std::vector<std::size_t>{1});
  EXPECT_TRUE(visited(PlaceGrid({}, 1), {0, 0, 0}).empty());
}

}  // namespace
}  // namespace penpose::intent
