#include "core/io/tracks/map_file.h"

#include <gtest/gtest.h>

#include "core/io/tracks/track_formats.h"

namespace penpose::io {
namespace {

base::Result<MapFile> read(const char* text) { return read_map_file(base::as_bytes(text)); }

TEST(MapFile, ReadsEveryMember) {
  const auto map = read(R"({"format": "openface", "head": "apply", "stable": [27, "eyes"], "turning": [31],
    "free": ["jawOpen"], "curves": [
    {"track": [48, 54], "reference": "lip_upper", "anchor": [62, "nose"], "meets": "lip_lower", "weight": 2, "gain": 0.5},
    {"track": "mouth", "reference": [3, 4, 5]}]})");
  ASSERT_TRUE(map.ok()) << map.error().line();
  EXPECT_EQ(map->format->name, "openface");
  EXPECT_TRUE(map->apply_head);
  ASSERT_EQ(map->curves.size(), 2U);
  EXPECT_EQ(std::get<0>(map->curves[0].track), (std::vector<std::size_t>{48, 54}));
  EXPECT_EQ(std::get<1>(map->curves[0].reference), "lip_upper");
  ASSERT_EQ(map->curves[0].anchor.size(), 2U);
  EXPECT_EQ(std::get<0>(map->curves[0].anchor[0]), 62U);
  EXPECT_EQ(std::get<1>(map->curves[0].anchor[1]), "nose");
  EXPECT_EQ(map->curves[0].weight, 2);
  EXPECT_EQ(map->curves[0].gain, 0.5);
  EXPECT_EQ(map->curves[0].meets, "lip_lower");
  EXPECT_EQ(std::get<1>(map->curves[1].track), "mouth");
  EXPECT_EQ(std::get<1>(map->stable[1]), "eyes");
  EXPECT_EQ(map->free.size(), 1U);
}

TEST(MapFile, SaysWhereItIsWrong) {
  const auto place = [](const char* text) { return read(text).error().place; };
  EXPECT_EQ(place("[]"), "/");
  EXPECT_EQ(place("{}"), "/");
  EXPECT_EQ(place(R"({"format": "dlib"})"), "/format");
  EXPECT_EQ(place(R"({"format": "openface"})"), "/");
  EXPECT_EQ(place(R"({"format": "openface", "curves": []})"), "/curves");
  EXPECT_EQ(place(R"({"format": "openface", "curves": [{"track": [1, 2]}]})"), "/curves/0");
  EXPECT_EQ(place(R"({"format": "openface", "curves": [{"track": [1, -2], "reference": "a"}]})"), "/curves/0/track/1");
  EXPECT_EQ(place(R"({"format": "openface", "curves": [{"track": [1], "reference": "a"}]})"), "/curves/0/track");
  EXPECT_EQ(place(R"({"format": "openface", "curves": [{"track": [1, 2], "reference": "a", "weight": 0}]})"),
            "/curves/0/weight");
  EXPECT_EQ(place(R"({"format": "arkit", "head": "turn"})"), "/head");
  EXPECT_EQ(place(R"({"format": "arkit", "stable": [true]})"), "/stable/0");
}

TEST(MapFile, EveryBundledMapIsGood) {
  for (const TrackFormat& format : track_formats()) {
    SCOPED_TRACE(format.name);
    const auto text = bundled_map(format.name);
    const auto map = read_map_file(base::as_bytes(text));
    ASSERT_TRUE(map.ok()) << map.error().line();
    EXPECT_EQ(map->format, &format);
    EXPECT_EQ(map->curves.size(), format.has_values ? 0U : 10U);
  }
}

}  // namespace
}  // namespace penpose::io
