#include "ui/demo/demo_head.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/head/head.h"
#include "ui/demo/embedded_files.h"

namespace penpose::demo {
namespace {

using geometry::ModelPoint;

class DemoHead : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = make_demo_head();
    ASSERT_TRUE(made.ok()) << made.error().line();
    model_ = new document::Model(std::move(made).value());
  }
  static void TearDownTestSuite() { delete model_; }

  static const articulation::Deformer& deformer(const std::string& name) {
    for (const auto& one : model_->deformers->deformers()) {
      if (one->sketch().name == name) return *one;
    }
    ADD_FAILURE() << "no deformer " << name;
    std::abort();
  }
  static std::vector<ModelPoint> posed(const std::vector<std::pair<std::string, double>>& values) {
    document::Model model = *model_;
    for (const auto& [name, value] : values) model.pose[*rig::find_parameter(model.rig->parameters(), name)] = value;
    return document::posed_positions(model);
  }
  static std::vector<ModelPoint> curve(const std::string& name, const std::vector<ModelPoint>& positions) {
    std::vector<ModelPoint> points;
    for (const auto& curve : model_->curves) {
      if (curve.name != name) continue;
      for (const auto& p : curve.points) points.push_back(mesh::position_of(p, model_->mesh->triangles(), positions));
    }
    return points;
  }

  static document::Model* model_;
};
document::Model* DemoHead::model_ = nullptr;

TEST_F(DemoHead, HasFifteenDeformersOfAtMostFourStrokes) {
  EXPECT_EQ(model_->deformers->size(), 15U);
  EXPECT_EQ(model_->rig->parameters().size(), 15U);
  for (const auto& one : model_->deformers->deformers()) {
    EXPECT_LE(stroke_count(one->sketch()), 4U);
    EXPECT_GT(one->vertices().size(), 50U) << one->sketch().name;
    EXPECT_LT(one->vertices().size(), model_->mesh->vertex_count() / 3) << one->sketch().name;
    EXPECT_EQ(*std::max_element(one->weights().begin(), one->weights().end()), 1.0);
  }
}

TEST_F(DemoHead, RestIsTheHeadItself) {
  const document::Model bare = head::make_head();
  EXPECT_EQ(posed({}), document::posed_positions(bare));
}

TEST_F(DemoHead, LidsSlideOverTheEyeball) {
  for (const std::string side : {"_L", "_R"}) {
    const head::Eyeball eye = side == "_L" ? head::head_landmarks().left : head::head_landmarks().right;
    for (const std::string lid : {"eyelid_upper", "eyelid_lower"}) {
      const auto& moved = deformer(lid + side);
      const auto rest = posed({});
      for (int step = 0; step <= 20; ++step) {
        const auto now = posed({{lid + side, step / 20.0}});
        for (const std::uint32_t v : moved.vertices()) {
          const double distance = geometry::distance(now[v], eye.center);
          ASSERT_NEAR(distance, geometry::distance(rest[v], eye.center), 1e-9 * eye.radius) << lid << side << v;
          ASSERT_GT(distance, eye.radius);
        }
      }
    }
  }
}

TEST_F(DemoHead, ClosedLidMeetsTheLowerOne) {
  const double radius = head::head_landmarks().left.radius;
  for (const std::string side : {"_L", "_R"}) {
    const auto open = curve("eyelid_upper" + side, posed({}));
    const auto closed = curve("eyelid_upper" + side, posed({{"eyelid_upper" + side, 1}}));
    const auto lower = curve("eyelid_lower" + side, posed({}));
    ASSERT_GT(closed.size(), 10U);
    for (const ModelPoint& p : closed) {
      double nearest = radius;
      for (std::size_t i = 0; i + 1 < lower.size(); ++i) {
        for (int k = 0; k <= 8; ++k) {
          nearest = std::min(nearest, geometry::distance(p, lower[i] + (lower[i + 1] - lower[i]) * (k / 8.0)));
        }
      }
      EXPECT_LT(nearest, 0.04 * radius);
    }
    EXPECT_GT(geometry::distance(open[open.size() / 2], closed[closed.size() / 2]), 0.8 * radius);
  }
}

TEST_F(DemoHead, JawPartsTheLips) {
  const auto rest = posed({});
  const auto open = posed({{"jaw", 1}});
  const auto upper = curve("lip_upper_inner", open);
  const auto lower = curve("lip_lower_inner", open);
  const std::size_t middle = upper.size() / 2;
  EXPECT_GT(upper[middle].y - lower[middle].y, 0.010);
  EXPECT_EQ(curve("lip_upper_inner", rest)[middle], upper[middle]);
  EXPECT_EQ(curve("nose_bridge", rest), curve("nose_bridge", open));
  EXPECT_LT(geometry::distance(upper.front(), lower.front()), 0.002);
}

TEST_F(DemoHead, SidesMirrorEachOther) {
  const auto rest = posed({});
  for (const std::string name : {"eyelid_upper", "brow_inner", "cheek", "mouth_corner"}) {
    const auto left = posed({{name + "_L", 1}});
    const auto right = posed({{name + "_R", 1}});
    for (const std::string curve_name : {"eyelid_upper", "brow"}) {
      const auto a = curve(curve_name + "_L", left);
      const auto b = curve(curve_name + "_R", right);
      ASSERT_EQ(a.size(), b.size());
      for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(a[i].x, -b[i].x, 2e-4) << name << ' ' << i;
        EXPECT_NEAR(a[i].y, b[i].y, 2e-4) << name << ' ' << i;
      }
    }
  }
}

TEST_F(DemoHead, BrowsAndCornersMoveTheirWay) {
  const auto rest = posed({});
  const auto up = [&](const std::string& parameter, const std::string& name, std::size_t point) {
    return curve(name, posed({{parameter, 1}}))[point].y - curve(name, rest)[point].y;
  };
  EXPECT_GT(up("brow_inner_L", "brow_L", 2), 0.004);
  EXPECT_GT(up("brow_outer_L", "brow_L", 20), 0.004);
  EXPECT_LT(up("brow_inner_L", "brow_L", 24), 0.001);
  EXPECT_GT(up("mouth_corner_L", "lip_upper", 38), 0.005);
  EXPECT_LT(up("mouth_corner_L", "lip_upper", 4), 0.0005);
  EXPECT_GT(up("lip_upper", "lip_upper", 20), 0.003);
  const auto narrow = curve("lip_upper", posed({{"lips_pucker", 1}}));
  EXPECT_LT(narrow.back().x, 0.75 * curve("lip_upper", rest).back().x);
}

TEST_F(DemoHead, ASketchThatIsNoneIsRefused) {
  EXPECT_FALSE(articulate(head::make_head(), "{").ok());
  const auto twice = articulate(*model_, embedded_sketch());
  ASSERT_TRUE(twice.ok());
  EXPECT_EQ(twice->deformers->size(), 15U);
}

}  // namespace
}  // namespace penpose::demo
