#include "core/animation/face/lids.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/rendered_track.h"

namespace penpose::animation {
namespace {

constexpr std::size_t k_frames = 300;
constexpr double k_fps = 30;

/// Openings of two eyes of 10 px: blinks of so many frames down and up, in which the points close by `closing`.
class Eyes {
 public:
  explicit Eyes(double noise_px = 0) : seen(2, std::vector<double>(k_frames, 10.0)) {
    tests::Shaker shake(5);
    for (auto& eye : seen) {
      for (double& one : eye) one += noise_px * shake();
    }
  }
  void blink(std::size_t at, double closing, std::size_t down = 3, std::size_t up = 3, bool left = true) {
    for (std::size_t e = left ? 0 : 1; e < 2; ++e) {
      for (std::size_t f = at - down; f <= at + up; ++f) {
        const double apart = std::abs(static_cast<double>(f) - static_cast<double>(at));
        seen[e][f] -= 10 * closing * (1 - apart / static_cast<double>(f < at ? down : up));
      }
    }
  }
  [[nodiscard]] EyeMotion motion(std::span<const double> column = {}) const {
    return find_eye_motion(seen, {}, confidence, k_fps, column, 0.3, doubt);
  }

  std::vector<std::vector<double>> seen;
  std::vector<double> confidence = std::vector<double>(k_frames, 1.0);
  std::vector<double> doubt = std::vector<double>(k_frames, 0.0);
};

TEST(Lids, ABlinkClosesHoweverLittleTheTrackersPointsDo) {
  for (const double closing : {0.3, 0.6, 1.0}) {
    Eyes eyes(0.2);
    for (const std::size_t at : {40U, 100U, 170U, 240U}) eyes.blink(at, closing);
    const EyeMotion motion = eyes.motion();
    EXPECT_EQ(motion.blinks.size(), 4U) << closing;
    EXPECT_NEAR(motion.full_dip, closing, 0.1);
    for (const std::size_t at : {40U, 100U, 170U, 240U}) {
      EXPECT_NEAR(motion.closed[0][at], 1.0, 0.15) << closing << " at " << at;
      EXPECT_NEAR(motion.closed[1][at], 1.0, 0.15) << closing << " at " << at;
      EXPECT_NEAR(motion.closed[0][at + 12], 0.0, 0.15);
    }
  }
}

TEST(Lids, ABlinkOfTwoFramesDownAndTwoUpSurvives) {
  Eyes eyes;
  for (const std::size_t at : {40U, 100U, 170U}) eyes.blink(at, 0.3, 2, 2);
  const EyeMotion motion = eyes.motion();
  EXPECT_GT(motion.closed[0][100], 0.85);
  EXPECT_LT(motion.closed[0][97], 0.2);
  EXPECT_LT(motion.closed[0][103], 0.2);
}

TEST(Lids, ABlinkThatIsHalfAsDeepAsTheOthersClosesHalf) {
  Eyes eyes;
  for (const std::size_t at : {40U, 100U, 240U, 270U}) eyes.blink(at, 0.5);
  eyes.blink(170, 0.25);
  EXPECT_NEAR(eyes.motion().closed[0][170], 0.5, 0.15);
}

TEST(Lids, AWinkStaysOneSided) {
  Eyes eyes(0.1);
  for (const std::size_t at : {40U, 100U, 240U}) eyes.blink(at, 0.4);
  eyes.blink(170, 0.4, 3, 3, false);
  const EyeMotion motion = eyes.motion();
  EXPECT_GT(motion.closed[1][170], 0.8);
  EXPECT_LT(motion.closed[0][170], 0.15);
}

TEST(Lids, EyesThatStayHalfClosedAreNoBlink) {
  Eyes eyes;
  for (const std::size_t at : {20U, 60U}) eyes.blink(at, 0.9);
  for (auto& eye : eyes.seen) {
    for (std::size_t f = 150; f < 230; ++f) eye[f] = 5.5;
  }
  const EyeMotion motion = eyes.motion();
  EXPECT_EQ(motion.blinks.size(), 2U);
  for (std::size_t f = 160; f < 220; ++f) EXPECT_NEAR(motion.closed[0][f], 0.5, 0.12) << f;
}

TEST(Lids, TremorAloneIsNoBlink) {
  const EyeMotion motion = Eyes(0.8).motion();
  EXPECT_TRUE(motion.blinks.empty());
}

TEST(Lids, TheTrackersOwnColumnTellsAShallowBlinkFromAShake) {
  Eyes eyes;
  for (const std::size_t at : {40U, 100U, 170U}) eyes.blink(at, 0.3);
  std::vector<double> column(k_frames, 0.0);
  for (const std::size_t at : {40U, 170U}) {
    for (std::size_t f = at - 2; f <= at + 2; ++f) column[f] = 0.5;
  }
  const EyeMotion motion = eyes.motion(column);
  EXPECT_EQ(motion.blinks, (std::vector<std::size_t>{40, 170}));
  EXPECT_EQ(eyes.motion().blinks.size(), 3U);
}

TEST(Lids, EyesAreNotWidenedWhereTheHeadIsInDoubt) {
  Eyes eyes;
  for (auto& eye : eyes.seen) {
    for (std::size_t f = 100; f < 200; ++f) eye[f] = 13;
  }
  EXPECT_LT(eyes.motion().closed[0][150], -0.1);
  eyes.doubt.assign(k_frames, 1.0);
  EXPECT_EQ(eyes.motion().closed[0][150], 0);
}

}  // namespace
}  // namespace penpose::animation
