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

}  // namespace
}  // namespace penpose::tracking
