// Subdivision of our own gives the bits of OpenMesh's, which all sessions on the built-in head were recorded with.
#include "core/mesh/subdivision.h"

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <vector>

#include "core/mesh/subdivision_by_halfedges.h"

namespace penpose::mesh {
namespace {

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
  const auto theirs = catmull_clark(mesh);
  const auto ours = catmull_clark_by_halfedges(mesh);
  ASSERT_EQ(static_cast<bool>(theirs), static_cast<bool>(ours)) << "seed " << seed;
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
