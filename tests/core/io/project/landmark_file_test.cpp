#include "core/io/project/landmark_file.h"

#include <gtest/gtest.h>

#include "tests/support/shared_data.h"

namespace penpose::io {
namespace {

std::string place_of_error(std::string_view text) {
  const auto curves = read_landmarks(base::as_bytes(text));
  return curves ? "(no error)" : curves.error().place;
}

TEST(LandmarkFile, ReadsCurvesInTheOrderOfTheirNames) {
  const auto curves =
      read_landmarks(base::as_bytes(R"({"curves": {"lip": {"vertices": [5, 7, 9]}, "brow": {"vertices": [1, 2]}}})"));
  ASSERT_TRUE(curves.ok()) << curves.error().line();
  ASSERT_EQ(curves->size(), 2U);
  EXPECT_EQ((*curves)[0].name, "brow");
  EXPECT_EQ((*curves)[1].vertices, (std::vector<std::uint32_t>{5, 7, 9}));
}

TEST(LandmarkFile, NamesThePlaceOfAFault) {
  EXPECT_EQ(place_of_error("[]"), "/curves");
  EXPECT_EQ(place_of_error(R"({"curves": [1]})"), "/curves");
  EXPECT_EQ(place_of_error(R"({"curves": {"lip": 3}})"), "/curves/lip/vertices");
  EXPECT_EQ(place_of_error(R"({"curves": {"lip": {"vertices": [3]}}})"), "/curves/lip/vertices");
  EXPECT_EQ(place_of_error(R"({"curves": {"lip": {"vertices": [3, -4]}}})"), "/curves/lip/vertices/1");
}

TEST(SharedLandmarkFiles, HaveFourteenCurves) {
  if (!tests::has_shared()) GTEST_SKIP();
  const auto curves = read_landmarks(tests::read_file(tests::shared_dir() / "meshes" / "ict_face_landmarks.json"));
  ASSERT_TRUE(curves.ok()) << curves.error().line();
  EXPECT_EQ(curves->size(), 14U);
}

}  // namespace
}  // namespace penpose::io
