#include "core/io/fbx/fbx_skin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <optional>

#include "core/geometry/space.h"

namespace penpose::io {
namespace {

/// Bindings that differ by less than this share of the mesh's size are one.
constexpr double k_same_binding = 1e-4;

class SkinReader {
 public:
  SkinReader(const FbxScene& scene, const FbxObject& node, const FbxObject& geometry, const std::vector<double>& points,
             FbxPlaces& places, FbxJoints& joints)
      : scene_(scene), node_(node), geometry_(geometry), points_(points), places_(places), joints_(joints) {}

  FbxSkin read() {
    skin_.influences.resize(points_.size() / 3);
    const bool bound = read_clusters();
    place_rest(bound);
    if (!bound) skin_.placed = skin_.placed_loose;
    return std::move(skin_);
  }

 private:
  bool read_clusters() {
    bool bound = false;
    for (const FbxObject* skin : scene_.parts_of(geometry_.id, "Deformer", "Skin")) {
      for (const FbxObject* cluster : scene_.parts_of(skin->id, "Deformer", "Cluster")) {
        const auto links = scene_.parts_of(cluster->id, "Model");
        const auto at = links.empty() ? joints_.number.end() : joints_.number.find(links.front()->id);
        if (at == joints_.number.end()) continue;
        const std::vector<std::int64_t> indices = cluster->record->wholes("Indexes");
        const std::vector<double> weights = cluster->record->numbers("Weights");
        skin_.looked_at += indices.size() + 1;
        if (indices.empty() && bound) continue;
        const std::uint32_t joint = joint_of(at->second.full, to_bone(*cluster, *links.front()), bound);
        bound = true;
        for (std::size_t i = 0; i < std::min(indices.size(), weights.size()); ++i) {
          if (indices[i] < 0 || indices[i] >= static_cast<std::int64_t>(skin_.influences.size())) continue;
          if (!(weights[i] > 0.0) || !std::isfinite(weights[i])) continue;
          skin_.influences[static_cast<std::size_t>(indices[i])].push_back({joint, weights[i]});
        }
      }
    }
    return bound;
  }

  /// From the mesh to the bone when it was bound.
  glm::dmat4 to_bone(const FbxObject& cluster, const FbxObject& bone) {
    const std::vector<double> numbers = cluster.record->numbers("Transform");
    const bool said = numbers.size() == 16 &&
                      std::any_of(numbers.begin(), numbers.end(), [](double one) { return one != 0.0; }) &&
                      std::all_of(numbers.begin(), numbers.end(), [](double one) { return std::isfinite(one); });
    if (!said) {
      const glm::dmat4& full = places_.of(bone).full;
      return (glm::determinant(full) != 0.0 ? glm::inverse(full) : glm::dmat4(1)) * places_.of(node_).full *
             geometric_matrix(node_);
    }
    glm::dmat4 m(1);
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = numbers[static_cast<std::size_t>(i)];
    return m * geometric_matrix(node_);
  }

  /// The joint that takes vertices at rest to where `to_bone` has them; the first binding of a mesh says where they
  /// are at rest.
  std::uint32_t joint_of(std::uint32_t joint, const glm::dmat4& to_bone, bool bound) {
    if (!bound) {
      skin_.placed = joints_.bind[joint] * to_bone;
      return joint;
    }
    if (glm::determinant(skin_.placed) == 0.0 || same(joints_.joints[joint].inverse_bind * skin_.placed, to_bone))
      return joint;
    const auto first = static_cast<std::uint32_t>(joints_.joints.size());
    for (const std::uint32_t other : more_of(joint)) {
      if (same(joints_.joints[other].inverse_bind * skin_.placed, to_bone)) return other;
    }
    rig::Joint more;
    more.name = joints_.joints[joint].name;
    more.parent = static_cast<std::int32_t>(joint);
    more.posable = false;
    more.inverse_bind = to_bone * glm::inverse(skin_.placed);
    joints_.joints.push_back(std::move(more));
    joints_.bind.push_back(glm::inverse(joints_.joints.back().inverse_bind));
    joints_.more[joint].push_back(first);
    return first;
  }
  [[nodiscard]] const std::vector<std::uint32_t>& more_of(std::uint32_t joint) { return joints_.more[joint]; }

  [[nodiscard]] bool same(const glm::dmat4& a, const glm::dmat4& b) {
    if (corners_.empty()) find_corners();
    double size = 0;
    double off = 0;
    for (const glm::dvec4& corner : corners_) {
      size = std::max(size, geometry::length(glm::dvec3(b * (corner - corners_.front()))));
      off = std::max(off, geometry::length(glm::dvec3(a * corner - b * corner)));
    }
    return off <= k_same_binding * size;
  }
  void find_corners() {
    glm::dvec3 low(0);
    glm::dvec3 high(0);
    for (std::size_t v = 0; v + 2 < points_.size(); v += 3) {
      for (int i = 0; i < 3; ++i) {
        const double one = points_[v + static_cast<std::size_t>(i)];
        low[i] = v == 0 ? one : std::min(low[i], one);
        high[i] = v == 0 ? one : std::max(high[i], one);
      }
    }
    for (unsigned corner = 0; corner < 8; ++corner)
      corners_.emplace_back((corner & 1U) != 0 ? high.x : low.x, (corner & 2U) != 0 ? high.y : low.y,
                            (corner & 4U) != 0 ? high.z : low.z, 1.0);
  }

  /// Vertices without a joint of a skin.
  void place_rest(bool bound) {
    const FbxObject* carrier = &node_;
    glm::dmat4 below(1);
    std::size_t depth = 0;
    while (carrier != nullptr && !joints_.number.contains(carrier->id) && ++depth < k_deepest_fbx_node) {
      below = places_.of(*carrier).local * below;
      carrier = scene_.parent_of(*carrier);
    }
    const auto at = carrier == nullptr ? joints_.number.end() : joints_.number.find(carrier->id);
    const bool carried = at != joints_.number.end();
    skin_.placed_loose =
        (carried ? joints_.bind[at->second.full] * below : scene_.to_world() * places_.of(node_).full) *
        geometric_matrix(node_);
    if (bound) skin_.loose.resize(skin_.influences.size());
    for (std::size_t v = 0; v < skin_.influences.size(); ++v) {
      if (!skin_.influences[v].empty()) continue;
      if (bound) skin_.loose[v] = true;
      if (carried) skin_.influences[v] = {{at->second.full, 1.0}};
    }
  }

  const FbxScene& scene_;
  const FbxObject& node_;
  const FbxObject& geometry_;
  const std::vector<double>& points_;
  FbxPlaces& places_;
  FbxJoints& joints_;
  std::vector<glm::dvec4> corners_;
  FbxSkin skin_;
};

}  // namespace

FbxSkin read_fbx_skin(const FbxScene& scene, const FbxObject& node, const FbxObject& geometry,
                      const std::vector<double>& points, FbxPlaces& places, FbxJoints& joints) {
  return SkinReader(scene, node, geometry, points, places, joints).read();
}

}  // namespace penpose::io
