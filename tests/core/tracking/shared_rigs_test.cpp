#include <algorithm>
#include <gtest/gtest.h>

#include "core/io/model/read_model.h"
#include "core/tracking/animate.h"
#include "tests/support/shared_data.h"

namespace penpose::tracking {
namespace {

/// A track and a model of people who reported what went wrong, in the folder of their case.
base::Result<Animated> animate_case(const std::string& folder, const std::string& model, const std::string& track,
                                    const AnimateOptions& options = {}, const char* format = nullptr) {
  const auto place = tests::shared_dir() / "cases" / "rigs" / folder;
  const auto no_file = [](const std::string&) -> base::Result<std::vector<std::uint8_t>> {
    return base::Error{"there is no other file", "", ""};
  };
  auto read = io::read_model(tests::read_file(place / model), model, no_file);
  if (!read) return read.error();
  auto tracked =
      io::read_track(tests::read_file(place / track), format == nullptr ? nullptr : io::track_format_named(format), {});
  if (!tracked) return tracked.error();
  const auto map = io::read_bundled_map(*tracked->format);
  if (!map) return map.error();
  return animate(document::make_document(std::move(read).value()), std::move(tracked->track), *map, options);
}

bool has_case(const std::string& folder) {
  return std::filesystem::is_directory(tests::shared_dir() / "cases" / "rigs" / folder);
}

TEST(SharedRigTracks, DropFrameTimecodesHoldNothing) {
  if (!has_case("csv_drop_frame")) GTEST_SKIP();
  const auto take = animate_case("csv_drop_frame", "_arkit.glb", "take.csv");
  ASSERT_TRUE(take) << take.error().line();
  EXPECT_EQ(take->poses.size(), 60U);
  EXPECT_TRUE(take->held.empty());
  EXPECT_NEAR(take->fps, 30000 / 1001.0, 1e-9);
}

TEST(SharedRigTracks, EveryShapeIsDriven) {
  struct TakeOfRig {
    const char* folder;
    const char* model;
    const char* track;
    const char* format;
    double fps;
  };
  for (const TakeOfRig& one : {TakeOfRig{"csv_seconds_as_timecode", "_arkit.glb", "early.csv", nullptr, 30},
                               TakeOfRig{"csv_seconds_as_timecode", "_arkit.glb", "frames.csv", nullptr, 30},
                               TakeOfRig{"csv_mediapipe_shapes", "_arkit.glb", "tasks.csv", nullptr, 1 / 0.033},
                               TakeOfRig{"csv_mediapipe_shapes", "_arkit.glb", "tasks.csv", "arkit", 1 / 0.033},
                               TakeOfRig{"csv_mediapipe_shapes", "_arkit.glb", "tasks.json", nullptr, 30},
                               TakeOfRig{"names_with_prefix", "maya.glb", "take.csv", nullptr, 60}}) {
    if (!has_case(one.folder)) GTEST_SKIP();
    const auto take = animate_case(one.folder, one.model, one.track, {}, one.format);
    ASSERT_TRUE(take) << one.track << take.error().line();
    EXPECT_TRUE(take->unmatched.empty()) << one.track;
    EXPECT_NEAR(take->fps, one.fps, 0.05) << one.track;
    for (std::size_t c = 0; c < 6; ++c) {
      const auto moved = [&](const rig::Pose& pose) { return pose[c] > 0.05; };
      EXPECT_TRUE(std::any_of(take->poses.begin(), take->poses.end(), moved)) << one.track << c;
    }
  }
}

TEST(SharedRigTracks, ActionUnitsAloneDriveTheFace) {
  if (!has_case("csv_openface_units_only")) GTEST_SKIP();
  const auto take = animate_case("csv_openface_units_only", "_arkit.glb", "aus.csv");
  ASSERT_TRUE(take) << take.error().line();
  EXPECT_EQ(take->fps, 25);
  // eyeBlink_L, jawOpen, mouthSmile_L, browInnerUp.
  for (const std::size_t c : {0U, 2U, 3U, 5U}) {
    const auto moved = [&](const rig::Pose& pose) { return pose[c] > 0.1; };
    EXPECT_TRUE(std::any_of(take->poses.begin(), take->poses.end(), moved)) << c;
  }
}

TEST(SharedRigTracks, TheHeadTurnsAndTheBodyStands) {
  if (!has_case("head_apply_turns_body")) GTEST_SKIP();
  AnimateOptions options;
  options.apply_head = true;
  const auto take = animate_case("head_apply_turns_body", "head_rig.glb", "yaw.csv", options);
  ASSERT_TRUE(take) << take.error().line();
  const document::Model& model = *take->document.model;
  std::vector<std::string> turned;
  for (const document::Channel& channel : model.animations[0].channels) {
    if (channel.target == document::ChannelTarget::weights) continue;
    EXPECT_EQ(channel.target, document::ChannelTarget::rotation);
    turned.push_back(model.skeleton->joints()[channel.joint].name);
  }
  EXPECT_EQ(turned, (std::vector<std::string>{"Neck", "Head"}));
}

}  // namespace
}  // namespace penpose::tracking
