#include "core/curve/stroke.h"

#include <gtest/gtest.h>

namespace penpose::curve {
namespace {

TEST(Stroke, GivesItsPositionsInOrder) {
  const Stroke stroke{{{1, 2}, 0.5, 100}, {{3, 4}, 0.7, 200}, {{3, 4}, 0.9, 300}};
  EXPECT_EQ(positions_of(stroke), (std::vector<PxPoint>{{1, 2}, {3, 4}, {3, 4}}));
  EXPECT_TRUE(positions_of({}).empty());
}

}  // namespace
}  // namespace penpose::curve
