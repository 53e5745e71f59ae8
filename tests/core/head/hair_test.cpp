#include <gtest/gtest.h>

#include "core/head/parts.h"

namespace penpose::head {
namespace {

TEST(Hair, LeavesTheFaceFree) {
  const auto half = make_half();
  ASSERT_TRUE(half);
  const Surface hair = make_hair(make_skin(*half).bare);
  for (const ModelPoint& p : hair.points) {
    if (p.z < 6) continue;
    EXPECT_GT(p.y, 5) << p.x << " " << p.z;
  }
}

TEST(Hair, CoversTheCrown) {
  const auto half = make_half();
  ASSERT_TRUE(half);
  const Skin skin = make_skin(*half);
  double hair_top = 0;
  double skin_top = 0;
  for (const ModelPoint& p : make_hair(skin.bare).points) hair_top = std::max(hair_top, p.y);
  for (const ModelPoint& p : skin.bare.points) skin_top = std::max(skin_top, p.y);
  EXPECT_GT(hair_top, skin_top + 0.3);
}

}  // namespace
}  // namespace penpose::head
