#include <cmath>
#include <gtest/gtest.h>

#include "core/intent/solve.h"
#include "tests/core/intent/face.h"

// What is read in a line that no control takes on as it is drawn.

namespace penpose::intent {
namespace {

using tests::Face;
using tests::fade;
using tests::Line;

/// A smile drawn with its middle below where it was: what moves the lips up everywhere cannot be brought there.
Line deep_smile(const Face& face, double down_px) {
  Line line = face.seen(Face::mouth(), face.pose({{"smile", 0.8}}));
  for (auto& p : line) p.y += down_px;
  return line;
}

TEST(Shape, ASmileDrawnDeeperThanTheRigsIsASmile) {
  const Face face = tests::smiling_face(false);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Line line = tests::shaken(deep_smile(face, 37), 1, seed);
    const Solution solution = face.read(Face::mouth(), line);
    EXPECT_EQ(solution.moved, std::vector<std::size_t>{face.number("smile")}) << seed;
    EXPECT_GT(solution.pose[face.number("smile")], 0.1) << seed << ": as near as it comes";
  }
}

TEST(Shape, ALineMovedAsAWholeIsStillThat) {
  const Face face = tests::smiling_face(false);
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const rig::Pose answer = face.pose({{"browLeft", 0.7}});
    const Line line = tests::shaken(face.seen(Face::left_brow(), answer), 1.5, seed);
    const Solution solution = face.read(Face::left_brow(), line);
    EXPECT_EQ(solution.moved, std::vector<std::size_t>{face.number("browLeft")}) << seed;
    EXPECT_LT(face.error(solution.pose, answer), 0.15) << seed;
  }
}

TEST(Shape, OfAPairThatTheStrokesSeeOneSideOfThatSideMoves) {
  Face face(1);
  const auto raise = [](double side) {
    return [=](double x, double y) {
      const double near = fade(0.5 * (y - 0.5)) * (x * side > 0 ? 1.0 : 0.04);
      return geometry::ModelVector{0, 0.15 * near, 0};
    };
  };
  face.control("raiseLeft", raise(-1)).control("raiseRight", raise(1));
  face.ready();
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Line line = tests::shaken(face.seen(Face::left_brow(), face.pose({{"raiseLeft", 0.9}})), 2, seed);
    const Solution solution = face.read(Face::left_brow(), line);
    EXPECT_EQ(solution.moved, std::vector<std::size_t>{face.number("raiseLeft")}) << seed;
  }
}

}  // namespace
}  // namespace penpose::intent
