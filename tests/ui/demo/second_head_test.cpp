#include <algorithm>
#include <gtest/gtest.h>

#include "core/articulation/deformer.h"
#include "core/articulation/measure/doubts.h"
#include "core/character/demo_head.h"
#include "core/head/head.h"
#include "ui/demo/run_demo.h"

namespace penpose::demo {
namespace {

using geometry::ModelPoint;

class SecondHead : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto made = run_demo();
    ASSERT_TRUE(made.ok()) << made.error().line();
    demo_ = new Demo(std::move(made).value());
  }
  static void TearDownTestSuite() { delete demo_; }

  static const document::Model& model() { return *demo_->document.model; }
  static std::vector<ModelPoint> posed(const rig::Pose& pose) {
    document::Model posed = model();
    posed.pose = pose;
    return document::posed_positions(posed);
  }
  static std::vector<ModelPoint> with(const std::string& name, double value) {
    rig::Pose pose = rig::rest_pose(*model().rig);
    pose[*rig::find_parameter(model().rig->parameters(), name)] = value;
    return posed(pose);
  }
  static std::vector<ModelPoint> expression(const std::string& name) {
    for (const NamedPose& one : demo_->poses) {
      if (one.name == name) return posed(one.pose);
    }
    ADD_FAILURE() << "no expression " << name;
    return posed(rig::rest_pose(*model().rig));
  }
  static std::vector<ModelPoint> curve(const std::string& name, const std::vector<ModelPoint>& positions) {
    std::vector<ModelPoint> points;
    for (const auto& curve : model().curves) {
      if (curve.name != name) continue;
      for (const auto& p : curve.points) points.push_back(mesh::position_of(p, model().mesh->triangles(), positions));
    }
    return points;
  }
  static double mean_move(const std::string& part, const std::vector<ModelPoint>& now) {
    const auto rest = posed(rig::rest_pose(*model().rig));
    for (const mesh::Part& one : model().mesh->parts()) {
      if (one.name != part) continue;
      double sum = 0;
      for (std::uint32_t v = one.first_vertex; v < one.first_vertex + one.vertex_count; ++v) {
        sum += geometry::distance(rest[v], now[v]) / one.vertex_count;
      }
      return sum;
    }
    ADD_FAILURE() << "no part " << part;
    return 0;
  }

  static Demo* demo_;
};
Demo* SecondHead::demo_ = nullptr;

TEST_F(SecondHead, JawTakesChinTeethAndTongueAlongAndLeavesTheUpperTeeth) {
  const auto rest = posed(rig::rest_pose(*model().rig));
  const auto open = with("jaw", 1);
  const auto middle = [](const std::vector<ModelPoint>& line) { return line[line.size() / 2]; };
  const double lip = geometry::distance(middle(curve("lip_lower", open)), middle(curve("lip_lower", rest)));
  const double chin = geometry::distance(middle(curve("jaw", open)), middle(curve("jaw", rest)));
  EXPECT_GT(lip, 0.012);
  EXPECT_GT(chin, 0.8 * lip);
  EXPECT_GT(mean_move("teeth_lower", open), 0.5 * lip);
  EXPECT_GT(mean_move("tongue", open), 0.3 * lip);
  EXPECT_EQ(mean_move("teeth", open), 0.0);
  EXPECT_LT(middle(curve("jaw", open)).z, middle(curve("jaw", rest)).z) << "it turns, and so goes back";
}

TEST_F(SecondHead, MouthsOpenToARoundedShape) {
  for (const char* name : {"laugh", "surprised"}) {
    const auto now = expression(name);
    const auto upper = curve("lip_upper_inner", now);
    const auto lower = curve("lip_lower_inner", now);
    const std::size_t half = upper.size() / 2;
    const auto gap = [&](std::size_t i) { return upper[i].y - lower[i].y; };
    const double most = gap(half);
    EXPECT_GT(most, 0.006) << name;
    // Where the mouth is 60 % of the way to its corner: an ellipse is open by 80 % there, a V by 40 %.
    const double there = std::abs(lower[half].x) + 0.6 * std::abs(lower.back().x - lower[half].x);
    std::size_t at = half;
    while (at + 1 < lower.size() && lower[at].x < there) ++at;
    EXPECT_GT(gap(at), 0.55 * most) << name;
    EXPECT_LT(gap(lower.size() - 1), 0.15 * most) << name << ": corners are corners";
  }
}

TEST_F(SecondHead, PuckerComesForward) {
  const auto rest = posed(rig::rest_pose(*model().rig));
  const auto now = with("lips_pucker", 1);
  const auto middle = [](const std::vector<ModelPoint>& line) { return line[line.size() / 2]; };
  EXPECT_GT(middle(curve("lip_lower", now)).z - middle(curve("lip_lower", rest)).z, 0.004);
  EXPECT_GT(middle(curve("lip_upper", now)).z - middle(curve("lip_upper", rest)).z, 0.003);
}

TEST_F(SecondHead, NothingBetweenTheBrowsIsLeftBehind) {
  const auto rest = posed(rig::rest_pose(*model().rig));
  rig::Pose pose = rig::rest_pose(*model().rig);
  for (const char* name : {"brow_inner_L", "brow_inner_R"}) {
    pose[*rig::find_parameter(model().rig->parameters(), name)] = 0.8;
  }
  const auto now = posed(pose);
  double middle = 0;
  double side = 0;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    const ModelPoint& p = rest[v];
    if (p.z < 0.08 || std::abs(p.y - 0.03) > 0.003) continue;
    if (std::abs(p.x) < 0.001) middle = std::max(middle, now[v].y - p.y);
    if (std::abs(std::abs(p.x) - 0.011) < 0.002) side = std::max(side, now[v].y - p.y);
  }
  EXPECT_GT(side, 0.004);
  EXPECT_GT(middle, 0.5 * side);
}

TEST_F(SecondHead, ItsControlsAreOfTodaysRulesAndHardlyAnyIsDoubted) {
  std::size_t torn = 0;
  for (const auto& one : model().deformers->deformers()) {
    EXPECT_EQ(one->sketch().rules) << one->sketch().name;
    torn += one->strain().turned_over > 0 ? 1 : 0;
  }
  EXPECT_LE(torn, 2U) << "the upper lids fold into their creases";
}

}  // namespace
}  // namespace penpose::demo
