#include "core/tracking/weight_animation.h"

#include <gtest/gtest.h>

#include "core/io/tracks/track_formats.h"
#include "tests/support/models/square_with_shapes.h"

namespace penpose::tracking {
namespace {

using tests::square_with_shapes;

WeightAnimation played(const document::Model& model, const char* name, const char* format) {
  animation::WeightTrack track;
  track.names = {name};
  track.frames = {{0, true, {0.5}}};
  const auto map = io::read_bundled_map(*io::track_format_named(format)).value();
  return animate_weights(model, track, map, false, 0);
}

TEST(WeightAnimation, ANameThatAVmdFileCutOffIsTheOneControlThatBeginsSo) {
  const auto model = square_with_shapes({"mouthUnknownLeft", "mouthUnknownRight", "other"});
  const auto cut = played(model, "mouthUnknownLef", "vmd");
  EXPECT_TRUE(cut.unmatched.empty());
  EXPECT_DOUBLE_EQ(cut.poses[0][0], 0.5);
  EXPECT_EQ(played(model, "mouthUnknownLef", "arkit").unmatched.size(), 1U) << "other files cut nothing off";
  EXPECT_EQ(played(model, "mouthUnknownLe", "vmd").unmatched.size(), 1U) << "a shorter name is a whole one";
  const auto two = square_with_shapes({"mouthUnknownLeft", "mouthUnknownLefty"});
  EXPECT_EQ(played(two, "mouthUnknownLef", "vmd").unmatched.size(), 1U) << "two controls begin so";
}

TEST(WeightAnimation, ExpressionsAreShownAsTheirAvatarSays) {
  auto model = square_with_shapes({"s0", "s1", "s2"});
  model.expressions = {{"aa", {{0, 1}}}, {"blinkLeft", {{1, 1}}}, {"happy", {{2, 1}}}};
  model.expressions[1].is_binary = true;
  model.expressions[2].mouth = document::ExpressionOverride::blend;
  animation::WeightTrack track;
  track.names = {"JawOpen", "EyeBlinkLeft", "happy"};
  track.frames = {{0, true, {0.8, 0.4, 0}}, {0.1, true, {0.8, 0.6, 0.25}}};
  const auto map = io::read_bundled_map(*io::track_format_named("arkit")).value();
  const auto played = animate_weights(model, track, map, false, 0);
  EXPECT_EQ(played.poses[0], (rig::Pose{0.8, 0, 0}));
  EXPECT_NEAR(played.poses[1][0], 0.6, 1e-12);
  EXPECT_EQ(played.poses[1][1], 1);
  EXPECT_EQ(played.poses[1][2], 0.25);
}

}  // namespace
}  // namespace penpose::tracking
