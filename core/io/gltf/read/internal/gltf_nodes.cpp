#include "core/io/gltf/read/internal/gltf_nodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_access.hpp>
#include <glm/matrix.hpp>

#include "core/geometry/rotation.h"

namespace penpose::io {
namespace {

// A product of a few dozen of these stays finite.
constexpr double k_largest = 1e15;

base::Error wrong_node(std::string what, std::string pointer, std::string remedy) {
  return {std::move(what), std::move(pointer), std::move(remedy)};
}

bool all_moderate(const std::vector<double>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::abs(n) <= k_largest; });
}

/// Axes of length one that are perpendicular to each other, for columns of which some may be zero.
glm::dmat3 unit_axes(const glm::dmat3& columns, const glm::dvec3& lengths) {
  glm::dmat3 axes(1);
  std::array<bool, 3> known{};
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    known[static_cast<std::size_t>(i)] = lengths[i] > 0.0;
    if (!known[static_cast<std::size_t>(i)]) continue;
    axes[i] = columns[i] / lengths[i];
    ++count;
  }
  if (count == 0) return glm::dmat3(1);
  if (count == 1) {
    int one = 0;
    while (!known[static_cast<std::size_t>(one)]) ++one;
    const glm::dvec3 a = axes[one];
    const glm::dvec3 other = std::abs(a.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    axes[(one + 1) % 3] = geometry::normalized(glm::cross(a, other));
    axes[(one + 2) % 3] = glm::cross(a, axes[(one + 1) % 3]);
    return axes;
  }
  if (count == 2) {
    int none = 0;
    while (known[static_cast<std::size_t>(none)]) ++none;
    axes[none] = geometry::normalized(glm::cross(axes[(none + 1) % 3], axes[(none + 2) % 3]));
  }
  return axes;
}

/// Whether the axes stand in no right angles to each other.
bool shears(const glm::dmat3& axes) {
  constexpr double k_shear = 1e-4;
  for (int i = 0; i < 3; ++i) {
    if (std::abs(glm::dot(axes[i], axes[(i + 1) % 3])) > k_shear) return true;
  }
  return false;
}

/// The nearest axes in right angles: the mean with the inverse transpose, again and again, ends at the rotation of the
/// polar decomposition (Higham 1986). Axes in one plane have no inverse: the third is then made of the first two, and
/// where these are one, nothing is turned.
glm::dmat3 straightened(glm::dmat3 axes) {
  constexpr int k_steps = 60;
  constexpr double k_flat = 1e-9;
  for (int step = 0; step < k_steps; ++step) {
    if (std::abs(glm::determinant(axes)) < k_flat) {
      const glm::dvec3 normal = glm::cross(axes[0], axes[1]);
      if (geometry::length(normal) < k_flat) return glm::dmat3(1);
      axes[2] = geometry::normalized(normal);
    }
    axes = 0.5 * (axes + glm::transpose(glm::inverse(axes)));
  }
  return axes;
}

base::Result<NodeTransform> take_apart(const std::vector<double>& m, const std::string& pointer) {
  // Programs that multiply matrices in single precision leave traces in the last row.
  constexpr double k_near = 1e-5;
  const bool affine =
      std::abs(m[3]) < k_near && std::abs(m[7]) < k_near && std::abs(m[11]) < k_near && std::abs(m[15] - 1.0) < k_near;
  if (!affine || !all_moderate(m)) {
    return wrong_node("the matrix is no transform of space", pointer, "export the file again with valid transforms");
  }
  const glm::dmat3 columns(m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]);
  NodeTransform transform;
  transform.translation = {m[12], m[13], m[14]};
  for (int i = 0; i < 3; ++i) transform.scale[i] = geometry::length(columns[i]);
  glm::dmat3 axes = unit_axes(columns, transform.scale);
  if (shears(axes)) {
    transform.sheared = true;
    axes = straightened(axes);
  }
  if (glm::determinant(axes) < 0.0) {
    transform.scale.x = -transform.scale.x;
    axes[0] = -axes[0];
  }
  const glm::dquat turned = glm::quat_cast(axes);
  transform.rotation = turned / std::sqrt(glm::dot(turned, turned));
  return transform;
}

}  // namespace

std::string node_pointer(std::size_t node) { return "/nodes/" + std::to_string(node); }

base::Result<NodeTransform> node_transform(const GltfDocument& document, std::size_t index) {
  const tinygltf::Node& node = document.model.nodes[index];
  const std::string pointer = node_pointer(index);
  if (!node.matrix.empty()) return take_apart(node.matrix, pointer + "/matrix");
  if (!all_moderate(node.translation) || !all_moderate(node.scale) || !all_moderate(node.rotation)) {
    return wrong_node("the transform has a number that is too large", pointer,
                      "export the file again with valid transforms");
  }
  NodeTransform transform;
  if (node.translation.size() == 3)
    transform.translation = {node.translation[0], node.translation[1], node.translation[2]};
  if (node.scale.size() == 3) transform.scale = {node.scale[0], node.scale[1], node.scale[2]};
  if (node.rotation.size() == 4) {
    const auto& r = node.rotation;
    transform.rotation = glm::dquat(r[3], r[0], r[1], r[2]);
    if (!(glm::dot(transform.rotation, transform.rotation) > 1e-12)) transform.rotation = glm::dquat(1, 0, 0, 0);
  }
  return transform;
}

NodeTree make_node_tree(const GltfDocument& document) {
  const auto& nodes = document.model.nodes;
  NodeTree tree;
  tree.parent.assign(nodes.size(), -1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const int node : nodes[i].children) tree.parent[static_cast<std::size_t>(node)] = static_cast<std::int32_t>(i);
  }
  const auto& scenes = document.model.scenes;
  tree.in_scene.assign(nodes.size(), scenes.empty());
  if (scenes.empty()) return tree;
  const int scene = document.model.defaultScene >= 0 ? document.model.defaultScene : 0;
  std::vector<int> open = scenes[static_cast<std::size_t>(scene)].nodes;
  while (!open.empty()) {
    const auto node = static_cast<std::size_t>(open.back());
    open.pop_back();
    if (tree.in_scene[node]) continue;
    tree.in_scene[node] = true;
    open.insert(open.end(), nodes[node].children.begin(), nodes[node].children.end());
  }
  return tree;
}

}  // namespace penpose::io
