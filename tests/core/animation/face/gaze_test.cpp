#include "core/animation/face/gaze.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/base/math.h"
#include "tests/support/models/nodding_head.h"

namespace penpose::animation {
namespace {

/// Two balls in front of a plate. Parameters: turn ball 0 about y, about x; shift ball 1; turn all about y. Angles are
/// radians.
class Balls final : public rig::Rig {
 public:
  Balls() : parameters_{{"a", 0, -1, 1}, {"b", 0, -1, 1}, {"c", 0, 0, 1}, {"d", 0, -1, 1}} {
    for (int ball = 0; ball < 2; ++ball) {
      for (int i = 0; i < 8; ++i) {
        for (int k = -2; k <= 2; ++k) {
          const double around = i * base::k_pi / 4;
          const double up = k * base::k_pi / 6;
          add(middle(ball) +
                  geometry::ModelVector(std::cos(up) * std::sin(around), std::sin(up), std::cos(up) * std::cos(around)),
              static_cast<std::uint32_t>(ball));
        }
      }
    }
    for (int i = 0; i < 400; ++i) add({0.5 * (i % 20) - 5, 0.5 * (i / 20) - 5, -3}, 2);
    // The lids of both eyes: upper and lower, three points each.
    for (int ball = 0; ball < 2; ++ball) {
      for (const double up : {0.5, -0.5}) {
        for (int k = -1; k <= 1; ++k) add(middle(ball) + geometry::ModelVector(k, k == 0 ? up : 0.0, 1.1), 2);
      }
    }
  }
  static geometry::ModelPoint middle(int ball) { return {ball == 0 ? -2.0 : 2.0, 0, 0}; }
  static std::uint32_t lid(std::size_t curve) { return static_cast<std::uint32_t>(80 + 400 + 3 * curve); }

  [[nodiscard]] std::span<const rig::Parameter> parameters() const override { return parameters_; }
  [[nodiscard]] std::size_t vertex_count() const override { return rest_.size(); }
  void evaluate(std::span<const double> pose, std::span<geometry::ModelPoint> positions) const override {
    for (std::size_t v = 0; v < rest_.size(); ++v) {
      geometry::ModelPoint p = rest_[v];
      if (components[v] == 0) p = middle(0) + tests::turned(tests::turned(p - middle(0), pose[1], 1, 2), pose[0], 2, 0);
      if (components[v] == 1) p += geometry::ModelVector(pose[2], 0, 0);
      positions[v] = tests::turned(p, pose[3], 2, 0);
    }
  }
  [[nodiscard]] std::unique_ptr<rig::BoundVertices> bind(std::span<const std::uint32_t>) const override {
    return nullptr;
  }

  std::vector<std::uint32_t> components;

 private:
  void add(const geometry::ModelPoint& p, std::uint32_t component) {
    rest_.push_back(p);
    components.push_back(component);
  }
  std::vector<rig::Parameter> parameters_;
  std::vector<geometry::ModelPoint> rest_;
};

TEST(Gaze, FindsWhatTurnsAnEyeballByWhatItMoves) {
  const Balls balls;
  Transfer transfer;
  for (std::size_t curve = 0; curve < 4; ++curve) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      transfer.points.push_back(posing::at_vertex(Balls::lid(curve) + k));
      transfer.curve.push_back(curve);
    }
  }
  const std::vector<EyeCurves> eyes{{0, 1}, {2, 3}};
  const rig::Pose rest(4, 0.0);
  const auto controls = find_gaze_controls(balls, rest, balls.components, transfer, eyes);
  ASSERT_EQ(controls.size(), 2U);
  ASSERT_EQ(controls[0].size(), 2U);  // neither the shift of a ball nor the turn of the whole
  EXPECT_TRUE(controls[1].empty());
  rig::Pose pose = rest;
  look(balls, rest, controls[0], {0.3, -0.2}, pose);
  // The ball looks to the picture's right and up, to two degrees.
  std::vector<geometry::ModelPoint> still(balls.vertex_count());
  std::vector<geometry::ModelPoint> posed(balls.vertex_count());
  balls.evaluate(rest, still);
  balls.evaluate(pose, posed);
  std::size_t front = 0;
  for (std::size_t v = 0; v < 40; ++v) {
    if (still[v].z > still[front].z) front = v;
  }
  const geometry::ModelVector d = posed[front] - Balls::middle(0);
  EXPECT_NEAR(std::atan2(d.x, d.z), 0.3, 0.035);
  EXPECT_NEAR(std::atan2(-d.y, d.z), -0.2, 0.035);
}

TEST(Gaze, GoesStraightOnThroughBlinksAndWhereNothingIsSaid) {
  PointTrack track;
  StillTrack still;
  std::vector<std::vector<double>> closed(2, std::vector<double>(60, 0.0));
  for (std::size_t f = 0; f < 60; ++f) {
    TrackFrame frame;
    const double wild = f == 30 || f == 31 ? 1.0 : 0.0;  // what a tracker says of closed eyes
    frame.says.gaze.assign(2, Gaze{0.1 + wild, wild});
    if (wild > 0) closed[0][f] = closed[1][f] = 1;
    track.frames.push_back(frame);
    still.confidence.push_back(1);
  }
  const auto gaze = gaze_of(track, still, closed);
  ASSERT_EQ(gaze.size(), 2U);
  for (std::size_t f = 0; f < 60; ++f) {
    EXPECT_NEAR(gaze[0][f].right, 0.1, 0.02) << f;
    EXPECT_NEAR(gaze[1][f].down, 0.0, 0.02) << f;
  }
  for (auto& frame : track.frames) frame.says.gaze.clear();
  EXPECT_TRUE(gaze_of(track, still, closed).empty());
}

TEST(Gaze, IrisesLookWhereTheyAreBetweenTheCorners) {
  PointTrack track;
  track.point_count = 478;
  StillTrack still;
  // Eyes 29 mm wide with balls of 24 mm, 2 px a mm, seen from in front.
  const double right = 0.25;
  const double down = 0.15;
  for (int f = 0; f < 10; ++f) {
    TrackFrame frame;
    frame.points.resize(478);
    const auto set = [&](std::size_t one, std::size_t other, std::size_t iris, double x) {
      frame.points[one] = {x - 29, 100};
      frame.points[other] = {x + 29, 100};
      frame.points[iris] = {x + 24 * std::sin(right) * std::cos(down), 100 + 24 * std::sin(down)};
    };
    set(33, 133, 468, 200);
    set(362, 263, 473, 330);
    track.frames.push_back(frame);
    still.confidence.push_back(1);
    still.turns.emplace_back();
  }
  const auto gaze = gaze_of(track, still, {});
  ASSERT_EQ(gaze.size(), 2U);
  EXPECT_NEAR(gaze[0][5].right, right, 0.01);
  EXPECT_NEAR(gaze[1][5].down, down, 0.01);
}

}  // namespace
}  // namespace penpose::animation
