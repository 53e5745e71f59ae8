#include <gtest/gtest.h>
#include <string_view>

#include "tests/support/c_desk.h"

namespace penpose::tests {
namespace {

constexpr std::string_view k_take =
    "Timecode,BlendShapeCount,Lift,TongueOut\n0:0:0:0,2,0.25,0\n0:0:0:1,2,nan,0\n0:0:0:2,2,0.5,0\n";

struct Take {
  CDesk desk;
  penpose_handle animation = 0;
  penpose_animated animated{};

  std::int32_t animate(const char* map = nullptr, const penpose_animate_options* options = nullptr) {
    return penpose_animate(desk.open, desk.sheet, k_take.data(), k_take.size(), map, options, &animation, &animated,
                           &desk.error);
  }
};

TEST(CAnimations, FramesNotesAndTheCharacterOfATrack) {
  Take take;
  const std::string before = take.desk.state();
  ASSERT_EQ(take.animate(), PENPOSE_OK) << take.desk.error.message;
  EXPECT_EQ(take.desk.state(), before);
  EXPECT_EQ(take.animated.frames, 3U);
  EXPECT_EQ(take.animated.held, 1U);
  EXPECT_EQ(take.animated.unmatched, 1U);
  EXPECT_EQ(take.animated.rest, -1);
  EXPECT_GT(take.animated.fps, 0);

  const std::size_t width = take.desk.pose().size();
  std::vector<double> times(3, -1);
  std::vector<double> values(3 * width, -1);
  std::size_t count = 0;
  penpose_library* open = take.desk.open;
  EXPECT_EQ(penpose_animation_frames(open, take.animation, nullptr, nullptr, 0, &count, nullptr), PENPOSE_OK);
  EXPECT_EQ(count, 3U);
  EXPECT_EQ(penpose_animation_frames(open, take.animation, times.data(), values.data(), 2, &count, nullptr),
            PENPOSE_TOO_SMALL);
  EXPECT_EQ(values[0], -1);
  ASSERT_EQ(penpose_animation_frames(open, take.animation, times.data(), values.data(), 3, &count, nullptr),
            PENPOSE_OK);
  EXPECT_EQ(values[0], 0.25);
  EXPECT_EQ(values[width], 0.25) << "what shows no face keeps the pose before";
  EXPECT_EQ(values[2 * width], 0.5);
  EXPECT_LT(times[1], times[2]);

  std::size_t size = 0;
  ASSERT_EQ(penpose_animation_notes(open, take.animation, nullptr, 0, &size, nullptr), PENPOSE_OK);
  std::string notes(size, ' ');
  ASSERT_EQ(penpose_animation_notes(open, take.animation, notes.data(), size, &size, nullptr), PENPOSE_OK);
  EXPECT_NE(notes.find("line 3"), std::string::npos) << notes;

  penpose_handle made = 0;
  ASSERT_EQ(penpose_animation_character(open, take.animation, &made, nullptr), PENPOSE_OK);
  EXPECT_NE(take.desk.state(made), before);
  EXPECT_EQ(take.desk.pose(made)[0], 0.25);
  EXPECT_EQ(penpose_free(open, take.animation, nullptr), PENPOSE_OK);
  EXPECT_EQ(penpose_animation_character(open, take.animation, &made, nullptr), PENPOSE_BAD_HANDLE);
}

TEST(CAnimations, AMapIsNamedOrGivenAsItsText) {
  Take take;
  ASSERT_EQ(take.animate("arkit"), PENPOSE_OK) << take.desk.error.message;
  ASSERT_EQ(take.animate(R"({"format": "arkit", "names": {"TongueOut": "lean"}})"), PENPOSE_OK)
      << take.desk.error.message;
  EXPECT_EQ(take.animated.unmatched, 0U);
  EXPECT_EQ(take.animate("openface"), PENPOSE_REFUSED);
  EXPECT_EQ(take.animate("nothing"), PENPOSE_REFUSED);
}

TEST(CAnimations, OptionsOutOfTheirRangesAreRefused) {
  Take take;
  const auto with = [&](auto change) {
    penpose_animate_options options = PENPOSE_ANIMATE_DEFAULTS;
    change(options);
    const std::int32_t status = take.animate(nullptr, &options);
    EXPECT_EQ(status == PENPOSE_OK, take.desk.error.message[0] == '\0');
    return status;
  };
  EXPECT_EQ(with([](auto&) {}), PENPOSE_OK);
  EXPECT_EQ(with([](auto& o) { o.fps = 30; }), PENPOSE_OK);
  EXPECT_EQ(with([](auto& o) { o.fps = -1; }), PENPOSE_REFUSED);
  EXPECT_EQ(with([](auto& o) { o.smooth_s = 61; }), PENPOSE_REFUSED);
  EXPECT_EQ(with([](auto& o) { o.least_confidence = 2; }), PENPOSE_REFUSED);
  EXPECT_EQ(with([](auto& o) { o.tremor_px = -2; }), PENPOSE_REFUSED);
  EXPECT_EQ(with([](auto& o) { o.curves = "{"; }), PENPOSE_REFUSED);
  EXPECT_EQ(with([](auto& o) { o.head = 3; }), PENPOSE_BAD_ARGUMENT);
  EXPECT_EQ(with([](auto& o) { o.neutral = -2; }), PENPOSE_BAD_ARGUMENT);
  EXPECT_EQ(with([](auto& o) { o.picture[0] = 640; }), PENPOSE_BAD_ARGUMENT);
  penpose_handle animation = 0;
  EXPECT_EQ(
      penpose_animate(take.desk.open, take.desk.sheet, nullptr, 5, nullptr, nullptr, &animation, nullptr, nullptr),
      PENPOSE_BAD_ARGUMENT);
  EXPECT_EQ(penpose_animate(take.desk.open, take.desk.sheet, "", 0, nullptr, nullptr, &animation, nullptr, nullptr),
            PENPOSE_REFUSED);
  EXPECT_EQ(penpose_animate(take.desk.open, take.desk.sheet, k_take.data(), k_take.size(), nullptr, nullptr, nullptr,
                            nullptr, nullptr),
            PENPOSE_BAD_ARGUMENT);
}

}  // namespace
}  // namespace penpose::tests
