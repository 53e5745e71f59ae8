#include "core/io/project/camera_file.h"

#include <gtest/gtest.h>
#include <string>
#include <string_view>

namespace penpose::io {
namespace {

base::Result<geometry::CameraPose> read(std::string_view text) {
  return read_camera({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

TEST(CameraFile, ReadsAllFourKeys) {
  const auto pose =
      read(R"({"eye": [1, 2, 3], "look_at": [0, 0, 0.5], "up": [0, 0, 1], "vertical_fov_degrees": 40, "note": 1})");
  ASSERT_TRUE(pose.ok());
  EXPECT_EQ(pose->eye, geometry::ModelPoint(1, 2, 3));
  EXPECT_EQ(pose->look_at, geometry::ModelPoint(0, 0, 0.5));
  EXPECT_EQ(pose->up, geometry::ModelVector(0, 0, 1));
  EXPECT_EQ(pose->vertical_fov_degrees, 40);
}

TEST(CameraFile, UpAndAngleMayBeLeftOut) {
  const auto pose = read(R"({"eye": [0, 0, 3], "look_at": [0, 0, 0]})");
  ASSERT_TRUE(pose.ok());
  EXPECT_EQ(pose->up, geometry::ModelVector(0, 1, 0));
}

TEST(CameraFile, SaysWhereItIsWrong) {
  EXPECT_EQ(read(R"({"look_at": [0, 0, 0]})").error().place, "/eye");
  EXPECT_EQ(read(R"({"eye": [0, "a", 0], "look_at": [0, 0, 0]})").error().place, "/eye/1");
  EXPECT_EQ(read(R"({"eye": [0, 0], "look_at": [0, 0, 0]})").error().place, "/eye");
  EXPECT_EQ(read(R"({"eye": [0, 0, 1], "look_at": [0, 0, 0], "vertical_fov_degrees": 400})").error().place,
            "vertical_fov_degrees");
  for (const char* bad : {"", "[]", "{", "nonsense", R"({"eye": [0, 0, 1e999], "look_at": [0, 0, 0]})",
                          R"({"eye": [0, 0, 0], "look_at": [0, 0, 0]})"}) {
    EXPECT_FALSE(read(bad).ok()) << bad;
  }
  EXPECT_FALSE(read(std::string(60000, '[')).ok());
}

}  // namespace
}  // namespace penpose::io
