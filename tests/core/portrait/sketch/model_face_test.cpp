#include "core/portrait/sketch/model_face.h"

#include <gtest/gtest.h>

#include "core/character/demo_head.h"
#include "core/document/features/feature_curves.h"
#include "core/portrait/pose_from_drawing.h"

namespace penpose::portrait {
namespace {

struct SeenHead {
  document::Model model = character::make_demo_head().value();
  intent::WholeModel whole = intent::measure_whole_model(*model.rig);
  std::vector<FeatureCurve> curves = document::feature_curves_of(model, whole, {}).value().curves;
  rig::Pose rest = rig::rest_pose(*model.rig);
  ModelFace face = ModelFace::see(*model.rig, curves, rest, camera_of_drawing(*model.rig, curves, rest, 0)).value();

  /// The lines of the mouth's opening for an expression of the mouth: the upper and the lower border.
  [[nodiscard]] std::array<std::vector<geometry::PxPoint>, 2> lips(const Expression::Mouth& mouth) const {
    Expression expression;
    expression.mouth = mouth;
    const auto lines = face.lines_of(expression);
    std::array<std::vector<geometry::PxPoint>, 2> out;
    for (const bool lower : {false, true}) {
      const auto& curve = curves[face.curve_of(FacePart::mouth, false, lower).value()];
      for (const auto& line : lines) {
        const auto same = [](const posing::CurvePoint& a, const posing::CurvePoint& b) { return a.vertex == b.vertex; };
        if (std::equal(line.reference.begin(), line.reference.end(), curve.points.begin(), curve.points.end(), same))
          out[lower ? 1 : 0] = line.target;
      }
    }
    return out;
  }
};

double width_of(const std::vector<geometry::PxPoint>& line) { return std::abs(line.back().x - line.front().x); }

TEST(ModelFace, AMouthThatOpensDropsItsLowerLipNarrowsAndLowersItsCorners) {
  const SeenHead head;
  const auto shut = head.lips({});
  Expression::Mouth mouth;
  mouth.opened = 0.4;
  const auto open = head.lips(mouth);
  ASSERT_FALSE(shut[0].empty() || shut[1].empty());
  const double drop = open[1][shut[1].size() / 2].y - shut[1][shut[1].size() / 2].y;
  const double rise = shut[0][shut[0].size() / 2].y - open[0][shut[0].size() / 2].y;
  EXPECT_GT(drop, 4 * rise);
  EXPECT_GT(rise, 0);
  EXPECT_LT(width_of(open[0]), width_of(shut[0]));
  EXPECT_GT(open[0].front().y, shut[0].front().y);
  EXPECT_GT(open[0].back().y, shut[0].back().y);
}

TEST(ModelFace, ACornerIsRaisedOnItsSideOfThePicture) {
  const SeenHead head;
  const auto rest = head.lips({});
  Expression::Mouth mouth;
  mouth.corners = {0.1, 0};
  const auto smirk = head.lips(mouth);
  const auto [left, right] =
      std::minmax_element(rest[0].begin(), rest[0].end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  EXPECT_LT(smirk[0][static_cast<std::size_t>(left - rest[0].begin())].y, left->y);
  EXPECT_EQ(smirk[0][static_cast<std::size_t>(right - rest[0].begin())].y, right->y);
}

TEST(ModelFace, WithoutEyesOrAMouthThereIsNone) {
  const SeenHead head;
  std::vector<FeatureCurve> some;
  for (const FeatureCurve& curve : head.curves) {
    if (curve.name.find("lid") == std::string::npos) some.push_back(curve);
  }
  EXPECT_FALSE(
      ModelFace::see(*head.model.rig, some, head.rest, camera_of_drawing(*head.model.rig, head.curves, head.rest, 0)));
}

}  // namespace
}  // namespace penpose::portrait
