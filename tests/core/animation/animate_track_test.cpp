#include "core/animation/animate_track.h"

#include <gtest/gtest.h>

#include "tests/support/models/rendered_track.h"
#include "tests/support/models/test_rigs.h"

namespace penpose::animation {
namespace {

/// A strip of eleven vertices along x; control 0 raises its middle, control 1 shifts all of it to the right. With
/// `twice` a control 2 does what control 0 does.
std::shared_ptr<const rig::CharacterRig> strip_rig(bool twice = false) {
  mesh::MeshSource source;
  rig::BlendShape raise;
  rig::BlendShape shift;
  raise.parameter.name = "raise";
  shift.parameter = {"shift", 0, -1, 1};
  for (std::uint32_t i = 0; i <= 10; ++i) {
    source.positions.emplace_back(0.1 * i, 0, 0);
    source.positions.emplace_back(0.1 * i, -1, 0);
    const float middle = 1.0F - std::abs(static_cast<float>(i) - 5.0F) / 5.0F;
    raise.vertices.push_back(2 * i);
    raise.deltas.emplace_back(0, 0.4F * middle, 0);
    shift.vertices.push_back(2 * i);
    shift.deltas.emplace_back(0.3F, 0, 0);
  }
  for (std::uint32_t i = 0; i < 10; ++i) {
    source.triangles.push_back({2 * i, 2 * i + 1, 2 * i + 2});
    source.triangles.push_back({2 * i + 1, 2 * i + 3, 2 * i + 2});
  }
  const auto mesh = mesh::TriangleMesh::build(std::move(source)).value();
  std::vector<rig::BlendShape> both{raise, shift};
  if (twice) {
    both.push_back(raise);
    both[2].parameter.name = "raise too";
  }
  const auto shapes = rig::BlendShapes::make(both, mesh->vertex_count()).value();
  return rig::CharacterRig::make(mesh, {shapes}, nullptr).value();
}

/// Passes everything on but does not say that it is linear.
class Opaque final : public rig::Rig {
 public:
  explicit Opaque(std::shared_ptr<const rig::Rig> rig) : rig_(std::move(rig)) {}
  [[nodiscard]] std::span<const rig::Parameter> parameters() const override { return rig_->parameters(); }
  [[nodiscard]] std::size_t vertex_count() const override { return rig_->vertex_count(); }
  void evaluate(std::span<const double> pose, std::span<geometry::ModelPoint> positions) const override {
    rig_->evaluate(pose, positions);
  }
  [[nodiscard]] std::unique_ptr<rig::BoundVertices> bind(std::span<const std::uint32_t> vertices) const override {
    class Bound final : public rig::BoundVertices {
     public:
      explicit Bound(std::unique_ptr<rig::BoundVertices> inner) : inner_(std::move(inner)) {}
      [[nodiscard]] std::size_t vertex_count() const override { return inner_->vertex_count(); }
      void evaluate(std::span<const double> pose, std::span<geometry::ModelPoint> positions) override {
        inner_->evaluate(pose, positions);
      }
      [[nodiscard]] bool moves(std::size_t parameter) const override { return inner_->moves(parameter); }
      [[nodiscard]] std::optional<rig::LinearForm> linearize(std::span<const double>,
                                                             std::span<const std::size_t>) override {
        return std::nullopt;
      }

     private:
      std::unique_ptr<rig::BoundVertices> inner_;
    };
    return std::make_unique<Bound>(rig_->bind(vertices));
  }

 private:
  std::shared_ptr<const rig::Rig> rig_;
};

/// A row of `n` vertices, each raised by a control of its own, the first by most and the last by a twentieth of that.
std::shared_ptr<const rig::CharacterRig> keyboard_rig(std::uint32_t n) {
  const auto mesh = tests::grid_mesh(n - 1, 1);
  std::vector<rig::BlendShape> keys;
  for (std::uint32_t i = 0; i < n; ++i) {
    rig::BlendShape& key = keys.emplace_back();
    key.parameter.name = "key" + std::to_string(i);
    key.vertices = {i};
    key.deltas.emplace_back(0, 0.4F * (1 - 0.95F * static_cast<float>(i) / static_cast<float>(n - 1)), 0);
  }
  return rig::CharacterRig::make(mesh, {rig::BlendShapes::make(keys, mesh->vertex_count()).value()}, nullptr).value();
}

class AnimateTrack : public testing::Test {
 protected:
  void SetUp() override {
    rig_ = strip_rig();
    for (std::uint32_t i = 0; i <= 10; i += 2) vertices_.push_back(2 * i);
    TrackedCurve curve;
    curve.points = {0, 1, 2, 3, 4, 5};
    for (std::uint32_t i = 0; i <= 10; ++i) curve.reference.push_back(posing::at_vertex(2 * i));
    setup_.curves = {curve};
    setup_.free = {0, 1};
    setup_.rest = rig::rest_pose(*rig_);
    setup_.tremor_px = 0;
    for (std::size_t f = 0; f < 30; ++f) {
      const double t = static_cast<double>(f) / 30;
      poses_.push_back({t, 0.5 * std::sin(6 * t)});
    }
    track_ = tests::track_of(*rig_, poses_, vertices_, camera_);
  }

  std::shared_ptr<const rig::CharacterRig> rig_;
  std::vector<std::uint32_t> vertices_;
  geometry::Camera camera_ = geometry::frame_box({{-0.5, -1, 0}, {1.5, 1, 0}}, {500, 500}, 0);
  TrackSetup setup_;
  std::vector<rig::Pose> poses_;
  PointTrack track_;
};

TEST_F(AnimateTrack, FindsThePosesThatWereSeen) {
  const auto result = animate_track(*rig_, track_, setup_, camera_).value();
  ASSERT_EQ(result.poses.size(), 30U);
  for (std::size_t f = 0; f < 30; ++f) {
    EXPECT_NEAR(result.poses[f][0], poses_[f][0], 0.06) << f;
    EXPECT_NEAR(result.poses[f][1], poses_[f][1], 0.06) << f;
  }
}

TEST_F(AnimateTrack, ATrackOfAnotherSizeAndDirectionGivesTheSame) {
  const auto same = animate_track(*rig_, track_, setup_, camera_).value();
  for (auto& frame : track_.frames) {
    for (auto& p : frame.points) p = p * 3.0 + PxPoint{1000, -200};
    std::reverse(frame.points.begin(), frame.points.end());
  }
  const auto result = animate_track(*rig_, track_, setup_, camera_).value();
  for (std::size_t f = 0; f < 30; ++f) EXPECT_NEAR(result.poses[f][0], same.poses[f][0], 1e-3);
}

TEST_F(AnimateTrack, HoldsAndReportsFramesWithoutAFace) {
  for (const std::size_t f : {10U, 11U, 29U}) track_.frames[f] = {track_.frames[f].time_s, 0, {}, {}};
  const auto result = animate_track(*rig_, track_, setup_, camera_).value();
  EXPECT_EQ(result.held, (std::vector<std::size_t>{10, 11, 29}));
  EXPECT_EQ(result.poses[11], result.poses[9]);
  EXPECT_NEAR(result.poses[12][0], poses_[12][0], 0.06);
}

TEST_F(AnimateTrack, FramesBeforeTheFirstFaceStayAtRest) {
  for (std::size_t f = 0; f < 8; ++f) track_.frames[f] = {track_.frames[f].time_s, 0, {}, {}};
  setup_.neutral = 15;
  setup_.tremor_px = 1;
  const auto result = animate_track(*rig_, track_, setup_, camera_).value();
  ASSERT_EQ(result.held.size(), 8U);
  for (std::size_t f = 0; f < 8; ++f) EXPECT_EQ(result.poses[f], setup_.rest) << f;
  EXPECT_GT(std::abs(result.poses[8][1]), 0.1);  // the strip moves when it is first seen
}

TEST_F(AnimateTrack, TwoControlsThatDoTheSameFollowTogetherAsOneDoes) {
  for (std::size_t f = 0; f < 30; ++f) {
    poses_[f] = {std::max(0.0, 1.0 - std::abs(static_cast<double>(f) - 15) / 4), 0};
  }
  track_ = tests::track_of(*rig_, poses_, vertices_, camera_);
  setup_.tremor_px = 2;
  const auto one = animate_track(*rig_, track_, setup_, camera_).value();
  rig_ = strip_rig(true);
  setup_.free = {0, 1, 2};
  setup_.rest = rig::rest_pose(*rig_);
  const auto two = animate_track(*rig_, track_, setup_, camera_).value();
  for (std::size_t f = 0; f < 30; ++f) EXPECT_NEAR(two.poses[f][0] + two.poses[f][2], one.poses[f][0], 0.1) << f;
}

TEST_F(AnimateTrack, WithinTheTremorAllPointsAreAskedBeyondItMostOfThem) {
  // One point of six goes 2 px to the right while five stay: by plain distances nothing moves, by squares a sixth of
  // it.
  const auto transfer = animate_track(*rig_, track_, setup_, camera_).value().transfer;
  FrameOptions options;
  options.near_last = options.near_rest = 0;
  options.max_finish_iterations = 100;
  const auto shift = [&](double tremor_px, double by_px) {
    options.tremor_px = tremor_px;
    auto solver = FrameSolver::make(*rig_, transfer, {1}, setup_.rest, camera_, options).value();
    std::vector<geometry::PxPoint> offsets(6);
    offsets[2] = {by_px, 0};
    return solver.follow(offsets, 0, 1)[1];
  };
  std::vector<geometry::ModelPoint> positions(rig_->vertex_count());
  rig_->evaluate(setup_.rest, positions);
  const double px_of_shift = 0.3 / camera_.units_per_px(camera_.depth(positions[vertices_[2]]));
  EXPECT_NEAR(shift(50, 2) * px_of_shift, 2 / 6.0, 0.02);
  EXPECT_NEAR(shift(0, 2) * px_of_shift, 0, 0.02);
  EXPECT_LT(shift(1, 60) * px_of_shift, 1);  // a point that is lost does not carry the others away
}

TEST_F(AnimateTrack, ARigThatIsNotLinearMovesItsLeastControlToo) {
  constexpr std::uint32_t k_keys = 24;
  const auto keyboard = keyboard_rig(k_keys);
  const Opaque opaque(keyboard);
  TrackedCurve curve;
  std::vector<std::uint32_t> vertices;
  setup_.free.clear();
  for (std::uint32_t i = 0; i < k_keys; ++i) {
    curve.points.push_back(i);
    curve.reference.push_back(posing::at_vertex(i));
    vertices.push_back(i);
    setup_.free.push_back(i);
  }
  setup_.curves = {curve};
  setup_.rest = rig::rest_pose(*keyboard);
  poses_.assign(30, setup_.rest);
  for (std::size_t f = 5; f < 30; ++f) poses_[f].assign(k_keys, 0.8);
  const auto track = tests::track_of(*keyboard, poses_, vertices, camera_);
  const auto result = animate_track(opaque, track, setup_, camera_).value();
  EXPECT_NEAR(result.poses[20][0], 0.8, 0.1);
  EXPECT_GT(result.poses[20][k_keys - 1], 0.2);  // what holds it at rest is strong beside what it is seen to do
  EXPECT_GT(result.poses[20][k_keys / 2], 0.6);
}

TEST_F(AnimateTrack, HoldsFramesInWhichThePointsAreAnywhere) {
  setup_.points.stable = {0, 1, 2, 3, 4, 5};
  for (auto& pose : poses_) pose = {0.2 * pose[0], 0};  // small beside the strip, as expressions are beside a head
  track_ = tests::track_of(*rig_, poses_, vertices_, camera_);
  tests::Shaker shake;
  for (auto& p : track_.frames[12].points) p = {500 * shake(), 500 * shake()};
  const auto result = animate_track(*rig_, track_, setup_, camera_).value();
  EXPECT_EQ(result.held, (std::vector<std::size_t>{12}));
  EXPECT_EQ(result.poses[12], result.poses[11]);
}

TEST_F(AnimateTrack, FramesOfLittleTrustMoveLittle) {
  track_.frames[29].confidence = 0.001;
  for (auto& p : track_.frames[29].points) p.y += 300;
  setup_.least_confidence = 0;
  const auto result = animate_track(*rig_, track_, setup_, camera_).value();
  track_.frames[29].confidence = 1;
  const auto trusted = animate_track(*rig_, track_, setup_, camera_).value();
  EXPECT_LT(std::abs(result.poses[29][0] - result.poses[28][0]),
            0.5 * std::abs(trusted.poses[29][0] - trusted.poses[28][0]));
}

TEST_F(AnimateTrack, WildInputStaysInRange) {
  tests::Shaker shake;
  for (auto& frame : track_.frames) {
    for (auto& p : frame.points) p = p + PxPoint{500 * shake(), 500 * shake()};
  }
  const auto result = animate_track(*rig_, track_, setup_, camera_).value();
  for (const auto& pose : result.poses) {
    EXPECT_TRUE(pose[0] >= 0 && pose[0] <= 1);
    EXPECT_TRUE(pose[1] >= -1 && pose[1] <= 1);
  }
}

TEST_F(AnimateTrack, SmoothingDoesNotLag) {
  setup_.smooth_s = 0.1;
  const auto result = animate_track(*rig_, track_, setup_, camera_).value();
  for (std::size_t f = 8; f < 22; ++f) EXPECT_NEAR(result.poses[f][0], poses_[f][0], 0.06);
}

TEST_F(AnimateTrack, SaysWhichCurveDoesNotFit) {
  auto setup = setup_;
  setup.curves[0].points = {0, 99};
  EXPECT_EQ(animate_track(*rig_, track_, setup, camera_).error().place, "/curves/0");
  setup.curves[0].points = {0, 0};
  EXPECT_EQ(animate_track(*rig_, track_, setup, camera_).error().place, "/curves/0");
  setup.curves.clear();
  EXPECT_FALSE(animate_track(*rig_, track_, setup, camera_).ok());
}

TEST_F(AnimateTrack, NarrowEyesCloseWideOnes) {
  // Two curves of the track lie half as far apart as those of the model; their movement grows to make up for it.
  TrackedCurve lower = setup_.curves[0];
  lower.points = {6, 7, 8, 9, 10, 11};
  lower.reference.clear();
  for (std::uint32_t i = 0; i <= 10; ++i) lower.reference.push_back(posing::at_vertex(2 * i + 1));
  lower.meets = 0;
  setup_.curves.push_back(lower);
  track_.point_count = 12;
  for (auto& frame : track_.frames) {
    for (std::size_t i = 0; i < 6; ++i) {
      PxPoint p = track_.frames[0].points[i];
      frame.points.push_back(
          {p.x, p.y + 0.5 * geometry::distance(track_.frames[0].points[0], track_.frames[0].points[5])});
    }
  }
  const auto result = animate_track(*rig_, track_, setup_, camera_).value();
  EXPECT_NEAR(result.transfer.scale.back() / result.transfer.scale.front(), 2.0, 0.1);
}

}  // namespace
}  // namespace penpose::animation
