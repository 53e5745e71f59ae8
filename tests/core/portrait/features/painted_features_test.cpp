#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "core/mesh/mesh_point.h"
#include "core/portrait/features/find_features.h"
#include "core/rig/blend_shapes.h"
#include "core/rig/character_rig.h"
#include "tests/core/portrait/shared_heads.h"

namespace penpose::portrait {
namespace {

using geometry::ModelPoint;

const FoundCurve* curve_named(const std::vector<FoundCurve>& all, const std::string& name) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const FoundCurve& f) { return f.curve.name == name; });
  return at == all.end() ? nullptr : &*at;
}

TEST(PaintedFeatures, BrowsAreWhereTheyArePainted) {
  // The built-in head without its parts, of which one is the brows, and without controls.
  const document::Model model = character::make_demo_head().value();
  std::vector<ModelPoint> rest(model.mesh->vertex_count());
  model.rig->evaluate(rig::rest_pose(*model.rig), rest);
  mesh::MeshSource source;
  source.positions = rest;
  source.triangles.assign(model.mesh->triangles().begin(), model.mesh->triangles().end());
  const std::shared_ptr<const mesh::TriangleMesh> mesh = mesh::TriangleMesh::build(std::move(source)).value();
  const auto rig = rig::CharacterRig::make(mesh, {}, nullptr).value();
  const intent::WholeModel whole = intent::measure_whole_model(*rig);
  const auto plain = find_features(*rig, *mesh, whole, model.front_yaw_degrees);
  const FoundCurve* lid = curve_named(plain, "eyelid_upper_L");
  const FoundCurve* other = curve_named(plain, "eyelid_upper_R");
  ASSERT_TRUE(lid && other);
  const auto middle = [&](const FoundCurve& found) {
    ModelPoint sum(0);
    const tests::Line line = tests::places_of(found.curve, rest);
    for (const ModelPoint& p : line) sum += p / static_cast<double>(line.size());
    return sum;
  };
  const ModelPoint left = middle(*lid), right = middle(*other);
  const double eyes = left.x - right.x;
  // A dark strip, a little tilted, over each eye.
  const double height = left.y + 0.42 * eyes;
  const auto row = [&](double x) { return height + 0.1 * (std::abs(x) - 0.5 * eyes); };
  const SurfacePaint paint = [&](const mesh::MeshPoint& point) -> std::array<double, 4> {
    const ModelPoint p = mesh::position_of(point, mesh->triangles(), rest);
    const bool strip = std::abs(std::abs(p.x) - 0.5 * eyes) < 0.3 * eyes && std::abs(p.y - row(p.x)) < 0.035 * eyes;
    return strip ? std::array<double, 4>{0.25, 0.18, 0.15, 1} : std::array<double, 4>{0.85, 0.7, 0.6, 1};
  };
  const auto found = find_features(*rig, *mesh, whole, model.front_yaw_degrees, paint);
  for (const char* name : {"brow_L", "brow_R"}) {
    const FoundCurve* brow = curve_named(found, name);
    ASSERT_TRUE(brow) << name;
    EXPECT_GE(brow->sureness, k_sure) << name;
    for (const ModelPoint& p : tests::places_of(brow->curve, rest)) EXPECT_NEAR(p.y, row(p.x), 0.05 * eyes) << name;
  }
}

/// Boxes and discs before a plate, as flat faces have them; the eyes can shut.
struct FlatHead {
  std::vector<ModelPoint> positions;
  std::vector<mesh::Triangle> triangles;

  std::uint32_t add(const ModelPoint& p) {
    positions.push_back(p);
    return static_cast<std::uint32_t>(positions.size() - 1);
  }
  /// Returns the number of its first vertex.
  std::uint32_t add_disc(double x, double y, double z, double half_width, double half_height) {
    constexpr std::uint32_t k_around = 16;
    const std::uint32_t middle = add({x, y, z});
    for (std::uint32_t i = 0; i < k_around; ++i) {
      const double angle = 2 * 3.14159265358979 * i / k_around;
      add({x + half_width * std::cos(angle), y + half_height * std::sin(angle), z});
    }
    for (std::uint32_t i = 0; i < k_around; ++i)
      triangles.push_back({middle, middle + 1 + i, middle + 1 + (i + 1) % k_around});
    return middle;
  }
};

TEST(PaintedFeatures, AFlatFaceHasEyesBrowsAndAMouth) {
  FlatHead head;
  head.add_disc(0, 0, 0, 1.6, 1.6);
  const std::uint32_t right = head.add_disc(-0.5, 0.2, 0.1, 0.17, 0.17),
                      left = head.add_disc(0.5, 0.2, 0.1, 0.17, 0.17);
  const std::uint32_t brow = head.add_disc(-0.5, 0.62, 0.1, 0.26, 0.05);
  head.add_disc(0.5, 0.62, 0.1, 0.26, 0.05);
  const std::uint32_t mouth = head.add_disc(0, -0.75, 0.1, 0.4, 0.06);
  const std::size_t count = head.positions.size();
  const auto mesh = mesh::TriangleMesh::build({head.positions, {}, head.triangles, {}}).value();
  std::vector<rig::BlendShape> shapes(3);
  const auto squash = [&](rig::BlendShape& shape, std::uint32_t first, double by) {
    for (std::uint32_t v = first; v < first + 17; ++v) {
      shape.vertices.push_back(v);
      shape.deltas.emplace_back(0, by * (head.positions[first].y - head.positions[v].y), 0);
    }
  };
  squash(shapes[0], right, 0.95);
  squash(shapes[0], left, 0.95);
  squash(shapes[1], mouth, -3);
  for (std::uint32_t v = brow; v < brow + 34; ++v) {
    shapes[2].vertices.push_back(v);
    shapes[2].deltas.emplace_back(0, 0.2, 0);
  }
  for (std::size_t k = 0; k < shapes.size(); ++k) shapes[k].parameter.name = std::to_string(k);
  std::vector<std::shared_ptr<const rig::DisplacementLayer>> layers;
  layers.push_back(rig::BlendShapes::make(std::move(shapes), count).value());
  const auto rig = rig::CharacterRig::make(mesh, layers, nullptr).value();
  const auto found = find_features(*rig, *mesh, intent::measure_whole_model(*rig), 0);
  const auto expect_at = [&](const char* name, double x, double y) {
    const FoundCurve* curve = curve_named(found, name);
    ASSERT_TRUE(curve) << name;
    for (const ModelPoint& p : tests::places_of(curve->curve, head.positions)) {
      EXPECT_NEAR(p.x, x, 0.45) << name;
      EXPECT_NEAR(p.y, y, 0.2) << name;
    }
  };
  expect_at("eyelid_upper_R", -0.5, 0.25);
  expect_at("eyelid_lower_L", 0.5, 0.15);
  expect_at("brow_R", -0.5, 0.62);
  expect_at("brow_L", 0.5, 0.62);
  expect_at("lip_upper_outer", 0, -0.72);
  expect_at("lip_lower_outer", 0, -0.78);
}

}  // namespace
}  // namespace penpose::portrait
