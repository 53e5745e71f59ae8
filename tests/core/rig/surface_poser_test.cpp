#include "core/rig/surface_poser.h"

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/support/models/test_rigs.h"

namespace penpose::rig {
namespace {

bool same_bits(std::span<const glm::vec3> a, std::span<const glm::vec3> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

std::vector<std::shared_ptr<const CharacterRig>> rigs() {
  std::vector<std::shared_ptr<const CharacterRig>> all;
  const auto grid = tests::grid_mesh(17, 11);
  all.push_back(CharacterRig::make(grid, {tests::random_shapes(*grid, 12, 3)}, nullptr).value());
  const auto ball = tests::ball_mesh(13, 15);
  all.push_back(CharacterRig::make(ball, {tests::random_shapes(*ball, 70, 4, 0.8)}, nullptr).value());
  all.push_back(
      CharacterRig::make(grid, {tests::random_shapes(*grid, 5, 6)}, tests::chain_skeleton(*grid, 3, 0.4)).value());
  all.push_back(
      CharacterRig::make(grid, {tests::random_shapes(*grid, 2, 6)}, nullptr).value());  // most of it never moves
  return all;
}

/// Moves a few parameters, or all, or none.
void change(Pose& pose, const CharacterRig& rig, tests::Random& random) {
  const std::size_t count = random.index(3) == 0 ? pose.size() : random.index(3);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t p = count == pose.size() ? i : random.index(pose.size());
    pose[p] = random.index(3) == 0 ? rig.parameters()[p].rest
                                   : random(rig.parameters()[p].minimum, rig.parameters()[p].maximum);
  }
}

TEST(SurfacePoser, StandsWhereTheRigIsToFloatPrecision) {
  tests::Random random(1);
  for (const auto& rig : rigs()) {
    SurfacePoser poser(rig);
    Pose pose = rest_pose(*rig);
    for (int i = 0; i < 20; ++i) {
      poser.update(pose);
      const auto exact = tests::all_positions(*rig, pose);
      for (std::size_t v = 0; v < exact.size(); ++v) {
        EXPECT_NEAR(geometry::distance(ModelPoint(poser.positions()[v]), exact[v]), 0, 4e-6) << v;
      }
      change(pose, *rig, random);
    }
  }
}

TEST(SurfacePoser, ThePoseAloneDecidesWhateverCameBefore) {
  tests::Random random(2);
  for (const auto& rig : rigs()) {
    SurfacePoser used(rig);
    Pose pose = rest_pose(*rig);
    for (int i = 0; i < 30; ++i) {
      change(pose, *rig, random);
      used.update(pose);
      SurfacePoser fresh(rig);
      fresh.update(pose);
      EXPECT_TRUE(same_bits(used.positions(), fresh.positions())) << "step " << i;
      EXPECT_TRUE(same_bits(used.normals(), fresh.normals())) << "step " << i;
    }
  }
}

/// The same surface facing nowhere in particular: all normals from all triangles.
void expect_area_weighted_normals(const SurfacePoser& poser, const mesh::TriangleMesh& mesh) {
  std::vector<geometry::ModelVector> sums(mesh.vertex_count(), geometry::ModelVector{0});
  const auto at = [&](std::uint32_t v) { return ModelPoint(poser.positions()[v]); };
  for (const auto& t : mesh.triangles()) {
    const auto area = glm::cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]));
    for (const std::uint32_t v : t) sums[mesh.smoothing()[v]] += area;
  }
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    const auto expected = geometry::normalized(sums[mesh.smoothing()[v]]);
    EXPECT_NEAR(geometry::distance(ModelPoint(poser.normals()[v]), expected), 0, 2e-4) << "vertex " << v;
  }
}

TEST(SurfacePoser, NormalsAreThoseOfAllTrianglesByArea) {
  tests::Random random(3);
  for (const auto& rig : rigs()) {
    SurfacePoser poser(rig);
    expect_area_weighted_normals(poser, rig->mesh());
    Pose pose = rest_pose(*rig);
    for (int i = 0; i < 10; ++i) {
      change(pose, *rig, random);
      poser.update(pose);
      expect_area_weighted_normals(poser, rig->mesh());
    }
  }
}

TEST(SurfacePoser, TellsWhetherAnythingChanged) {
  const auto rig = rigs().front();
  SurfacePoser poser(rig);
  Pose pose = rest_pose(*rig);
  EXPECT_FALSE(poser.update(pose));
  EXPECT_EQ(poser.revision(), 0U);
  pose[3] = 0.5;
  EXPECT_TRUE(poser.update(pose));
  EXPECT_FALSE(poser.update(pose));
  EXPECT_EQ(poser.revision(), 1U);
  pose[3] = 0;
  EXPECT_TRUE(poser.update(pose));
  EXPECT_EQ(poser.revision(), 2U);
}

TEST(SurfacePoser, TouchesOnlyWhatAParameterMoves) {
  const auto mesh = tests::grid_mesh(20, 20);
  const auto shapes = tests::random_shapes(*mesh, 6, 9, 0.15);
  const auto rig = CharacterRig::make(mesh, {shapes}, nullptr).value();
  SurfacePoser poser(rig);
  const std::vector<glm::vec3> before(poser.positions().begin(), poser.positions().end());
  Pose pose = rest_pose(*rig);
  pose[2] = 1;
  poser.update(pose);
  std::size_t moved = 0;
  for (std::uint32_t v = 0; v < mesh->vertex_count(); ++v) {
    bool belongs = false;
    for (const auto& entry : shapes->entries_of(v)) belongs |= entry.shape == 2;
    if (!belongs) {
      EXPECT_EQ(poser.positions()[v], before[v]);
    }
    moved += poser.positions()[v] != before[v] ? 1 : 0;
  }
  EXPECT_GT(moved, 5U);
}

TEST(SurfacePoser, StartsAtTheRestPoseOfItsParameters) {
  const auto mesh = tests::grid_mesh(1, 1);
  std::vector<BlendShape> shapes(1);
  shapes[0].parameter = {"up", 0.5, 0, 1};
  shapes[0].vertices = {0, 1, 2, 3};
  shapes[0].deltas.assign(4, {0, 0, 2});
  const auto rig = CharacterRig::make(mesh, {BlendShapes::make(shapes, 4).value()}, nullptr).value();
  const SurfacePoser poser(rig);
  EXPECT_EQ(poser.positions()[3], (glm::vec3{1, 1, 1}));
}

TEST(SurfacePoser, ASurfaceThatCollapsesAndComesBackHasItsNormalsAgain) {
  // The shape folds the whole sheet into one point.
  const auto mesh = tests::grid_mesh(4, 4);
  std::vector<BlendShape> shapes(2);
  BlendShape& fold = shapes[0];
  BlendShape& tilt = shapes[1];
  fold.parameter.name = "fold";
  tilt.parameter.name = "tilt";
  for (std::uint32_t v = 0; v < mesh->vertex_count(); ++v) {
    fold.vertices.push_back(v);
    fold.deltas.emplace_back(-glm::vec3(mesh->positions()[v]));
    tilt.vertices.push_back(v);
    tilt.deltas.emplace_back(0, 0, static_cast<float>(mesh->positions()[v].x));
  }
  const auto rig = CharacterRig::make(mesh, {BlendShapes::make(shapes, mesh->vertex_count()).value()}, nullptr);
  ASSERT_TRUE(rig);
  SurfacePoser poser(rig.value());
  poser.update(Pose{0, 1});
  poser.update(Pose{1, 0});
  SurfacePoser fresh(rig.value());
  fresh.update(Pose{1, 0});
  EXPECT_TRUE(same_bits(poser.normals(), fresh.normals()));
  for (const glm::vec3& n : poser.normals()) EXPECT_NEAR(glm::length(n), 1, 1e-5);
  poser.update(Pose{0, 0});
  for (const glm::vec3& n : poser.normals()) EXPECT_EQ(n, (glm::vec3{0, 0, 1}));
}

TEST(SurfacePoser, NormalsHoldInAnyUnit) {
  for (const double size : {1e-6, 1e6}) {
    const auto mesh = tests::ball_mesh(12, 12, size);
    const auto rig = CharacterRig::make(mesh, {}, nullptr).value();
    const SurfacePoser poser(rig);
    for (std::uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      const auto outward = geometry::normalized(mesh->positions()[v]);
      EXPECT_GT(glm::dot(ModelPoint(poser.normals()[v]), outward), 0.98) << size;
    }
  }
}

}  // namespace
}  // namespace penpose::rig
