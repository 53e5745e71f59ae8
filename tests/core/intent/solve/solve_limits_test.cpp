#include <gtest/gtest.h>

#include "core/intent/live.h"
#include "core/intent/solve.h"
#include "tests/core/intent/face.h"

// Lines that ask for more than the controls can: what they mean goes as far as it can, and nothing else helps out.

namespace penpose::intent {
namespace {

using tests::Face;
using tests::Line;
using tests::Points;

/// The line of a curve where controls would take it beyond their limits.
Line beyond(const Face& face, const Points& points, const char* name, double times) {
  const Line rest = face.seen(points, rig::rest_pose(*face.rig));
  Line line = face.seen(points, face.pose({{name, 1.0}}));
  for (std::size_t i = 0; i < line.size(); ++i) line[i] = rest[i] + (line[i] - rest[i]) * times;
  return line;
}

TEST(BeyondLimits, TheControlThatIsMeantGoesToItsLimitAlone) {
  const Face face = tests::usual_face();
  for (const char* name : {"lipUp", "cornerLeft"}) {
    for (const double times : {1.4, 2.0}) {
      for (std::uint64_t seed = 0; seed < 3; ++seed) {
        const Line line = tests::shaken(beyond(face, Face::mouth(), name, times), 1.5, seed);
        const Solution solution = face.solve(face.problem({face.drawn(Face::mouth(), line)}));
        ASSERT_EQ(solution.moved, std::vector<std::size_t>{face.number(name)}) << name << " x" << times;
        EXPECT_EQ(solution.at_limit, solution.moved);
        EXPECT_EQ(solution.pose[face.number(name)], 1.0);
      }
    }
  }
}

TEST(BeyondLimits, LiveTooNothingElseJoins) {
  const Face face = tests::usual_face();
  const Line line = tests::shaken(beyond(face, Face::mouth(), "lipUp", 1.8), 1, 3);
  auto poser =
      LivePoser::start(*face.rig, measure_whole_model(*face.rig), face.problem({face.drawn(Face::mouth(), line)}));
  ASSERT_TRUE(poser.ok());
  for (int i = 0; i < 4; ++i) poser->follow_whole(line);
  EXPECT_EQ(poser->pose(), face.pose({{"lipUp", 1.0}}));
}

TEST(BeyondLimits, TwoControlsThatAreMeantBothGo) {
  const Face face = tests::usual_face();
  const rig::Pose both = face.pose({{"cornerLeft", 1.0}, {"cornerRight", 1.0}});
  const Line rest = face.seen(Face::mouth(), rig::rest_pose(*face.rig));
  Line line = face.seen(Face::mouth(), both);
  for (std::size_t i = 0; i < line.size(); ++i) line[i] = rest[i] + (line[i] - rest[i]) * 1.6;
  EXPECT_EQ(face.solve(face.problem({face.drawn(Face::mouth(), line)})).pose, both);
}

}  // namespace
}  // namespace penpose::intent
