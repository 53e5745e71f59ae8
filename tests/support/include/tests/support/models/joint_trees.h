#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tests/support/models/test_rigs.h"

namespace penpose::tests {

/// A tree of joints at random places over a mesh, each hung on any joint before it, some of them not posable. Every
/// vertex is shared by up to three of the first two thirds; the others carry nothing.
inline std::shared_ptr<const rig::Skeleton> bushy_skeleton(const mesh::TriangleMesh& mesh, std::size_t count,
                                                           std::uint64_t seed) {
  Random random(seed);
  std::vector<rig::Joint> joints(count);
  std::vector<glm::dmat4> worlds(count);
  for (std::size_t j = 0; j < count; ++j) {
    joints[j].name = "joint" + std::to_string(j);
    joints[j].parent = j == 0 ? -1 : static_cast<std::int32_t>(random.index(j));
    joints[j].translation = random.vector(0.5);
    joints[j].rest_rotation = geometry::quaternion_from_xyz(random.vector(1));
    joints[j].posable = j % 7 != 3;
    const glm::dmat4 local = geometry::compose(joints[j].translation, joints[j].rest_rotation, {1, 1, 1});
    worlds[j] = j == 0 ? local : worlds[static_cast<std::size_t>(joints[j].parent)] * local;
    joints[j].inverse_bind = glm::inverse(worlds[j]);
  }
  std::vector<std::uint32_t> first{0};
  std::vector<rig::Influence> influences;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    for (std::size_t k = random.index(4); k > 0; --k)
      influences.push_back({static_cast<std::uint32_t>(random.index(2 * count / 3)), random(0.1, 1)});
    first.push_back(static_cast<std::uint32_t>(influences.size()));
  }
  return rig::Skeleton::make(std::move(joints), std::move(first), std::move(influences)).value();
}

}  // namespace penpose::tests
