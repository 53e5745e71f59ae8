// Subdivision gives the bits of OpenMesh's, which the first sessions on the built-in head were recorded with.
#include "core/mesh/subdivision.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <optional>
#include <vector>

namespace penpose::mesh {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;
using Subdivider = OpenMesh::Subdivider::Uniform::CatmullClarkT<PolyMesh, double>;

/// Its quads as they come, each rotated so that it starts with the vertex in the middle; nothing where a quad is
/// refused.
std::optional<QuadMesh> by_openmesh(const QuadMesh& mesh) {
  PolyMesh poly;
  for (const auto& p : mesh.positions) poly.add_vertex({p.x, p.y, p.z});
  ::omerr().disable();
  for (const Quad& quad : mesh.quads) {
    std::vector<PolyMesh::VertexHandle> corners;
    for (const std::uint32_t v : quad) corners.emplace_back(static_cast<int>(v));
    if (!poly.add_face(corners).is_valid()) {
      ::omerr().enable();
      return std::nullopt;
    }
  }
  ::omerr().enable();
  Subdivider subdivider;
  if (!subdivider(poly, 1)) return std::nullopt;
  QuadMesh finer;
  for (const auto v : poly.vertices())
    finer.positions.emplace_back(poly.point(v)[0], poly.point(v)[1], poly.point(v)[2]);
  for (const auto f : poly.faces()) {
    Quad quad{};
    std::size_t corner = 0;
    for (const auto v : poly.fv_range(f)) quad[corner++ & 3U] = static_cast<std::uint32_t>(v.idx());
    std::rotate(quad.begin(), std::max_element(quad.begin(), quad.end()), quad.end());
    finer.quads.push_back(quad);
  }
  return finer;
}

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed * 2654435769U + 88172645463325252U) {}
  std::uint64_t next() {
    state_ ^= state_ << 13U;
    state_ ^= state_ >> 7U;
    state_ ^= state_ << 17U;
    return state_;
  }
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() % count); }
  double number() { return static_cast<double>(next() % 2000001U) * 1e-6 - 1; }

 private:
  std::uint64_t state_;
};

/// A grid of quads, closed to a tube or a ring of tubes or left open, some of it cut out, in any order.
QuadMesh shuffled_grid(Dice& dice) {
  const std::size_t columns = 3 + dice.below(5);
  const std::size_t rows = 3 + dice.below(5);
  const bool around = dice.below(2) == 0;
  const bool along = dice.below(2) == 0;
  QuadMesh mesh;
  for (std::size_t i = 0; i < columns * rows; ++i)
    mesh.positions.emplace_back(dice.number(), dice.number(), dice.number());
  const std::size_t cut = dice.below(4) * 15;
  for (std::size_t r = 0; r + (along ? 0 : 1) < rows; ++r) {
    for (std::size_t c = 0; c + (around ? 0 : 1) < columns; ++c) {
      if (dice.below(100) < cut) continue;
      const auto at = [&](std::size_t row, std::size_t column) {
        return static_cast<std::uint32_t>(row % rows * columns + column % columns);
      };
      Quad quad{at(r, c), at(r, c + 1), at(r + 1, c + 1), at(r + 1, c)};
      std::rotate(quad.begin(), quad.begin() + static_cast<std::ptrdiff_t>(dice.below(4)), quad.end());
      mesh.quads.push_back(quad);
    }
  }
  for (std::size_t i = mesh.quads.size(); i > 1; --i) std::swap(mesh.quads[i - 1], mesh.quads[dice.below(i)]);
  return mesh;
}

/// A quad that may tear the rules: two corners changed for each other, or one for any vertex.
void spoil(QuadMesh& mesh, Dice& dice) {
  if (mesh.quads.empty()) return;
  Quad& quad = mesh.quads[dice.below(mesh.quads.size())];
  if (dice.below(2) == 0) {
    std::swap(quad[0], quad[1 + dice.below(3)]);
    return;
  }
  const auto other = static_cast<std::uint32_t>(dice.below(mesh.positions.size()));
  if (std::find(quad.begin(), quad.end(), other) == quad.end()) quad[dice.below(4)] = other;
}

void expect_same(const QuadMesh& mesh, std::uint64_t seed) {
  const auto theirs = by_openmesh(mesh);
  const auto ours = catmull_clark(mesh);
  ASSERT_EQ(theirs.has_value(), static_cast<bool>(ours)) << "seed " << seed;
  if (!theirs) return;
  EXPECT_TRUE(theirs->quads == ours->quads) << "seed " << seed;
  EXPECT_TRUE(theirs->positions == ours->positions) << "seed " << seed;
}

TEST(SubdivisionPeer, GridsWithHolesInAnyOrder) {
  std::size_t refused = 0;
  for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
    Dice dice(seed);
    const QuadMesh mesh = shuffled_grid(dice);
    expect_same(mesh, seed);
    if (HasFatalFailure()) return;
    if (!catmull_clark(mesh)) ++refused;
  }
  // The comparison is of meshes, not of refusals: few orders of a torn grid cannot be built one quad after the other.
  EXPECT_LT(refused, 600U);
}

TEST(SubdivisionPeer, SpoiledGridsAreRefusedAlike) {
  std::size_t refused = 0;
  for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
    Dice dice(seed + 100000);
    QuadMesh mesh = shuffled_grid(dice);
    spoil(mesh, dice);
    expect_same(mesh, seed);
    if (HasFatalFailure()) return;
    if (!catmull_clark(mesh)) ++refused;
  }
  EXPECT_GT(refused, 500U);
}

TEST(SubdivisionPeer, TwoLevels) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    Dice dice(seed + 200000);
    auto once = catmull_clark(shuffled_grid(dice));
    if (!once) continue;
    expect_same(*once, seed);
    if (HasFatalFailure()) return;
  }
}

}  // namespace
}  // namespace penpose::mesh
