#include "core/head/head.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <tuple>
#include <vector>

#include "core/mesh/topology.h"

namespace penpose::head {
namespace {

using geometry::ModelPoint;

const document::Model& model() {
  static const document::Model made = make_head();
  return made;
}
/// Vertices and triangles of the skin come first.
std::uint32_t skin_vertices() {
  const mesh::Part* last = model().mesh->find_part(k_skin_parts.back());
  return last->first_vertex + last->vertex_count;
}
std::vector<mesh::Triangle> welded_skin() {
  const mesh::Part* last = model().mesh->find_part(k_skin_parts.back());
  const auto all = model().mesh->triangles();
  std::vector<mesh::Triangle> skin(all.begin(), all.begin() + last->first_triangle + last->triangle_count);
  for (mesh::Triangle& t : skin) {
    for (std::uint32_t& v : t) v = model().mesh->weld()[v];
  }
  return skin;
}

TEST(Head, IsAHeadInMetres) {
  const geometry::Box box = document::rest_world_box(model());
  EXPECT_NEAR(box.center().x, 0, 0.005);
  EXPECT_NEAR(box.maximum.y - box.minimum.y, 0.29, 0.02) << "head and neck";
  EXPECT_NEAR(box.maximum.x - box.minimum.x, 0.17, 0.02) << "from ear to ear";
  ASSERT_EQ(model().materials.size(), model().mesh->parts().size());
  for (std::size_t i = 0; i < model().materials.size(); ++i) {
    EXPECT_EQ(model().materials[i].name, model().mesh->parts()[i].name);
  }
}

TEST(Head, SkinIsOneManifoldThatIsOpenAtTheNeckAndWhereTeethAndTongueHang) {
  const std::uint32_t count = skin_vertices();
  EXPECT_GE(count, 5000U);
  EXPECT_LE(count, 10000U);
  const auto components = model().mesh->components();
  for (std::uint32_t v = 0; v < count; ++v) ASSERT_EQ(components[v], 0U) << v;
  for (const mesh::Part& part : model().mesh->parts()) {
    if (part.first_vertex < count) continue;
    // Lower teeth and tongue hang on the floor of the mouth.
    const bool hangs = part.name == "teeth_lower" || part.name == "tongue";
    for (std::uint32_t v = part.first_vertex; v < part.first_vertex + part.vertex_count; ++v) {
      ASSERT_EQ(components[v] == 0U, hangs) << part.name << ' ' << v;
    }
  }

  const auto edges = mesh::sorted_edges(welded_skin(), model().mesh->vertex_count());
  std::size_t border = 0;
  std::size_t elsewhere = 0;
  double neck = 1e300;
  for (const auto& p : model().mesh->positions()) neck = std::min(neck, p.y);
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t next = i + 1;
    while (next < edges.size() && edges[next].low == edges[i].low && edges[next].high == edges[i].high) ++next;
    ASSERT_LE(next - i, 2U);
    if (next - i == 1) {
      ++border;
      const bool at_neck = model().mesh->positions()[edges[i].low].y < neck + 0.01 &&
                           model().mesh->positions()[edges[i].high].y < neck + 0.01;
      elsewhere += at_neck ? 0 : 1;
    }
    i = next;
  }
  EXPECT_GT(border, 20U);
  EXPECT_EQ(elsewhere, 6U) << "a triangle each where lower teeth and tongue hang on";
  // A surface with three borders and no handles: V - E + F = -1.
  std::vector<bool> used(model().mesh->vertex_count(), false);
  const auto skin = welded_skin();
  for (const auto& t : skin) {
    for (const std::uint32_t v : t) used[v] = true;
  }
  const auto vertices = std::count(used.begin(), used.end(), true);
  const auto edge_count = static_cast<std::ptrdiff_t>((skin.size() * 3 + border) / 2);
  EXPECT_EQ(vertices - edge_count + static_cast<std::ptrdiff_t>(skin.size()), -1);
}

TEST(Head, SkinIsMirrorSymmetricBitForBit) {
  using Key = std::tuple<double, double, double>;
  std::vector<Key> own;
  std::vector<Key> mirrored;
  const std::uint32_t count = skin_vertices();
  for (std::uint32_t v = 0; v < count; ++v) {
    const ModelPoint& p = model().mesh->positions()[v];
    own.emplace_back(p.x, p.y, p.z);
    mirrored.emplace_back(p.x == 0 ? 0 : -p.x, p.y, p.z);
  }
  std::sort(own.begin(), own.end());
  std::sort(mirrored.begin(), mirrored.end());
  EXPECT_EQ(own, mirrored);
}

TEST(Head, NoSkinInsideTheEyeballs) {
  const HeadLandmarks landmarks = head_landmarks();
  EXPECT_EQ(landmarks.left.center.x, -landmarks.right.center.x);
  for (const Eyeball& eye : {landmarks.left, landmarks.right}) {
    double nearest = 1e300;
    for (std::uint32_t v = 0; v < skin_vertices(); ++v) {
      nearest = std::min(nearest, geometry::distance(model().mesh->positions()[v], eye.center) / eye.radius);
    }
    EXPECT_GT(nearest, 1.01);
    EXPECT_LT(nearest, 1.03);
  }
}

TEST(Head, EyeballsAreWhereTheLandmarksSay) {
  const HeadLandmarks landmarks = head_landmarks();
  for (const auto& [name, eye] : {std::pair{"eye_L", landmarks.left}, std::pair{"eye_R", landmarks.right}}) {
    const mesh::Part* part = model().mesh->find_part(name);
    ASSERT_NE(part, nullptr);
    for (std::uint32_t v = part->first_vertex; v < part->first_vertex + part->vertex_count; ++v) {
      EXPECT_NEAR(geometry::distance(model().mesh->positions()[v], eye.center), eye.radius, 1e-8);
    }
  }
}

TEST(Head, IsTheSameEveryTime) {
  EXPECT_EQ(document::state_hash(make_head()).hex(), document::state_hash(model()).hex());
}

}  // namespace
}  // namespace penpose::head
