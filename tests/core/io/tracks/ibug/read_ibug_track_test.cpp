#include <gtest/gtest.h>

#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "tests/support/track_texts.h"

namespace penpose::io {
namespace {

using tests::bytes;
using tests::s;
using tests::Table;
using tests::two_frames;

TEST(ReadIbug, ReadsBlocksTablesAndBareRows) {
  std::string block = "version: 1\nn_points:  68\n{\n";
  std::string bare;
  for (int i = 0; i < 68; ++i) {
    block += std::to_string(i) + " " + std::to_string(i + 5) + "\n";
    if (i > 0) bare += ",";
    bare += std::to_string(i) + "," + std::to_string(i + 5);
  }
  block += "}\n";
  for (const std::string& text : {block + block, s(bare.c_str()) + "\n" + bare + "\n"}) {
    const auto track = read_ibug_track(bytes(text));
    ASSERT_TRUE(track.ok()) << track.error().line();
    ASSERT_EQ(track->frames.size(), 2U);
    EXPECT_EQ(track->frames[1].points[9], (animation::PxPoint{9, 14}));
  }
  Table table = two_frames();
  EXPECT_EQ(read_ibug_track(bytes(table.text()))->frames.size(), 2U);
  EXPECT_EQ(read_ibug_track(bytes("n_points: 29\n{\n1 2\n}\n")).error().place, "line 1");
  EXPECT_EQ(read_ibug_track(bytes(block + "{\n1,5 2,5\n}\n")).error().place, "line 74");
  EXPECT_FALSE(read_ibug_track(bytes(block + "{\n1 2\n}\n"))->frames[1].found());
}

}  // namespace
}  // namespace penpose::io
