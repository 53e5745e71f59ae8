#include "core/articulation/sketched_deformers.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/posing/solve.h"
#include "core/rig/character_rig.h"
#include "tests/support/models/articulation_models.h"

namespace penpose::articulation {
namespace {

using tests::Trunk;

/// Five controls of one trunk, of every kind.
std::vector<Sketch> five(const Trunk& trunk) {
  std::vector<Sketch> sketches(5, trunk.curl());
  sketches[1].name = "lift";
  for (PxPoint& p : sketches[1].target) p.y = 1000 - p.y;
  sketches[2].name = "shift";
  sketches[2].mode = Mode::translate;
  sketches[3].name = "slide";
  sketches[3].mode = Mode::translate;
  sketches[3].surface = Sphere{{0.5, 0, 0}, 0.1};
  sketches[4].name = "tip";
  sketches[4].general = trunk.box(1.8, 3.5, 0.6);
  sketches[4].specific = trunk.box(2.2, 3.4, 0.5);
  sketches[4].reference.clear();
  return sketches;
}

std::vector<ModelVector> sum_of(const SketchedDeformers& set, const std::vector<double>& values, std::size_t vertices) {
  std::vector<ModelVector> sum(vertices, ModelVector{0});
  set.add(values, sum);
  return sum;
}

TEST(SketchedDeformers, AddUpInAFixedOrder) {
  const Trunk trunk = tests::make_trunk();
  const std::size_t n = trunk.canvas->positions().size();
  const auto sketches = five(trunk);
  const auto set = SketchedDeformers::build(sketches, *trunk.canvas).value();
  const std::vector<double> values = {0.3, 0.9, 0.5, 0.2, 0.7};
  const auto sum = sum_of(*set, values, n);
  EXPECT_EQ(sum, sum_of(*set, values, n));
  std::vector<ModelVector> by_one(n, ModelVector{0});
  for (std::size_t i = 0; i < 5; ++i) {
    std::vector<double> alone(5, 0.0);
    alone[i] = values[i];
    const auto one = sum_of(*set, alone, n);
    for (std::size_t v = 0; v < n; ++v) by_one[v] += one[v];
  }
  EXPECT_EQ(sum, by_one);
  // Another order changes no more than the last bits of the sum.
  const std::vector<std::size_t> order = {3, 0, 4, 2, 1};
  std::vector<Sketch> shuffled;
  std::vector<double> shuffled_values;
  for (const std::size_t i : order) {
    shuffled.push_back(sketches[i]);
    shuffled_values.push_back(values[i]);
  }
  const auto other = sum_of(*SketchedDeformers::build(shuffled, *trunk.canvas).value(), shuffled_values, n);
  for (std::size_t v = 0; v < n; ++v) EXPECT_LT(geometry::distance(sum[v], other[v]), 4e-15);
}

TEST(SketchedDeformers, ABoundVertexMovesAsInTheWholeToTheBit) {
  const Trunk trunk = tests::make_trunk();
  const auto set = SketchedDeformers::build(five(trunk), *trunk.canvas).value();
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t v = 5; v < trunk.canvas->positions().size(); v += 41) vertices.push_back(v);
  const auto bound = set->bind(vertices);
  for (const std::vector<double>& values : {std::vector<double>{0, 0, 0, 0, 0},
                                            {1, 1, 1, 1, 1},
                                            {0.3, 0.9, 0.5, 0.2, 0.7},
                                            {0.3, 0.1, 0.5, 0.2, 0.0},
                                            {1, 0, 0, 0, 0}}) {
    const auto whole = sum_of(*set, values, trunk.canvas->positions().size());
    std::vector<ModelVector> few(vertices.size(), ModelVector{0});
    bound->add(values, few);
    for (std::size_t i = 0; i < vertices.size(); ++i) EXPECT_EQ(few[i], whole[vertices[i]]);
  }
}

TEST(SketchedDeformers, SayWhatIsLinearAndWhatMoves) {
  const Trunk trunk = tests::make_trunk();
  const auto set = SketchedDeformers::build(five(trunk), *trunk.canvas).value();
  const std::vector<std::uint32_t> vertices = {0, (Trunk::k_rings - 1) * Trunk::k_around, 70 * Trunk::k_around};
  const auto bound = set->bind(vertices);
  std::vector<ModelVector> column(3);
  EXPECT_FALSE(bound->column(0, column));  // rotates
  EXPECT_TRUE(bound->column(2, column));   // translates
  EXPECT_FALSE(bound->column(3, column));  // translates over a ball
  std::vector<ModelVector> at_half(3, ModelVector{0});
  ASSERT_TRUE(bound->column(2, column));
  bound->add(std::vector<double>{0, 0, 0.5, 0, 0}, at_half);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_LT(geometry::distance(at_half[i], column[i] * 0.5), 1e-15);
  EXPECT_EQ(column[0], ModelVector{0});  // the body

  const std::vector<std::uint32_t> body = {0, 1, 2};
  const auto still = set->bind(body);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_FALSE(still->moves(i));
    EXPECT_TRUE(still->column(i, column));  // not at all is linear
  }
}

TEST(SketchedDeformers, RefuseTwoOfOneNameAndSayWhichSketchFails) {
  const Trunk trunk = tests::make_trunk();
  auto sketches = five(trunk);
  sketches[3].name = "curl";
  EXPECT_EQ(SketchedDeformers::build(sketches, *trunk.canvas).error().place, "3/name");
  sketches = five(trunk);
  sketches[2].target = {{1, 1}};
  EXPECT_EQ(SketchedDeformers::build(sketches, *trunk.canvas).error().place, "2/target");
}

TEST(SketchedDeformers, ArePosedByTheSolverLikeAnyRig) {
  const Trunk trunk = tests::make_trunk();
  auto sketches = five(trunk);
  sketches.erase(sketches.begin() + 2, sketches.begin() + 4);
  const auto set = SketchedDeformers::build(sketches, *trunk.canvas).value();
  const auto mesh =
      mesh::TriangleMesh::build({{trunk.canvas->positions().begin(), trunk.canvas->positions().end()},
                                 {},
                                 {trunk.canvas->mesh().triangles().begin(), trunk.canvas->mesh().triangles().end()},
                                 {}})
          .value();
  const auto rig = rig::CharacterRig::make(mesh, {set}, nullptr).value();
  const rig::Pose answer = {0.8, 0.0, 0.4};
  std::vector<ModelPoint> posed(mesh->vertex_count());
  rig->evaluate(answer, posed);
  posing::PoseProblem problem;
  posing::CurvePair pair;
  for (std::uint32_t ring = 60; ring < Trunk::k_rings; ring += 2) {
    const std::uint32_t v = ring * Trunk::k_around + Trunk::k_around / 4;
    pair.reference.push_back(posing::at_vertex(v));
    pair.target.push_back(posed[v]);
  }
  problem.pairs.push_back(pair);
  problem.free = {0, 1, 2};
  problem.start = rig::rest_pose(*rig);
  posing::SolveWorkspace work;
  const auto solution = posing::solve(*rig, problem, {}, work).value();
  EXPECT_FALSE(solution.linear);
  EXPECT_LT(solution.energy, 0.01 * solution.energy_start);
}

TEST(SketchedDeformers, HashWhatWasDrawnInOrder) {
  const Trunk trunk = tests::make_trunk();
  auto sketches = five(trunk);
  const auto hash_of = [&] {
    base::StateHash hash;
    add_to_hash(hash, *SketchedDeformers::build(sketches, *trunk.canvas).value());
    return hash.digest();
  };
  const auto before = hash_of();
  EXPECT_EQ(before, hash_of());
  std::swap(sketches[0], sketches[1]);
  EXPECT_FALSE(before == hash_of());
}

}  // namespace
}  // namespace penpose::articulation
