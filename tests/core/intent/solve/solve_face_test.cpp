#include <gtest/gtest.h>

#include "core/intent/solve.h"
#include "tests/core/intent/face.h"

// What an artist draws and no pose of the rig meets: the control that is meant goes some of the way, and nothing helps
// it.

namespace penpose::intent {
namespace {

using tests::Face;
using tests::fade;
using tests::Line;
using Moved = std::vector<std::size_t>;

TEST(FaceLines, TheHeadIsNotTurnedForABrow) {
  Face face;
  face.bump("browLeft", -0.4, 0.5, {0, 0.1, 0}).bump("browRight", 0.4, 0.5, {0, 0.1, 0});
  face.ready(tests::chain_skeleton(*face.mesh, 2, 0.9));
  for (const double px : {8.0, 20.0, 60.0}) {
    Line line = face.seen(Face::left_brow(), rig::rest_pose(*face.rig));
    for (PxPoint& p : line) p.y -= px;
    const Solution solution = face.solve(face.problem({face.drawn(Face::left_brow(), tests::shaken(line, 0.7, 5))}));
    EXPECT_EQ(solution.moved, Moved{face.number("browLeft")}) << px << ": as far as it goes";
  }
}

TEST(FaceLines, OfASumAndItsPartThePartIsMeant) {
  Face face;
  const auto below = [](double y) { return y < 0 ? y * y * (1 + y / 2) : 0.0; };
  const auto jaw = [=](double y) { return geometry::ModelVector{0, -0.8 * below(y), 0}; };
  const auto lips = [](double x, double y) {
    return geometry::ModelVector{0, 0, std::abs(x) < 0.5 ? 0.1 * fade(y + 0.4) : 0.0};
  };
  face.control("jawOpen", [=](double, double y) { return jaw(y); });
  face.control("lips", lips);
  face.control("viseme", [=](double x, double y) { return jaw(y) * 0.9 + lips(x, y) * 0.8; });
  face.ready();
  Line line = face.seen(Face::mouth(), face.pose({{"jawOpen", 0.4}}));
  const Solution solution = face.solve(face.problem({face.drawn(Face::mouth(), tests::shaken(line, 0.7, 2))}));
  EXPECT_EQ(solution.moved, Moved{face.number("jawOpen")});
}

TEST(FaceLines, HowWideALineIsDrawnIsAWishLikeHowHigh) {
  // What is drawn half as narrow moves half as far.
  Face face;
  face.control("narrow", [](double x, double y) {
    return geometry::ModelVector{std::abs(x) < 0.7 ? -0.4 * x * fade(y + 0.4) : 0.0, 0, 0};
  });
  // Others could move a little of the line.
  face.bump("browLeft", -0.4, 0.5, {0, 0.15, 0}).bump("chin", 0, -0.75, {0, -0.1, 0}).bump("lip", 0, -0.3, {0, 0.1, 0});
  face.ready();
  for (const double by : {0.25, 0.5, 1.0}) {
    const Line line = tests::shaken(face.seen(Face::mouth(), face.pose({{"narrow", by}})), 0.7, 7);
    const Solution solution = face.solve(face.problem({face.drawn(Face::mouth(), line)}));
    EXPECT_NEAR(solution.pose[face.number("narrow")], by, 0.12 * by + 0.05) << by;
  }
}

TEST(FaceLines, ALineWhereTheCurveIsMovesNothing) {
  const Face face = tests::usual_face();
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Line line = tests::shaken(face.seen(Face::mouth(), rig::rest_pose(*face.rig)), 1.0, seed);
    EXPECT_TRUE(face.solve(face.problem({face.drawn(Face::mouth(), line)})).moved.empty()) << seed;
  }
}

}  // namespace
}  // namespace penpose::intent
