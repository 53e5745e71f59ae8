#include "core/io/tracks/openface/openface_units.h"

#include <gtest/gtest.h>

#include "core/io/tracks/track_formats.h"
#include "tests/support/track_texts.h"

namespace penpose::io {
namespace {

using tests::bytes;

TEST(OpenfaceUnits, AreReadWithoutPoints) {
  const std::string text =
      "frame, timestamp, confidence, success, pose_Rx, pose_Ry, AU12_r, AU26_r, AU12_c, AU28_c\n"
      "0, 0.00, 0.98, 1, 0.1, 0.2, 5.0, 2.5, 1, 1\n1, 0.04, 0.98, 1, 0, 0, 1.0, 9, 1, 0\n2, 0.08, 0, 0, 0, 0, 0, 0, 0, "
      "0\n";
  EXPECT_EQ(format_of_track(bytes(text))->name, "openface");
  const auto track = read_openface_units(bytes(text)).value();
  EXPECT_EQ(track.names, (std::vector<std::string>{"AU12", "AU26", "AU28", "HeadPitch", "HeadYaw"}));
  EXPECT_EQ(track.frames[0].values, (std::vector<double>{1, 0.5, 1, 0.1, -0.2}));
  EXPECT_EQ(track.frames[1].values[1], 1) << "no more than full";
  EXPECT_NEAR(track.frames[1].time_s, 0.04, 1e-9);
  EXPECT_FALSE(track.frames[2].found);
  const auto read = read_track(bytes(text), nullptr, {});
  EXPECT_TRUE(read && std::holds_alternative<animation::WeightTrack>(read->track));
}

TEST(OpenfaceUnits, OfSeveralFacesTheFirstIsRead) {
  const auto track = read_openface_units(bytes("frame,face_id,AU12\n0,3,0.5\n0,4,1\n1,3,0.25\n")).value();
  ASSERT_EQ(track.frames.size(), 2U);
  EXPECT_EQ(track.frames[1].values[0], 0.25);
  EXPECT_EQ(track.notes.size(), 1U);
  EXPECT_EQ(read_openface_units(bytes("AU12_r\nx\n")).error().place, "line 2");
  EXPECT_FALSE(read_openface_units(bytes("a,b\n1,2\n")));
}

}  // namespace
}  // namespace penpose::io
