#include <filesystem>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/animation/animate_track.h"
#include "core/io/project/landmark_file.h"
#include "core/io/tracks/face_points.h"
#include "core/io/tracks/read_track.h"
#include "core/tracking/track_setup.h"
#include "tests/support/models/rendered_track.h"
#include "tests/support/shared_data.h"
#include "ui/cli/track/track_input.h"
#include "ui/files/files.h"
#include "ui/files/load_model.h"

namespace penpose::cli {
namespace {

/// A real tracker's output for a head that moves a lot.
class SharedRealTrack : public testing::Test {
 protected:
  void SetUp() override {
    if (!tests::has_shared()) GTEST_SKIP();
    model_ = files::load_model((tests::shared_dir() / "meshes" / "ict_face.glb").string()).value();
    track_ = std::get<animation::PointTrack>(
        read_track((tests::shared_dir() / "tracks" / "openface_head_test.csv").string(), {}, {}).value().track);
    const auto map = io::read_bundled_map(*io::track_format_named("openface")).value();
    std::vector<std::string> notes;
    const auto setup = tracking::make_setup(model_, track_, map, {}, notes).value();
    const auto camera = geometry::frame_box(document::rest_world_box(model_), {1000, 1000}, 0);
    result_ = animation::animate_track(*model_.rig, track_, setup, camera).value();
  }
  [[nodiscard]] double apart(std::size_t f, std::size_t a, std::size_t b) const {
    return geometry::distance(track_.frames[f].points[a], track_.frames[f].points[b]);
  }
  [[nodiscard]] std::vector<double> values(const char* name) const {
    const auto p = rig::find_parameter(model_.rig->parameters(), name).value();
    std::vector<double> all;
    for (const auto& pose : result_.poses) all.push_back(pose[p]);
    return all;
  }

  document::Model model_;
  animation::PointTrack track_;
  animation::TrackedAnimation result_;
};

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  const double mean_a = std::accumulate(a.begin(), a.end(), 0.0) / n;
  const double mean_b = std::accumulate(b.begin(), b.end(), 0.0) / n;
  double ab = 0;
  double aa = 0;
  double bb = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  return ab / std::sqrt(aa * bb);
}

TEST_F(SharedRealTrack, TheMouthOpensWhenThePersonsDoes) {
  std::vector<double> lips;
  for (std::size_t f = 0; f < 300; ++f) lips.push_back(apart(f, 62, 66));
  const auto jaw = values("jawOpen");
  EXPECT_GT(correlation(lips, jaw), 0.9);
  // The head rolls and nods by 40 degrees with closed lips.
  for (std::size_t f = 0; f < 300; ++f) {
    if (lips[f] < 3) {
      EXPECT_LT(jaw[f], 0.1) << f;
    }
  }
}

TEST_F(SharedRealTrack, TheLidsFollowThePersonsLids) {
  // How far the eyes are open, in widths of the eyes: a nod shortens that too, which is no blink.
  std::vector<double> open;
  std::vector<double> level_open;
  std::vector<double> level_blink;
  std::vector<double> blink = values("eyeBlink_R");
  const auto left = values("eyeBlink_L");
  for (std::size_t f = 0; f < 300; ++f) {
    open.push_back((apart(f, 37, 41) + apart(f, 38, 40)) / apart(f, 36, 39) +
                   (apart(f, 43, 47) + apart(f, 44, 46)) / apart(f, 42, 45));
    blink[f] += left[f];
    if (result_.still.turns[f].rotation[2][2] < std::cos(0.35)) continue;
    level_open.push_back(open[f]);
    level_blink.push_back(blink[f]);
  }
  EXPECT_LT(correlation(open, blink), -0.93);
  EXPECT_LT(correlation(level_open, level_blink), -0.85);
}

TEST_F(SharedRealTrack, TheEyesCloseWhenThePersonsDo) {
  const auto blink = values("eyeBlink_R");
  // Around frame 247 the eyes are half closed for a moment; at 126 they are wide open.
  EXPECT_GT(blink[247], 0.25);
  EXPECT_LT(blink[126], 0.05);
  EXPECT_LT(blink[232], 0.15);
}

TEST_F(SharedRealTrack, NoTwoControlsThatUndoEachOtherAreUp) {
  const auto left = values("mouthLeft");
  const auto right = values("mouthRight");
  for (std::size_t f = 0; f < 300; ++f) EXPECT_FALSE(left[f] > 0.1 && right[f] > 0.1) << f;
}

TEST_F(SharedRealTrack, TheLidsAgreeWithTheTrackersOwnWordOnBlinking) {
  auto blink = values("eyeBlink_R");
  const auto left = values("eyeBlink_L");
  std::vector<double> told;
  for (std::size_t f = 0; f < 300; ++f) {
    blink[f] += left[f];
    told.push_back(track_.frames[f].says.closing.value_or(0));
  }
  EXPECT_GT(correlation(blink, told), 0.6);
}

TEST_F(SharedRealTrack, TheHeadsTurnIsKeptApart) {
  const auto roll = [&](std::size_t f) {
    return std::atan2(result_.still.turns[f].rotation[0][1], result_.still.turns[f].rotation[0][0]);
  };
  EXPECT_LT(roll(105), -0.5);
  EXPECT_GT(roll(195), 0.6);
  EXPECT_NEAR(roll(240), 0.0, 0.1);
  // A nod of 34 degrees: as far as the tracker says itself.
  const auto nod = [&](std::size_t f) {
    return std::atan2(-result_.still.turns[f].rotation[2][1], result_.still.turns[f].rotation[2][2]);
  };
  EXPECT_NEAR(nod(276), 0.605, 0.02);
  EXPECT_NEAR(nod(40), -0.06, 0.02);
}

}  // namespace
}  // namespace penpose::cli
