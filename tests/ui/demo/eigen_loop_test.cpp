#include <cmath>
#include <gtest/gtest.h>

#include "core/animation/animate_track.h"
#include "core/animation/points/eigen_points.h"
#include "core/character/demo_head.h"
#include "tests/support/models/rendered_track.h"
#include "ui/render/appearance.h"
#include "ui/render/renderer.h"

namespace penpose::demo {
namespace {

/// The loop of eigen-points: a clip of the built-in head is rendered under changing light, tracked in the pictures, and
/// animated again.
class EigenLoop : public testing::Test {
 protected:
  void SetUp() override {
    head_ = character::make_demo_head().value();
    auto renderer = render::make_offscreen_renderer();
    if (!renderer) GTEST_SKIP() << renderer.error().line();
    renderer_ = std::move(renderer).value();
    appearance_.emplace(render::make_appearance(head_, {}));
    // The face is 320 px wide.
    geometry::Box box;
    for (const auto& curve : head_.curves) {
      const auto rest = document::posed_positions(head_);
      for (const auto& p : curve.points) box.add(mesh::position_of(p, head_.mesh->triangles(), rest));
    }
    const geometry::ModelPoint middle = box.center();
    const double width = box.maximum.x - box.minimum.x;
    camera_ =
        geometry::Camera::make({middle + geometry::ModelVector(0, 0, 0.7), middle, {0, 1, 0}, 20}, {480, 480}).value();
    const double px = width / camera_->units_per_px(0.7);
    camera_ = geometry::Camera::make({middle + geometry::ModelVector(0, 0, 0.7), middle, {0, 1, 0}, 20 * px / 320},
                                     {480, 480})
                  .value();
    for (const char* name : {"lip_upper", "lip_lower", "brow_L", "brow_R", "eyelid_upper_L", "eyelid_upper_R"}) {
      std::vector<std::size_t> all;
      for (const auto& curve : head_.curves) {
        if (curve.name != name) continue;
        animation::TrackedCurve tracked;
        for (std::size_t k = 0; k < 7; ++k) {
          const auto& p = curve.points[k * (curve.points.size() - 1) / 6];
          tracked.points.push_back(points_.size());
          points_.push_back(p);
        }
        for (const auto& p : curve.points)
          tracked.reference.push_back(posing::at_mesh_point(p, head_.mesh->triangles()));
        curves_.push_back(tracked);
      }
    }
    ASSERT_EQ(curves_.size(), 6U);
  }

  [[nodiscard]] rig::Pose pose_at(double t) const {
    rig::Pose pose = rig::rest_pose(*head_.rig);
    const auto set = [&](const char* name, double value) {
      const auto p = rig::find_parameter(head_.rig->parameters(), name);
      if (p) pose[*p] = std::clamp(value, head_.rig->parameters()[*p].minimum, head_.rig->parameters()[*p].maximum);
    };
    const double in = std::min(1.0, 2 * t);
    set("jaw", in * (0.35 - 0.35 * std::cos(5 * t)));
    set("mouth_corner_L", in * 0.6 * std::sin(2.3 * t));
    set("mouth_corner_R", in * 0.6 * std::sin(2.3 * t + 0.4));
    set("brow_inner_L", in * 0.7 * std::sin(1.7 * t));
    set("brow_inner_R", in * 0.7 * std::sin(1.7 * t));
    set("brow_outer_L", in * 0.6 * std::sin(1.2 * t + 1));
    set("brow_outer_R", in * 0.6 * std::sin(1.2 * t + 1));
    set("eyelid_upper_L", in * (0.45 - 0.45 * std::cos(3.1 * t)));
    set("eyelid_upper_R", in * (0.45 - 0.45 * std::cos(3.1 * t)));
    return pose;
  }

  /// A picture with light that falls from `from` (-1 left .. 1 right) and is `strong` times as bright.
  animation::LabelledImage shoot(const rig::Pose& pose, double from, double strong) {
    document::Model moment = head_;
    moment.pose = pose;
    const render::PosedMesh posed = render::posed_mesh(moment);
    render::Scene scene;
    scene.positions = posed.positions;
    scene.normals = posed.normals;
    scene.triangles = moment.mesh->triangles();
    scene.appearance = &*appearance_;
    const render::Image picture = renderer_->render(scene, *camera_).value();
    animation::LabelledImage shot;
    shot.image = {picture.width, picture.height, {}};
    for (int y = 0; y < picture.height; ++y) {
      for (int x = 0; x < picture.width; ++x) {
        const std::uint8_t* p = picture.at(x, y);
        const double light = strong * (1.0 + 0.4 * from * (2.0 * x / picture.width - 1.0));
        const double grey = (0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2]) * light;
        shot.image.pixels.push_back(static_cast<std::uint8_t>(std::clamp(grey, 0.0, 255.0)));
      }
    }
    const auto positions = document::posed_positions(moment);
    for (const auto& p : points_) {
      shot.points.push_back(camera_->project(mesh::position_of(p, head_.mesh->triangles(), positions)).value());
    }
    return shot;
  }

  document::Model head_;
  std::unique_ptr<render::Renderer> renderer_;
  std::optional<render::Appearance> appearance_;
  std::optional<geometry::Camera> camera_;
  std::vector<mesh::MeshPoint> points_;
  std::vector<animation::TrackedCurve> curves_;
};

TEST_F(EigenLoop, FindsTheCurvesWithinTwoPxAndClosesTheLoop) {
  std::vector<animation::LabelledImage> labelled;
  tests::Shaker random(5);
  for (int k = 0; k < 30; ++k) {
    rig::Pose pose = pose_at(1.0 + k);
    labelled.push_back(shoot(pose, random(), 0.8 + 0.2 * random()));
  }
  const std::vector<animation::LabelledFeature> features = [&] {
    std::vector<animation::LabelledFeature> all(5);
    const std::size_t of_curve[] = {0, 0, 1, 2, 3, 4};
    for (std::size_t c = 0; c < 6; ++c) {
      auto& feature = all[of_curve[c]].points;
      feature.insert(feature.end(), curves_[c].points.begin(), curves_[c].points.end());
    }
    return all;
  }();
  const auto learned = animation::learn_eigen_points(labelled, features).value();

  animation::PointTrack track;
  track.point_count = points_.size();
  std::vector<rig::Pose> poses;
  double square = 0;
  std::size_t count = 0;
  std::vector<geometry::PxPoint> shifts;
  for (int f = 0; f < 40; ++f) {
    poses.push_back(pose_at(f / 15.0));
    const double from = std::sin(0.2 * f);
    const auto truth = shoot(poses.back(), from, 0.8 + 0.15 * std::cos(0.3 * f));
    const auto found = animation::find_eigen_points(learned, truth.image, shifts).value();
    shifts = found.shifts;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const double d = geometry::distance(found.points[i], truth.points[i]);
      square += d * d;
      ++count;
    }
    track.frames.push_back({f / 15.0, found.confidence, found.points, {}});
  }
  const double rms = std::sqrt(square / static_cast<double>(count));
  EXPECT_LT(rms, 2.0);

  animation::TrackSetup setup;
  setup.curves = curves_;
  setup.rest = rig::rest_pose(*head_.rig);
  for (std::size_t p = 0; p < head_.rig->parameters().size(); ++p) setup.free.push_back(p);
  const auto result = animation::animate_track(*head_.rig, track, setup, *camera_).value();
  double off = 0;
  for (std::size_t f = 0; f < poses.size(); ++f) {
    auto a = head_;
    auto b = head_;
    a.pose = poses[f];
    b.pose = result.poses[f];
    const auto wanted = document::posed_positions(a);
    const auto got = document::posed_positions(b);
    for (const auto& p : points_) {
      off += geometry::distance(mesh::position_of(p, head_.mesh->triangles(), wanted),
                                mesh::position_of(p, head_.mesh->triangles(), got));
    }
  }
  off /= static_cast<double>(poses.size() * points_.size());
  EXPECT_LT(off, 0.02 * 0.22);  // of a face 22 cm high
}

}  // namespace
}  // namespace penpose::demo
