#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/character/demo_head.h"
#include "core/geometry/bvh.h"
#include "core/head/head.h"
#include "ui/demo/run_demo.h"

// What somebody who looks at the pictures of the demo sees first.
namespace penpose::demo {
namespace {

using geometry::ModelPoint;
using Line = std::vector<ModelPoint>;

class ThirdHead : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = run_demo();
    ASSERT_TRUE(made.ok()) << made.error().line();
    demo_ = new Demo(std::move(made).value());
  }
  static void TearDownTestSuite() { delete demo_; }

  static const document::Model& model() { return *demo_->document.model; }
  static Line posed(const rig::Pose& pose) {
    document::Model posed = model();
    posed.pose = pose;
    return document::posed_positions(posed);
  }
  static Line rest() { return posed(rig::rest_pose(*model().rig)); }
  static Line expression(const std::string& name) {
    for (const NamedPose& one : demo_->poses) {
      if (one.name == name) return posed(one.pose);
    }
    ADD_FAILURE() << "no expression " << name;
    return rest();
  }
  static Line curve(const std::string& name, const Line& positions) {
    Line points;
    for (const auto& curve : model().curves) {
      if (curve.name != name) continue;
      for (const auto& p : curve.points) points.push_back(mesh::position_of(p, model().mesh->triangles(), positions));
    }
    return points;
  }

  static Demo* demo_;
};
Demo* ThirdHead::demo_ = nullptr;

/// How many of the lines of sight straight onto the nose's underside end in the dark lining.
int dark_nostril_sights(head::HeadEdition edition) {
  const document::Model model = head::make_head(edition);
  const std::vector<glm::vec3> positions(model.mesh->positions().begin(), model.mesh->positions().end());
  const geometry::TriangleBvh tree(positions, model.mesh->triangles());
  const auto parts = model.mesh->parts();
  const auto lining = std::find_if(parts.begin(), parts.end(), [](const mesh::Part& p) { return p.name == "lining"; });
  int dark = 0;
  for (double x = 0.004; x < 0.018; x += 0.0005) {
    for (double y = -0.047; y < -0.037; y += 0.0005) {
      const auto hit = tree.nearest_hit({{x, y, 0.6}, {0, 0, -1}});
      if (hit && hit->triangle >= lining->first_triangle &&
          hit->triangle < lining->first_triangle + lining->triangle_count) {
        ++dark;
      }
    }
  }
  return dark;
}

TEST_F(ThirdHead, NostrilsAreDarkAsSeenFromTheFront) {
  EXPECT_EQ(dark_nostril_sights(head::HeadEdition::second), 0) << "which is why there is a third";
  EXPECT_GT(dark_nostril_sights(head::HeadEdition::third), 15);
}

TEST_F(ThirdHead, ASurprisedMouthIsRoundAndBothBrowsRiseAsAWhole) {
  const Line now = expression("surprised");
  const Line before = rest();
  const Line upper = curve("lip_upper_inner", now);
  const Line lower = curve("lip_lower_inner", now);
  const double height = upper[upper.size() / 2].y - lower[lower.size() / 2].y;
  EXPECT_LT(lower.back().x - lower.front().x, 2.2 * height) << "the second head's is 2.66 times as wide as high";
  for (const char* name : {"brow_L", "brow_R"}) {
    const Line up = curve(name, now);
    const Line was = curve(name, before);
    for (std::size_t i = 0; i < up.size(); ++i) EXPECT_NEAR(up[i].y - was[i].y, 0.0085, 0.0035) << name << ' ' << i;
  }
}

TEST_F(ThirdHead, CornersGoDownInSadnessAndUpInASmile) {
  const Line was = curve("lip_lower_inner", rest());
  const Line sad = curve("lip_lower_inner", expression("sad"));
  const Line smile = curve("lip_lower_inner", expression("smile"));
  for (const std::size_t end : {std::size_t{0}, was.size() - 1}) {
    EXPECT_LT(sad[end].y, was[end].y - 0.003);
    EXPECT_GT(smile[end].y, was[end].y + 0.003);
  }
  // A frown bends the line evenly; no step beside the corner, as there was when a smile was drawn backwards.
  // The last points lie in the corner itself, where the line ends.
  for (std::size_t i = 3; i + 3 < sad.size(); ++i) {
    const double before = (sad[i].y - sad[i - 1].y) / (sad[i].x - sad[i - 1].x);
    const double after = (sad[i + 1].y - sad[i].y) / (sad[i + 1].x - sad[i].x);
    EXPECT_LT(std::abs(std::atan(after) - std::atan(before)), 0.6) << i;
  }
}

TEST_F(ThirdHead, AKissShutsTheEyesAndPushesTheLipsForward) {
  const Line now = expression("kiss");
  const Line before = rest();
  for (const char* side : {"_L", "_R"}) {
    const Line upper = curve(std::string("eyelid_upper") + side, now);
    const Line lower = curve(std::string("eyelid_lower") + side, now);
    const Line open = curve(std::string("eyelid_upper") + side, before);
    const std::size_t half = upper.size() / 2;
    EXPECT_LT(upper[half].y - lower[half].y, 0.15 * (open[half].y - lower[half].y)) << side;
  }
  const Line lips = curve("lip_upper", now);
  const Line lips_before = curve("lip_upper", before);
  EXPECT_GT(lips[lips.size() / 2].z, lips_before[lips.size() / 2].z + 0.004);
  EXPECT_LT(lips.back().x - lips.front().x, 0.75 * (lips_before.back().x - lips_before.front().x));
}

}  // namespace
}  // namespace penpose::demo
