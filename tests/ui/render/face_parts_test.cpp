#include "ui/render/face_parts.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "core/io/model/read_model.h"
#include "tests/support/models/render_shapes.h"
#include "tests/support/shared_data.h"

namespace penpose::render {
namespace {

/// A strip bent around an eye from `low` to `high` eyeball radii.
void add_strip(mesh::MeshSource& source, geometry::ModelPoint middle, double low, double high) {
  const auto first = static_cast<std::uint32_t>(source.positions.size());
  constexpr int k_steps = 8;
  for (int i = 0; i <= k_steps; ++i) {
    const double turn = -0.6 + 1.2 * i / k_steps;
    for (const double r : {low, high}) {
      source.positions.push_back(middle + r * geometry::ModelVector{std::sin(turn), 0.3, std::cos(turn)} / 1.044);
    }
  }
  for (std::uint32_t i = 0; i < k_steps; ++i) {
    const std::uint32_t a = first + 2 * i;
    source.triangles.push_back({a, a + 2, a + 3});
    source.triangles.push_back({a, a + 3, a + 1});
  }
}

/// A head of radius 10 with two bulging eyes of radius 1.2, a cover and lashes before each, and ten teeth.
/// Components: 0 head; then for each side eye, cover, lash; then teeth.
mesh::MeshSource head(double scale = 1, int eyes = 2) {
  mesh::MeshSource source;
  add_sphere(source, geometry::ModelPoint{0}, 10 * scale);
  for (int side = 0; side < eyes; ++side) {
    const geometry::ModelPoint middle = geometry::ModelPoint{side == 0 ? 3 : -3, 2, 8} * scale;
    add_sphere(source, middle, 1.2 * scale, 12, 0.08);
    add_strip(source, middle, 1.2 * scale, 1.25 * scale);
    add_strip(source, middle, 1.3 * scale, 2.2 * scale);
  }
  for (int tooth = 0; tooth < 10; ++tooth) {
    add_box(source, geometry::ModelPoint{-2 + 0.45 * tooth, -3, 8.5} * scale,
            geometry::ModelVector{0.2, 0.3, 0.1} * scale);
  }
  return source;
}

TEST(FaceParts, TellsThePartsOfAHeadApartAtAnyScale) {
  for (const double scale : {1e-4, 1.0, 1e4}) {
    const auto mesh = mesh::TriangleMesh::build(head(scale)).value();
    const FaceParts found = recognise_face_parts(*mesh, mesh->positions());
    using enum PartKind;
    const std::vector<PartKind> wanted{surface, eyeball, eye_cover, lash,  eyeball, eye_cover, lash,  tooth, tooth,
                                       tooth,   tooth,   tooth,     tooth, tooth,   tooth,     tooth, tooth};
    EXPECT_EQ(found.kind_of_component, wanted) << scale;
    ASSERT_EQ(found.eyes.size(), 2U);
    EXPECT_NEAR(found.eyes[0].radius, 1.2 * scale, 0.05 * scale);
    EXPECT_GT(found.eyes[0].gaze.z, 0.99);
  }
}

TEST(FaceParts, OneBallOrNoneIsNoFace) {
  for (const int eyes : {0, 1}) {
    const auto mesh = mesh::TriangleMesh::build(head(1, eyes)).value();
    const FaceParts found = recognise_face_parts(*mesh, mesh->positions());
    EXPECT_TRUE(found.eyes.empty());
    EXPECT_EQ(std::count(found.kind_of_component.begin(), found.kind_of_component.end(), PartKind::surface),
              static_cast<std::ptrdiff_t>(found.kind_of_component.size()));
  }
}

TEST(SharedFaceParts, OfTheWholeFaceAsItsDescriptionListsThem) {
  if (!tests::has_shared()) GTEST_SKIP();
  const auto bytes = tests::read_file(tests::shared_dir() / "meshes" / "ict_face.glb");
  const auto model = io::read_model(bytes, "ict_face.glb").value();
  const FaceParts found = recognise_face_parts(*model.mesh, model.mesh->positions());
  const auto expect = [&](std::uint32_t first, std::uint32_t last, PartKind kind) {
    for (std::uint32_t v = first; v <= last; ++v) {
      ASSERT_EQ(found.kind_of_component[model.mesh->components()[v]], kind) << v;
    }
  };
  expect(0, 14061, PartKind::surface);
  expect(14062, 17038, PartKind::gum);
  expect(17039, 21450, PartKind::tooth);
  expect(21451, 24590, PartKind::eyeball);
  expect(24591, 25350, PartKind::eye_cover);
  expect(25351, 26718, PartKind::lash);
}

TEST(SharedFaceParts, BodiesAndAnimalsHaveNone) {
  if (!tests::has_shared()) GTEST_SKIP();
  for (const char* name : {"elephant.glb", "cesium_man.glb", "animated_morph_cube.glb"}) {
    const auto model = io::read_model(tests::read_file(tests::shared_dir() / "meshes" / name), name).value();
    EXPECT_TRUE(recognise_face_parts(*model.mesh, document::posed_positions(model)).eyes.empty()) << name;
  }
}

}  // namespace
}  // namespace penpose::render
