#include "core/head/curves.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>

#include "core/head/head.h"

namespace penpose::head {
namespace {

class HeadCurves : public testing::Test {
 protected:
  static const document::Model& model() {
    static const document::Model made = make_head();
    return made;
  }
  static std::vector<ModelPoint> positions(const std::string& name) {
    std::vector<ModelPoint> points;
    for (const document::NamedCurve& curve : model().curves) {
      if (curve.name != name) continue;
      for (const mesh::MeshPoint& p : curve.points) {
        points.push_back(mesh::position_of(p, model().mesh->triangles(), model().mesh->positions()));
      }
    }
    return points;
  }
};

TEST_F(HeadCurves, SidesAreMirrorImages) {
  for (const std::string name : {"eyelid_upper", "eyelid_lower", "brow"}) {
    const auto left = positions(name + "_L");
    const auto right = positions(name + "_R");
    ASSERT_GE(left.size(), 20U) << name;
    ASSERT_EQ(left.size(), right.size()) << name;
    for (std::size_t i = 0; i < left.size(); ++i) {
      EXPECT_LT(geometry::distance(left[i], {-right[i].x, right[i].y, right[i].z}), 1e-6) << name << " " << i;
    }
  }
}

TEST_F(HeadCurves, LidsRunFromCornerToCornerAroundTheOpenEye) {
  const auto upper = positions("eyelid_upper_L");
  const auto lower = positions("eyelid_lower_L");
  EXPECT_EQ(upper.front(), lower.front());
  EXPECT_EQ(upper.back(), lower.back());
  EXPECT_GT(upper.back().x - upper.front().x, 0.025);
  EXPECT_GT(upper[upper.size() / 2].y - lower[lower.size() / 2].y, 0.01);
}

TEST_F(HeadCurves, LipsMeetAlongTheirInnerCurves) {
  const auto upper = positions("lip_upper_inner");
  const auto lower = positions("lip_lower_inner");
  ASSERT_EQ(upper.size(), lower.size());
  const double width = upper.back().x - upper.front().x;
  EXPECT_GT(width, 0.04);
  for (std::size_t i = 0; i < upper.size(); ++i) {
    EXPECT_GE(upper[i].y, lower[i].y);
    EXPECT_LT(upper[i].y - lower[i].y, 0.007 * width) << i;
    EXPECT_LT(geometry::distance(upper[i], lower[i]), 0.01 * width) << i;
  }
}

TEST_F(HeadCurves, CurvesRunEvenly) {
  for (const document::NamedCurve& curve : model().curves) {
    const auto points = positions(curve.name);
    ASSERT_GE(points.size(), 10U) << curve.name;
    double length = 0;
    double longest = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double step = geometry::distance(points[i - 1], points[i]);
      length += step;
      longest = std::max(longest, step);
    }
    EXPECT_LT(longest, 4 * length / static_cast<double>(points.size())) << curve.name;
  }
}

}  // namespace
}  // namespace penpose::head
