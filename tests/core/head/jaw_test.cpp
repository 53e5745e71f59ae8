#include <cmath>
#include <gtest/gtest.h>

#include "core/articulation/deformer.h"
#include "core/geometry/camera.h"
#include "core/head/head.h"

namespace penpose::head {
namespace {

using geometry::ModelPoint;
using geometry::PxPoint;

/// A line along the jaw and where it should go, drawn from the character's left side: turned about the jaw's joint.
class SwingingJaw : public testing::Test {
 protected:
  static constexpr double k_degrees = 14;

  void SetUp() override {
    for (const auto& curve : model_.curves) {
      if (curve.name != "jaw") continue;
      const auto at = [&](std::size_t i) {
        return mesh::position_of(curve.points[i], model_.mesh->triangles(), model_.mesh->positions());
      };
      joint_ = at(curve.points.size() - 1);
      chin_ = at(curve.points.size() / 2);
    }
    const auto camera = geometry::Camera::make(pose_, viewport_).value();
    const PxPoint joint = *camera.project(joint_);
    const PxPoint chin = *camera.project({joint_.x, chin_.y, chin_.z});
    const double reach = geometry::distance(joint, chin);
    sketch_.name = "jaw";
    sketch_.viewport = viewport_;
    sketch_.camera = pose_;
    sketch_.general = ring((joint + chin) * 0.5, 0.6 * reach);
    sketch_.specific = ring(joint + (chin - joint) * 0.8, 0.15 * reach);
    const double s = std::sin(k_degrees * 3.14159265358979 / 180);
    const double c = std::cos(k_degrees * 3.14159265358979 / 180);
    const double side = chin.x > joint.x ? 1 : -1;
    for (int i = 2; i <= 20; ++i) {
      const PxPoint arm = (chin - joint) * (i / 22.0);
      sketch_.reference.push_back(joint + arm);
      sketch_.target.push_back(joint + PxPoint{c * arm.x - side * s * arm.y, side * s * arm.x + c * arm.y});
    }
    sketch_.mode = articulation::Mode::rotate;
  }
  static std::vector<PxPoint> ring(PxPoint middle, double radius) {
    std::vector<PxPoint> out;
    for (int i = 0; i < 48; ++i) {
      const double a = i * 6.283185307179586 / 48;
      out.push_back(middle + PxPoint{std::cos(a), std::sin(a)} * radius);
    }
    return out;
  }

  document::Model model_ = make_head();
  geometry::Viewport viewport_{1000, 1000};
  geometry::CameraPose pose_{{1.1, 0.0, 0.02}, {0, 0.0, 0.02}, {0, 1, 0}, 24};
  ModelPoint joint_{0};
  ModelPoint chin_{0};
  articulation::Sketch sketch_;
};

// Method, section 3: a jaw that swings.
TEST_F(SwingingJaw, EveryPointStaysAtItsDistanceFromTheJoint) {
  const auto canvas = document::make_canvas(model_).value();
  const auto deformer = articulation::build_deformer(sketch_, *canvas);
  ASSERT_TRUE(deformer) << deformer.error().line();
  EXPECT_EQ((*deformer)->mode(), articulation::Mode::rotate);
  const auto rest = (*deformer)->curve_at(0);
  const double length = geometry::distance(rest.front(), rest.back());
  for (int step = 0; step <= 10; ++step) {
    const auto now = (*deformer)->curve_at(step / 10.0);
    for (std::size_t i = 0; i < now.size(); ++i) {
      const double before = geometry::distance(rest[i], rest.front());
      const double after = geometry::distance(now[i], now.front());
      EXPECT_NEAR(after, before, 0.03 * length) << "amount " << step / 10.0 << ", point " << i;
    }
  }
  // The chin goes down on an arc: further down at every step, and backwards in the end.
  double last = rest.back().y;
  for (int step = 1; step <= 10; ++step) {
    const double y = (*deformer)->curve_at(step / 10.0).back().y;
    EXPECT_LT(y, last);
    last = y;
  }
  EXPECT_LT((*deformer)->curve_at(1).back().z, rest.back().z);
}

}  // namespace
}  // namespace penpose::head
