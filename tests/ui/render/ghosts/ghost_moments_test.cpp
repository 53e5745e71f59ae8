#include "ui/render/ghosts/ghost_moments.h"

#include <gtest/gtest.h>

// Which faces are shown beside that of a moment.

namespace penpose::render {
namespace {

document::Timeline keys_at(std::initializer_list<double> moments_s) {
  document::Timeline timeline;
  for (const double time_s : moments_s) {
    document::PoseKey key;
    key.time_s = time_s;
    timeline.keys.push_back(key);
  }
  return timeline;
}

TEST(GhostMoments, TheNearestKeysOfEachSideAreShownAsManyAsAsked) {
  const auto timeline = keys_at({0, 1, 2, 3});
  GhostLook look;
  look.before = 2;
  look.after = 1;
  EXPECT_EQ(ghost_moments(timeline, 2.5, 24, look), (std::vector<GhostMoment>{{1, -2}, {2, -1}, {3, 1}}));
  EXPECT_EQ(ghost_moments(timeline, 2, 24, look), (std::vector<GhostMoment>{{0, -2}, {1, -1}, {3, 1}}))
      << "the key under the playhead is the face itself";
  look.before = 0;
  look.after = 9;
  EXPECT_EQ(ghost_moments(timeline, 1.5, 24, look), (std::vector<GhostMoment>{{2, 1}, {3, 2}})) << "no more than are";
  EXPECT_TRUE(ghost_moments({}, 1, 24, look).empty());
}

TEST(GhostMoments, EverySoManyFramesAreShownBetweenTheFirstKeyAndTheLast) {
  GhostLook look;
  look.steps = GhostSteps::frames;
  look.before = look.after = 2;
  look.every = 3;
  EXPECT_EQ(ghost_moments(keys_at({0, 1}), 0.5, 12, look),
            (std::vector<GhostMoment>{{0, -2}, {0.25, -1}, {0.75, 1}, {1, 2}}));
  EXPECT_EQ(ghost_moments(keys_at({0, 1}), 0.25, 12, look), (std::vector<GhostMoment>{{0, -1}, {0.5, 1}, {0.75, 2}}))
      << "before the first key nothing moves";
}

}  // namespace
}  // namespace penpose::render
