#include "core/intent/model/composites.h"

#include <gtest/gtest.h>

#include "core/intent/model/whole_model.h"
#include "tests/core/intent/face.h"

namespace penpose::intent {
namespace {

using tests::Face;

/// Adds a control that does what others do, each times a factor.
Face& sum(Face& face, const char* name, const std::vector<std::pair<std::size_t, double>>& parts) {
  std::vector<geometry::ModelVector> ways(face.mesh->vertex_count(), geometry::ModelVector{0});
  for (const auto& [shape, by] : parts) {
    const rig::BlendShape& one = face.shapes[shape];
    for (std::size_t i = 0; i < one.vertices.size(); ++i)
      ways[one.vertices[i]] += geometry::ModelVector(one.deltas[i]) * by;
  }
  std::uint32_t v = 0;
  return face.control(name, [&](double, double) { return ways[v++]; });
}

TEST(Composites, AnExpressionIsTheSumOfItsShapes) {
  Face face = tests::usual_face();
  sum(face, "joy", {{0, 1.0}, {1, 1.0}, {2, 0.5}});
  sum(face, "aa", {{5, 0.4}, {4, 0.6}});
  face.ready();
  const WholeModel whole = measure_whole_model(*face.rig);
  const Composite& joy = whole.composites[face.number("joy")];
  const std::vector<std::size_t> corners{face.number("cornerLeft"), face.number("cornerRight")};
  for (const std::size_t corner : corners) EXPECT_EQ(std::count(joy.of.begin(), joy.of.end(), corner), 1);
  EXPECT_GT(joy.parts, 2.0);
  EXPECT_LE(joy.parts, 3.0) << "the brow is a small part";
  EXPECT_GT(whole.composites[face.number("aa")].parts, 1.3);
  for (const char* shape : {"cornerLeft", "jawOpen", "lipUp", "swell"}) {
    EXPECT_EQ(whole.composites[face.number(shape)].parts, 1.0) << shape;
    EXPECT_TRUE(whole.composites[face.number(shape)].of.empty()) << shape;
  }
}

TEST(Composites, WhatGoesFartherThanAnyOtherIsNoSum) {
  // The half of a shape is the shape by half; twice a shape is more than that can.
  Face face = tests::usual_face();
  sum(face, "half", {{0, 0.5}});
  face.ready();
  const WholeModel whole = measure_whole_model(*face.rig);
  for (const Composite& one : whole.composites) EXPECT_EQ(one.parts, 1.0);
}

}  // namespace
}  // namespace penpose::intent
