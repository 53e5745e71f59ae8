#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/animation/animate_track.h"
#include "core/io/project/landmark_file.h"
#include "core/io/tracks/face_points.h"
#include "core/io/tracks/read_track.h"
#include "core/tracking/track_setup.h"
#include "tests/support/models/nodding_head.h"
#include "tests/support/models/rendered_track.h"
#include "tests/support/shared_data.h"
#include "ui/cli/track/track_input.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"

namespace penpose::cli {
namespace {

/// The loop of tracked curves: a clip of known poses is seen, tracked and animated again.
class SharedTrackLoop : public testing::Test {
 protected:
  void SetUp() override {
    if (!tests::has_shared()) GTEST_SKIP();
    model_ = files::load_model((tests::shared_dir() / "meshes" / "ict_face.glb").string()).value();
    const auto bytes = files::read_file((tests::shared_dir() / "meshes" / "ict_face_landmarks.json").string()).value();
    const auto json = nlohmann::json::parse(bytes.begin(), bytes.end());
    points_ = json["landmarks68"].get<std::vector<std::uint32_t>>();
    map_ = io::read_bundled_map(*io::track_format_named("openface")).value();
    poses_ = tests::talking_clip(*model_.rig, 300);
    std::vector<geometry::ModelPoint> rest(model_.mesh->vertex_count());
    model_.rig->evaluate(rig::rest_pose(*model_.rig), rest);
    // A camera that shows the face 320 px wide.
    const double width = geometry::distance(rest[points_[0]], rest[points_[16]]);
    const geometry::ModelPoint middle = (rest[points_[0]] + rest[points_[16]]) * 0.5;
    const double distance = 60;
    geometry::CameraPose pose{middle + geometry::ModelVector(0, 0, distance), middle, {0, 1, 0}, 30};
    video_ = geometry::Camera::make(pose, {640, 640}).value();
    const double px = width / video_->units_per_px(distance);
    pose.vertical_fov_degrees = 30 * px / 320;
    video_ = geometry::Camera::make(pose, {640, 640}).value();
    height_ = 1.6 * (rest[points_[27]].y - rest[points_[8]].y);  // from the bridge of the nose to the chin is 5/8 of it
  }

  animation::TrackedAnimation animate(animation::PointTrack track) {
    for (auto& frame : track.frames) frame.depths = io::common_depths(frame.points);
    std::vector<std::string> notes;
    auto setup = tracking::make_setup(model_, track, map_, {}, notes).value();
    const auto camera = geometry::frame_box(document::rest_world_box(model_), {1000, 1000}, 0);
    return animation::animate_track(*model_.rig, track, setup, camera).value();
  }

  /// Mean over frames and the vertices under the driven curves and around them of how far they are off.
  double mean_error(const animation::TrackedAnimation& result) {
    std::vector<std::uint32_t> driven;
    const auto curves =
        io::read_landmarks(
            files::read_file((tests::shared_dir() / "meshes" / "ict_face_landmarks.json").string()).value())
            .value();
    for (const auto& curve : curves) {
      const bool feature =
          curve.name.starts_with("lip") || curve.name.starts_with("brow") || curve.name.starts_with("eyelid");
      if (feature) driven.insert(driven.end(), curve.vertices.begin(), curve.vertices.end());
    }
    const auto bound = model_.rig->bind(driven);
    std::vector<geometry::ModelPoint> wanted(driven.size());
    std::vector<geometry::ModelPoint> found(driven.size());
    double sum = 0;
    for (std::size_t f = 0; f < poses_.size(); ++f) {
      bound->evaluate(poses_[f], wanted);
      bound->evaluate(result.poses[f], found);
      for (std::size_t i = 0; i < driven.size(); ++i) sum += geometry::distance(wanted[i], found[i]);
    }
    return sum / static_cast<double>(driven.size() * poses_.size());
  }

  [[nodiscard]] std::size_t parameter(const char* name) const {
    return rig::find_parameter(model_.rig->parameters(), name).value();
  }
  static double largest_jump(const animation::TrackedAnimation& result, std::size_t from) {
    double largest = 0;
    for (std::size_t f = from + 1; f < result.poses.size(); ++f) {
      for (std::size_t i = 0; i < result.poses[f].size(); ++i) {
        largest = std::max(largest, std::abs(result.poses[f][i] - result.poses[f - 1][i]));
      }
    }
    return largest;
  }

  document::Model model_;
  std::vector<std::uint32_t> points_;
  io::MapFile map_;
  std::vector<rig::Pose> poses_;
  std::optional<geometry::Camera> video_;
  double height_ = 0;
};

TEST_F(SharedTrackLoop, RecoversTheAnimation) {
  const auto result = animate(tests::track_of(*model_.rig, poses_, points_, *video_));
  EXPECT_LT(mean_error(result) / height_, 0.005);
  EXPECT_TRUE(result.held.empty());
  for (const auto& pose : result.poses) {
    for (const double value : pose) EXPECT_TRUE(value >= 0 && value <= 1);
  }
  // A blink of seven frames is neither lost nor late.
  const auto blink = parameter("eyeBlink_L");
  for (std::size_t f = 20; f < 40; ++f) EXPECT_LE(result.poses[f][blink], result.poses[30][blink]);
  EXPECT_GT(result.poses[30][blink], 0.85);
  EXPECT_LT(result.poses[25][blink], 0.2);
}

TEST_F(SharedTrackLoop, RecoversItWithTremor) {
  const auto result = animate(tests::track_of(*model_.rig, poses_, points_, *video_, 1.0));
  EXPECT_LT(mean_error(result) / height_, 0.006);
}

TEST_F(SharedTrackLoop, TremorDoesNotMakeAParameterJump) {
  poses_.assign(300, rig::rest_pose(*model_.rig));
  EXPECT_LT(largest_jump(animate(tests::track_of(*model_.rig, poses_, points_, *video_, 1.0)), 0), 0.05);
  rig::Pose held = poses_[0];
  for (const char* name : {"jawOpen", "mouthSmile_L", "eyeBlink_L", "browInnerUp_L"}) held[parameter(name)] = 0.5;
  std::fill(poses_.begin() + 1, poses_.end(), held);
  EXPECT_LT(largest_jump(animate(tests::track_of(*model_.rig, poses_, points_, *video_, 1.0)), 8), 0.05);
}

TEST_F(SharedTrackLoop, NeitherDoesTremorOfANormalLaw) {
  poses_.assign(300, rig::rest_pose(*model_.rig));
  const auto calm = tests::track_of(*model_.rig, poses_, points_, *video_);
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    auto track = calm;
    tests::Shaker shake(seed);
    const auto normal = [&] {  // of deviation 1: the sum of twelve even ones of 1/12 each
      double sum = 0;
      for (int i = 0; i < 12; ++i) sum += shake() / 2;
      return sum;
    };
    for (auto& frame : track.frames) {
      for (auto& p : frame.points) p = p + geometry::PxPoint{normal(), normal()};
    }
    EXPECT_LT(largest_jump(animate(track), 0), 0.05) << seed;
  }
}

/// A track of which every coordinate is off by up to a px to either side.
animation::PointTrack shaken_track(animation::PointTrack track, std::uint64_t seed) {
  tests::Shaker shake(seed);
  for (auto& frame : track.frames) {
    for (auto& p : frame.points) p = p + geometry::PxPoint{shake(), shake()};
  }
  return track;
}

/// By how much a step from one frame to the next differs at most.
double largest_difference_of_steps(const animation::TrackedAnimation& a, const animation::TrackedAnimation& b) {
  double largest = 0;
  for (std::size_t f = 1; f < a.poses.size(); ++f) {
    for (std::size_t i = 0; i < a.poses[f].size(); ++i) {
      const double step = a.poses[f][i] - a.poses[f - 1][i];
      largest = std::max(largest, std::abs(step - (b.poses[f][i] - b.poses[f - 1][i])));
    }
  }
  return largest;
}

TEST_F(SharedTrackLoop, TremorAddsNoJumpToAMovingFace) {
  const auto calm_track = tests::track_of(*model_.rig, poses_, points_, *video_);
  const auto calm = animate(calm_track);
  const auto blink = parameter("eyeBlink_L");
  double sum = 0;
  constexpr std::uint64_t k_clips = 20;
  for (std::uint64_t seed = 1; seed <= k_clips; ++seed) {
    const auto shaken = animate(shaken_track(calm_track, seed));
    const double largest = largest_difference_of_steps(shaken, calm);
    EXPECT_LT(largest, 0.05) << seed;
    sum += largest;
    EXPECT_GT(shaken.poses[30][blink], 0.8) << seed;  // four frames down, four up, and there is the peak
  }
  EXPECT_LT(sum / k_clips, 0.03);
}

TEST_F(SharedTrackLoop, NorToOneWhoseHeadTurns) {
  const auto calm_track = tests::track_of(*model_.rig, poses_, points_, *video_, 0, tests::nodding);
  const auto calm = animate(calm_track);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    EXPECT_LT(largest_difference_of_steps(animate(shaken_track(calm_track, seed)), calm), 0.05) << seed;
  }
}

TEST_F(SharedTrackLoop, ABlinkThatIsHalfTrustedDoesNotWidenTheEyes) {
  auto track = tests::track_of(*model_.rig, poses_, points_, *video_);
  for (auto& frame : track.frames) frame.confidence = 0.5;
  const auto wide = parameter("eyeWide_L");
  for (const auto& pose : animate(track).poses) EXPECT_LT(pose[wide], 0.12);
}

TEST_F(SharedTrackLoop, AMovingHeadIsNoExpression) {
  const auto moved = animate(tests::track_of(*model_.rig, poses_, points_, *video_, 0, tests::nodding));
  EXPECT_LT(mean_error(moved) / height_, 0.01);
  poses_.assign(300, rig::rest_pose(*model_.rig));
  const auto silent = animate(tests::track_of(*model_.rig, poses_, points_, *video_, 0, tests::nodding));
  EXPECT_LT(mean_error(silent) / height_, 0.005);
  const auto jaw = parameter("jawOpen");
  for (const auto& pose : silent.poses) EXPECT_LT(pose[jaw], 0.03);
}

TEST_F(SharedTrackLoop, ABlinkClosesTheLidsHoweverLittleTheTrackersPointsClose) {
  const auto left = parameter("eyeBlink_L");
  const auto right = parameter("eyeBlink_R");
  for (const double closing : {0.3, 0.6}) {
    auto seen = poses_;
    for (auto& pose : seen) {
      pose[left] *= closing;
      pose[right] *= closing;
    }
    const auto result = animate(tests::track_of(*model_.rig, seen, points_, *video_, 0.5));
    for (const std::size_t f : {30U, 105U, 180U, 255U}) {
      EXPECT_NEAR(result.poses[f][left], 1.0, 0.15) << closing << " at " << f;
      EXPECT_NEAR(result.poses[f][right], 1.0, 0.15) << closing << " at " << f;
    }
  }
  for (auto& pose : poses_) pose[left] = pose[right] = 0;
  const auto awake = animate(tests::track_of(*model_.rig, poses_, points_, *video_, 0.5));
  for (const auto& pose : awake.poses) EXPECT_LT(pose[left], 0.15);
}

TEST_F(SharedTrackLoop, TheEyesLookWhereThePersonsDo) {
  auto track = tests::track_of(*model_.rig, poses_, points_, *video_, 0.5, tests::nodding);
  tests::Shaker shake(4);
  std::vector<animation::Gaze> truth;
  for (std::size_t f = 0; f < track.frames.size(); ++f) {
    // From one place to the next; a tracker is off by a degree.
    const auto k = static_cast<double>(f / 20);
    truth.push_back({0.3 * std::sin(2.4 * k), 0.2 * std::sin(1.7 * k + 1)});
    for (int eye = 0; eye < 2; ++eye) {
      track.frames[f].says.gaze.push_back({truth[f].right + 0.017 * shake(), truth[f].down + 0.017 * shake()});
    }
  }
  const auto result = animate(track);
  EXPECT_GE(result.gaze_controls, 8U);
  double sum = 0;
  double count = 0;
  for (std::size_t f = 5; f < track.frames.size(); f += 5) {
    // In blinks eyes show nothing, and where they jump the frame before is as good as the next.
    if (f % 20 < 5 || result.eyes.closed[0][f] > 0.5) continue;
    for (const bool left : {true, false}) {
      const auto value = [&](const char* of_left, const char* of_right) {
        return result.poses[f][parameter(left ? of_left : of_right)];
      };
      const double right = 30 * (value("eyeLookOut_L", "eyeLookIn_R") - value("eyeLookIn_L", "eyeLookOut_R"));
      const double down = 30 * (value("eyeLookDown_L", "eyeLookDown_R") - value("eyeLookUp_L", "eyeLookUp_R"));
      EXPECT_NEAR(right, truth[f].right * 57.29578, 3.0) << f;
      EXPECT_NEAR(down, truth[f].down * 57.29578, 3.0) << f;
      sum += std::abs(right - truth[f].right * 57.29578) + std::abs(down - truth[f].down * 57.29578);
      count += 2;
    }
  }
  EXPECT_LT(sum / count, 1.0);
  RecordProperty("mean_degrees", std::to_string(sum / count));
}

TEST_F(SharedTrackLoop, ControlsOfOtherNamesAndInAnotherOrderDoTheSame) {
  const auto track = tests::track_of(*model_.rig, poses_, points_, *video_, 0.5);
  const auto named = animate(track);
  std::vector<rig::BlendShape> shapes(model_.shapes->shapes().rbegin(), model_.shapes->shapes().rend());
  for (std::size_t i = 0; i < shapes.size(); ++i) shapes[i].parameter.name = "k" + std::to_string(i);
  const std::size_t n = shapes.size();
  auto made = rig::BlendShapes::make(std::move(shapes), model_.mesh->vertex_count()).value();
  model_ = document::make_model(model_.mesh, std::move(made), nullptr).value();
  const auto renamed = animate(track);
  for (std::size_t f = 0; f < poses_.size(); ++f) {
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_NEAR(renamed.poses[f][n - 1 - i], named.poses[f][i], 0.05) << f << " " << i;
  }
}

TEST_F(SharedTrackLoop, LipsThatAreOpenInTheFirstFrameAreNoRest) {
  for (std::size_t f = 0; f < 8; ++f) poses_[f][parameter("jawOpen")] = 0.4;
  const auto result = animate(tests::track_of(*model_.rig, poses_, points_, *video_, 0.5));
  ASSERT_TRUE(result.rest.has_value());
  EXPECT_GE(result.rest->frame, 8U);
  EXPECT_TRUE(result.rest->near_rest);
  EXPECT_NEAR(result.poses[3][parameter("jawOpen")], 0.4, 0.1);
}

TEST_F(SharedTrackLoop, LipsThatNeverTouchAreTold) {
  for (auto& pose : poses_) pose[parameter("jawOpen")] = std::max(0.3, pose[parameter("jawOpen")]);
  const auto result = animate(tests::track_of(*model_.rig, poses_, points_, *video_));
  ASSERT_TRUE(result.rest.has_value());
  EXPECT_FALSE(result.rest->near_rest);
  EXPECT_GT(result.poses[150][parameter("jawOpen")], 0.2);  // they are as far apart as they are seen
}

}  // namespace
}  // namespace penpose::cli
