#include "core/document/features/feature_curves.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/character/demo_head.h"

namespace penpose::document {
namespace {

std::vector<std::string> names_of(const FeatureCurves& features) {
  std::vector<std::string> out;
  for (const portrait::FeatureCurve& curve : features.curves) out.push_back(curve.name);
  return out;
}

/// A triangle that has the vertex, and the vertex in it.
mesh::MeshPoint at_vertex(const mesh::TriangleMesh& mesh, std::uint32_t vertex) {
  for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      mesh::MeshPoint point{t, {0, 0, 0}};
      point.barycentric[k] = 1;
      if (mesh.triangles()[t][k] == vertex) return point;
    }
  }
  return {};
}

TEST(FeatureCurves, ALineThatSomebodyNamedTakesThePlaceOfTheOneThatLiesThere) {
  Model model = character::make_demo_head().value();
  const intent::WholeModel whole = intent::measure_whole_model(*model.rig);
  const auto found = feature_curves_of(model, whole, {}).value();
  const auto jaw = std::find_if(found.curves.begin(), found.curves.end(),
                                [](const portrait::FeatureCurve& one) { return one.name == "jaw"; });
  ASSERT_NE(jaw, found.curves.end());
  NamedCurve own{"my own jaw", {}};
  for (const posing::CurvePoint& point : jaw->points) {
    const std::size_t k =
        static_cast<std::size_t>(std::max_element(point.weight.begin(), point.weight.end()) - point.weight.begin());
    own.points.push_back(at_vertex(*model.mesh, point.vertex[k]));
  }
  model.curves.push_back(own);
  const auto names = names_of(feature_curves_of(model, whole, {}).value());
  EXPECT_EQ(names.size(), found.curves.size()) << "the others are still found";
  EXPECT_EQ(std::count(names.begin(), names.end(), "my own jaw"), 1);
  EXPECT_EQ(std::count(names.begin(), names.end(), "jaw"), 0);
}

}  // namespace
}  // namespace penpose::document
