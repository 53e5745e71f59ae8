#include "core/intent/model/doubles.h"

#include <gtest/gtest.h>

#include "tests/core/intent/face.h"

namespace penpose::intent {
namespace {

using tests::Face;

/// Adds a control that does what others do, each times a factor.
void combine(Face& face, const char* name, const std::vector<std::pair<std::size_t, double>>& parts) {
  std::vector<geometry::ModelVector> ways(face.mesh->vertex_count(), geometry::ModelVector{0});
  for (const auto& [shape, by] : parts) {
    const rig::BlendShape& one = face.shapes[shape];
    for (std::size_t i = 0; i < one.vertices.size(); ++i)
      ways[one.vertices[i]] += geometry::ModelVector(one.deltas[i]) * by;
  }
  std::uint32_t v = 0;
  face.control(name, [&](double, double) { return ways[v++]; });
}

TEST(Doubles, AreSumsOfOthersAndControlsThatDoTheSame) {
  Face face = tests::usual_face();
  EXPECT_TRUE(doubles_of(measure_whole_model(*face.ready().rig)).empty());
  face = tests::usual_face();
  combine(face, "both", {{0, 1.0}, {1, 1.0}});
  combine(face, "half", {{0, 0.5}});
  const auto doubles = doubles_of(measure_whole_model(*face.ready().rig));
  ASSERT_EQ(doubles.size(), 2U);
  EXPECT_EQ(doubles[0].parameter, face.number("both"));
  EXPECT_EQ(doubles[0].of.size(), 2U);
  EXPECT_EQ(doubles[1].parameter, face.number("half"));
  EXPECT_EQ(doubles[1].of, std::vector<std::size_t>{0});
}

}  // namespace
}  // namespace penpose::intent
