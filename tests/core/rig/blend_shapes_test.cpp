#include "core/rig/blend_shapes.h"

#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::rig {
namespace {

/// Two shapes on four vertices, which overlap at vertex 2.
std::vector<BlendShape> two_shapes() {
  std::vector<BlendShape> shapes(2);
  shapes[0].parameter = {"a", 0, 0, 1};
  shapes[0].vertices = {0, 2};
  shapes[0].deltas = {{1, 0, 0}, {0, 1, 0}};
  shapes[1].parameter = {"b", 0, -1, 1};
  shapes[1].vertices = {2, 3};
  shapes[1].deltas = {{0, 0, 4}, {5, 5, 5}};
  return shapes;
}

TEST(BlendShapes, AddValueTimesDelta) {
  const auto shapes = BlendShapes::make(two_shapes(), 4).value();
  std::vector<ModelVector> displacements(4, {10, 0, 0});
  shapes->add(std::vector<double>{0.5, -0.25}, displacements);
  EXPECT_EQ(displacements[0], (ModelVector{10.5, 0, 0}));
  EXPECT_EQ(displacements[1], (ModelVector{10, 0, 0}));
  EXPECT_EQ(displacements[2], (ModelVector{10, 0.5, -1}));
  EXPECT_EQ(displacements[3], (ModelVector{8.75, -1.25, -1.25}));
}

TEST(BlendShapes, ListTheShapesOfAVertex) {
  const auto shapes = BlendShapes::make(two_shapes(), 4).value();
  EXPECT_EQ(shapes->entries_of(1).size(), 0U);
  ASSERT_EQ(shapes->entries_of(2).size(), 2U);
  EXPECT_EQ(shapes->entries_of(2)[0].shape, 0U);
  EXPECT_EQ(shapes->entries_of(2)[1].shape, 1U);
  EXPECT_EQ(shapes->entries_of(2)[1].delta, (glm::vec3{0, 0, 4}));
  EXPECT_EQ(shapes->parameters()[1].name, "b");
}

TEST(BlendShapes, BoundToAFewVerticesTheyAgreeWithTheWhole) {
  const auto mesh = tests::grid_mesh(12, 9);
  const auto shapes = tests::random_shapes(*mesh, 20, 4);
  tests::Random random(1);
  std::vector<std::uint32_t> some;
  for (int i = 0; i < 40; ++i) some.push_back(static_cast<std::uint32_t>(random.index(mesh->vertex_count())));
  some.push_back(some.front());  // vertices may repeat
  const auto bound = shapes->bind(some);
  std::vector<double> values;
  for (int i = 0; i < 20; ++i) values.push_back(i % 3 == 0 ? 0.0 : random(0, 1));
  std::vector<ModelVector> all(mesh->vertex_count(), ModelVector{0});
  std::vector<ModelVector> few(some.size(), ModelVector{0});
  shapes->add(values, all);
  bound->add(values, few);
  for (std::size_t i = 0; i < some.size(); ++i) EXPECT_EQ(few[i], all[some[i]]);
}

TEST(BlendShapes, TheColumnIsTheDisplacementOfOneUnit) {
  const auto shapes = BlendShapes::make(two_shapes(), 4).value();
  const std::vector<std::uint32_t> some{2, 1};
  const auto bound = shapes->bind(some);
  std::vector<ModelVector> column(2, {9, 9, 9});
  EXPECT_TRUE(bound->column(1, column));
  EXPECT_EQ(column[0], (ModelVector{0, 0, 4}));
  EXPECT_EQ(column[1], (ModelVector{0, 0, 0}));
  EXPECT_TRUE(bound->moves(0));
  const std::vector<std::uint32_t> one{0};
  EXPECT_FALSE(shapes->bind(one)->moves(1));
}

TEST(BlendShapes, NameTheTargetThatIsWrong) {
  const auto place = [](auto spoil) {
    auto shapes = two_shapes();
    spoil(shapes[1]);
    const auto made = BlendShapes::make(std::move(shapes), 4);
    return made ? std::string("made") : made.error().place;
  };
  EXPECT_EQ(place([](BlendShape&) {}), "made");
  EXPECT_EQ(place([](BlendShape& s) { s.vertices[1] = 4; }), "target b");
  EXPECT_EQ(place([](BlendShape& s) { s.vertices = {3, 2}; }), "target b");
  EXPECT_EQ(place([](BlendShape& s) { s.vertices = {2, 2}; }), "target b");
  EXPECT_EQ(place([](BlendShape& s) { s.deltas[0].y = NAN; }), "target b");
  EXPECT_EQ(place([](BlendShape& s) { s.deltas[0].y = INFINITY; }), "target b");
  EXPECT_EQ(place([](BlendShape& s) { s.deltas.pop_back(); }), "target b");
  EXPECT_EQ(place([](BlendShape& s) { s.normal_deltas.resize(1); }), "target b");
  EXPECT_EQ(place([](BlendShape& s) { s.parameter.maximum = -1; }), "target b");
  EXPECT_EQ(place([](BlendShape& s) { s.parameter.rest = 2; }), "target b");
  EXPECT_EQ(place([](BlendShape& s) { s.parameter.rest = NAN; }), "target b");
  EXPECT_EQ(place([](BlendShape& s) { s.parameter = {"", 3, 0, 1}; }), "target 1");
}

}  // namespace
}  // namespace penpose::rig
