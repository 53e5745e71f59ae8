#include <chrono>
#include <gtest/gtest.h>
#include <set>

#include "core/io/model/read_model.h"
#include "core/io/model/write_model.h"
#include "tests/support/shared_data.h"

namespace penpose::io {
namespace {

document::Model load(const char* name) {
  auto model = read_model(tests::read_file(tests::shared_dir() / "meshes" / name), name);
  EXPECT_TRUE(model.ok()) << model.error().line(name);
  return std::move(model).value();
}

std::size_t welded_vertices(const document::Model& model) {
  const auto weld = model.mesh->weld();
  return std::set<std::uint32_t>(weld.begin(), weld.end()).size();
}

struct Counts {
  std::size_t vertices, triangles, components, welded;
  friend bool operator==(const Counts&, const Counts&) = default;
};

Counts counts_of(const document::Model& model) {
  return {model.mesh->vertex_count(), model.mesh->triangle_count(), model.mesh->component_count(),
          welded_vertices(model)};
}

TEST(SharedMeshes, IctFaceIsOnePartOfManyComponentsThatAreNotWelded) {
  if (!tests::has_shared()) GTEST_SKIP();
  const auto model = load("ict_face.glb");
  EXPECT_EQ(counts_of(model), (Counts{26719, 52220, 56, 26719}));
  ASSERT_EQ(model.shapes->shapes().size(), 53U);
  EXPECT_EQ(model.shapes->parameters()[26].name, "jawOpen");
  EXPECT_EQ(model.skeleton, nullptr);
  EXPECT_EQ(model.materials[0].base_color[1], 0.62);
  EXPECT_TRUE(model.notes.empty());
}

TEST(SharedMeshes, IctFaceNarrowHasEyesThatTurn) {
  if (!tests::has_shared()) GTEST_SKIP();
  auto model = load("ict_face_narrow.glb");
  const auto parts = model.mesh->parts();
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0].name, "skin");
  EXPECT_EQ(parts[0].vertex_count, 11248U);
  EXPECT_EQ(parts[0].triangle_count, 22288U);
  EXPECT_EQ(parts[1].name, "eye_L");
  EXPECT_EQ(parts[1].vertex_count, 1570U);
  EXPECT_EQ(parts[2].triangle_count, 3132U);
  EXPECT_EQ(model.mesh->component_count(), 5U);
  EXPECT_EQ(model.rig->parameters().size(), 53U + 6U);
  EXPECT_EQ(model.rig->parameters()[53].name, "eye_L.rx");
  // Turning an eye keeps its vertices on the ball about the node's place, and moves nothing else.
  const auto before = document::posed_positions(model);
  model.pose[54] = 0.5;
  const auto after = document::posed_positions(model);
  const geometry::ModelPoint center(3.116454418286649, 3.6015845819231096, 7.982298611259564);
  double moved = 0;
  for (std::size_t v = 0; v < before.size(); ++v) {
    if (v < parts[1].first_vertex || v >= parts[2].first_vertex) {
      EXPECT_EQ(before[v], after[v]);
      continue;
    }
    EXPECT_NEAR(geometry::distance(before[v], center), geometry::distance(after[v], center), 1e-9);
    moved = std::max(moved, geometry::distance(before[v], after[v]));
  }
  EXPECT_NEAR(moved, 0.8, 0.05);  // half a radian on a ball of about 1.6
}

TEST(SharedMeshes, ElephantIsOneClosedSurfaceInBothFormats) {
  if (!tests::has_shared()) GTEST_SKIP();
  for (const char* name : {"elephant.glb", "elephant.obj"}) {
    const auto model = load(name);
    EXPECT_EQ(model.mesh->vertex_count(), 2775U);
    EXPECT_EQ(model.mesh->triangle_count(), 5558U);
    EXPECT_EQ(model.mesh->component_count(), 1U);
    EXPECT_TRUE(model.rig->parameters().empty());
  }
}

TEST(SharedMeshes, CesiumManStandsUpAndIsWelded) {
  if (!tests::has_shared()) GTEST_SKIP();
  const auto model = load("cesium_man.glb");
  EXPECT_EQ(counts_of(model), (Counts{3273, 4672, 1, 2338}));
  EXPECT_EQ(model.skeleton->parameters().size(), 19U * 3U);
  ASSERT_EQ(model.animations.size(), 1U);
  EXPECT_EQ(model.animations[0].channels.size(), 57U);
  const auto box = document::rest_world_box(model);
  EXPECT_NEAR(box.maximum.y - box.minimum.y, 1.5, 0.02);
  EXPECT_NEAR(box.minimum.y, 0, 0.01);
}

TEST(SharedMeshes, CubeIsScaledByItsNode) {
  if (!tests::has_shared()) GTEST_SKIP();
  const auto model = load("animated_morph_cube.glb");
  EXPECT_EQ(counts_of(model), (Counts{24, 12, 1, 8}));
  ASSERT_EQ(model.rig->parameters().size(), 2U);
  EXPECT_EQ(model.rig->parameters()[0].name, "Cube.target0");
  EXPECT_FALSE(model.shapes->shapes()[1].normal_deltas.empty());
  ASSERT_EQ(model.animations.size(), 1U);
  EXPECT_NEAR(document::rest_world_box(model).maximum.x, 1.0, 1e-6);
}

TEST(SharedMeshes, EverythingWrittenLoadsBackEqual) {
  if (!tests::has_shared()) GTEST_SKIP();
  for (const char* name : {"ict_face.glb", "ict_face_narrow.glb", "elephant.obj", "elephant.glb", "cesium_man.glb",
                           "animated_morph_cube.glb"}) {
    auto model = load(name);
    for (std::size_t i = 0; i < model.pose.size(); i += 2) model.pose[i] = 0.3 * model.rig->parameters()[i].maximum;
    const auto again = read_model(write_glb(model).value(), "again.glb");
    ASSERT_TRUE(again.ok()) << again.error().line(name);
    EXPECT_EQ(document::state_hash(*again), document::state_hash(model)) << name;
  }
}

}  // namespace
}  // namespace penpose::io
