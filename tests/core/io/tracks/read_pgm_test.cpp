#include "core/io/tracks/read_pgm.h"

#include <gtest/gtest.h>

#include "core/io/tracks/label_file.h"
#include "core/io/tracks/read_track.h"

namespace penpose::io {
namespace {

TEST(ReadPgm, ReadsTextAndBytes) {
  const auto text = read_pgm(base::as_bytes("P2\n# grey\n3 1 15\n0 5 15\n")).value();
  EXPECT_EQ(text.width, 3);
  EXPECT_EQ(text.pixels, (std::vector<std::uint8_t>{0, 85, 255}));
  EXPECT_EQ(read_pgm(base::as_bytes("P5 2 1 255\nab"))->pixels, (std::vector<std::uint8_t>{'a', 'b'}));
}

TEST(ReadPgm, RefusesWhatIsNone) {
  for (const char* text : {"P6 1 1 255\naaa", "P5 0 1 255\n", "P5 99999 1 255\n", "P5 2 2 65535\naaaaaaaa",
                           "P5 2 2 255\nabc", "P2 2 2 9\n1 2 3", "P2 2 2 9\n1 2 x 3 4 5"}) {
    EXPECT_FALSE(read_pgm(base::as_bytes(text)).ok()) << text;
  }
}

TEST(LabelFile, NamesPicturesAndFeatures) {
  const auto file = read_label_file(base::as_bytes(
      R"({"frames": [{"image": "a.png", "curves": {"b": [[0, 0], [1, 1]], "a": [[2, 2], [3, 3], [4, 4]]}}],
          "features": [["b", "a"]]})"));
  ASSERT_TRUE(file.ok()) << file.error().line();
  EXPECT_EQ(file->images, (std::vector<std::string>{"a.png"}));
  EXPECT_EQ(file->features[0].points, (std::vector<std::size_t>{3, 4, 0, 1, 2}));
  EXPECT_EQ(read_label_file(base::as_bytes(R"({"frames": [{"curves": {"b": [[0, 0], [1, 1]]}}]})")).error().place,
            "/frames/0/image");
  EXPECT_EQ(read_label_file(base::as_bytes(R"({"frames": []})")).error().what, "no picture is labelled");
  // Pictures are in no order of time.
  EXPECT_TRUE(read_label_file(base::as_bytes(R"({"frames": [
      {"image": "a.png", "time": 0, "curves": {"b": [[0, 0], [1, 1]]}},
      {"image": "b.png", "time": 1, "curves": {"b": [[0, 0], [1, 1]]}},
      {"image": "c.png", "time": 1, "curves": {"b": [[0, 0], [1, 1]]}}]})"))
                  .ok());
  const auto again = read_curve_track(base::as_bytes(write_curve_track(file->track, 25))).value();
  EXPECT_EQ(again.frames[0].points, file->track.frames[0].points);
}

}  // namespace
}  // namespace penpose::io
