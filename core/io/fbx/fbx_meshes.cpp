#include "core/io/fbx/fbx_meshes.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <optional>
#include <utility>

#include "core/io/remedies.h"
#include "core/io/surface/polygon.h"
#include "core/io/text/names.h"

namespace penpose::io {
namespace {

constexpr std::size_t k_most_vertices = std::size_t{16} << 20;
/// Numbers of deltas and weights that are looked at. A small file may name the same data very often.
constexpr std::size_t k_most_entries = std::size_t{64} << 20;
/// Polygons of more corners are cut as fans.
constexpr std::size_t k_most_corners = 500;

class Meshes {
 public:
  Meshes(const FbxScene& scene, const FbxJoints& joints, std::vector<std::string>& notes)
      : scene_(scene), joints_(joints), notes_(notes), world_(scene.to_world()) {}

  base::Result<FbxMeshes> read() {
    std::vector<std::string> names;
    for (const FbxObject& node : scene_.objects()) {
      if (node.kind != "Model") continue;
      for (const FbxObject* geometry : scene_.parts_of(node.id, "Geometry", "Mesh")) {
        if (auto status = add(node, *geometry); !status) return status.error();
        names.push_back(node.name);
      }
    }
    if (entries_ > k_most_entries)
      return base::Error{"the file names the same shapes or weights too often", "", "export it again"};
    if (out_.source.triangles.empty())
      return base::Error{"the file has no meshes", "", "export the meshes as well; curves and patches are no surface"};
    make_unique(names);
    for (std::size_t i = 0; i < names.size(); ++i) out_.source.parts[i].name = names[i];
    if (joints_.joints.empty()) out_.influences.clear();
    for (auto& [name, shape] : shapes_) {
      // Entries of one shape come in the order of the parts.
      rig::BlendShape one;
      one.parameter = {name, 0.0, std::min(0.0, shape.value), std::max(1.0, shape.value)};
      for (const auto& [vertex, delta] : shape.deltas) {
        one.vertices.push_back(vertex);
        one.deltas.push_back(delta);
      }
      order_.push_back({shape.order, out_.shapes.size()});
      out_.values.push_back(shape.value);
      out_.shapes.push_back(std::move(one));
    }
    sort_shapes();
    return std::move(out_);
  }

 private:
  struct Shape {
    std::size_t order = 0;
    double value = 0;
    std::map<std::uint32_t, glm::vec3> deltas;
  };

  void sort_shapes() {
    std::stable_sort(order_.begin(), order_.end());
    std::vector<rig::BlendShape> shapes;
    std::vector<double> values;
    for (const auto& [order, i] : order_) {
      shapes.push_back(std::move(out_.shapes[i]));
      values.push_back(out_.values[i]);
    }
    out_.shapes = std::move(shapes);
    out_.values = std::move(values);
  }

  /// False: too much has been looked at.
  bool spend(std::size_t entries) {
    entries_ += entries + 1;
    return entries_ <= k_most_entries;
  }
  [[nodiscard]] glm::dmat4 now_of(const FbxObject& node) const {
    glm::dmat4 m(1);
    std::size_t depth = 0;
    for (const FbxObject* one = &node; one != nullptr && ++depth < k_deepest_fbx_node; one = scene_.parent_of(*one))
      m = local_matrix(*one, transform_of(*one)) * m;
    return world_ * m;
  }
  /// The joint that a node hangs below, if any.
  [[nodiscard]] std::optional<std::uint32_t> carrier_of(const FbxObject& node) const {
    std::size_t depth = 0;
    for (const FbxObject* one = scene_.parent_of(node); one != nullptr && ++depth < k_deepest_fbx_node;
         one = scene_.parent_of(*one)) {
      if (const auto at = joints_.number.find(one->id); at != joints_.number.end()) return at->second;
    }
    return std::nullopt;
  }

  base::Status add(const FbxObject& node, const FbxObject& geometry) {
    const std::vector<double> numbers = geometry.record->numbers("Vertices");
    const std::vector<std::int64_t> corners = geometry.record->wholes("PolygonVertexIndex");
    mesh::Part part;
    part.first_vertex = static_cast<std::uint32_t>(out_.source.positions.size());
    part.vertex_count = static_cast<std::uint32_t>(numbers.size() / 3);
    part.first_triangle = static_cast<std::uint32_t>(out_.source.triangles.size());
    if (out_.source.positions.size() + numbers.size() / 3 > k_most_vertices)
      return base::Error{"the file has more than 16 million vertices", "mesh " + node.name, "export fewer meshes"};
    out_.influences.resize(part.first_vertex + part.vertex_count);
    glm::dmat4 placed = now_of(node) * geometric_matrix(node);
    if (!read_skin(node, geometry, part, placed)) carry(node, part, placed);
    for (std::size_t v = 0; v < part.vertex_count; ++v) {
      const glm::dvec4 at(numbers[3 * v], numbers[3 * v + 1], numbers[3 * v + 2], 1.0);
      out_.source.positions.emplace_back(glm::dvec3(placed * at));
    }
    if (auto status = add_polygons(node, corners, part); !status) return status;
    part.triangle_count = static_cast<std::uint32_t>(out_.source.triangles.size()) - part.first_triangle;
    out_.source.parts.push_back(part);
    out_.materials.push_back(material_of(node));
    for (const FbxObject* deformer : scene_.parts_of(geometry.id, "Deformer", "BlendShape")) {
      for (const FbxObject* channel : scene_.parts_of(deformer->id, "Deformer", "BlendShapeChannel"))
        read_channel(*channel, part, glm::dmat3(placed));
    }
    return base::Done{};
  }

  base::Status add_polygons(const FbxObject& node, const std::vector<std::int64_t>& corners, const mesh::Part& part) {
    std::vector<std::uint32_t> polygon;
    for (const std::int64_t corner : corners) {
      const std::int64_t v = corner < 0 ? -corner - 1 : corner;
      if (v < 0 || v >= static_cast<std::int64_t>(part.vertex_count))
        return base::Error{"a polygon has the corner " + std::to_string(v) + ", but there are " +
                               std::to_string(part.vertex_count) + " vertices",
                           "mesh " + node.name, k_export_again};
      polygon.push_back(part.first_vertex + static_cast<std::uint32_t>(v));
      if (corner >= 0) continue;
      if (polygon.size() >= 3 && polygon.size() <= k_most_corners) {
        triangulate(polygon, out_.source.positions, out_.source.triangles);
      } else {
        for (std::size_t i = 2; i < polygon.size(); ++i)
          out_.source.triangles.push_back({polygon[0], polygon[i - 1], polygon[i]});
      }
      polygon.clear();
    }
    return base::Done{};
  }

  /// False: the mesh has no skin. Sets where it was bound.
  bool read_skin(const FbxObject& node, const FbxObject& geometry, const mesh::Part& part, glm::dmat4& placed) {
    bool bound = false;
    for (const FbxObject* skin : scene_.parts_of(geometry.id, "Deformer", "Skin")) {
      for (const FbxObject* cluster : scene_.parts_of(skin->id, "Deformer", "Cluster")) {
        const auto links = scene_.parts_of(cluster->id, "Model");
        const auto joint = links.empty() ? joints_.number.end() : joints_.number.find(links.front()->id);
        if (joint == joints_.number.end()) continue;
        const std::vector<double> to_bone = cluster->record->numbers("Transform");
        if (!bound && to_bone.size() == 16) {
          glm::dmat4 m(1);
          for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = to_bone[static_cast<std::size_t>(i)];
          placed = joints_.bind[joint->second] * m * geometric_matrix(node);
          bound = true;
        }
        const std::vector<std::int64_t> indices = cluster->record->wholes("Indexes");
        const std::vector<double> weights = cluster->record->numbers("Weights");
        if (!spend(indices.size())) return bound;
        for (std::size_t i = 0; i < std::min(indices.size(), weights.size()); ++i) {
          if (indices[i] < 0 || indices[i] >= static_cast<std::int64_t>(part.vertex_count)) continue;
          if (!(weights[i] > 0.0) || !std::isfinite(weights[i])) continue;
          out_.influences[part.first_vertex + static_cast<std::size_t>(indices[i])].push_back(
              {joint->second, weights[i]});
        }
      }
    }
    return bound;
  }

  /// A mesh that hangs below a joint follows it as a whole.
  void carry(const FbxObject& node, const mesh::Part& part, glm::dmat4& placed) {
    const auto joint = carrier_of(node);
    if (!joint || glm::determinant(joints_.now[*joint]) == 0.0) return;
    placed = joints_.bind[*joint] * glm::inverse(joints_.now[*joint]) * placed;
    for (std::size_t v = 0; v < part.vertex_count; ++v) out_.influences[part.first_vertex + v] = {{*joint, 1.0}};
  }

  [[nodiscard]] document::Material material_of(const FbxObject& node) const {
    document::Material material;
    const auto all = scene_.parts_of(node.id, "Material");
    if (all.empty()) return material;
    material.name = all.front()->name;
    const glm::dvec3 color = FbxScene::vector(*all.front(), "DiffuseColor", glm::dvec3(0.8));
    for (int i = 0; i < 3; ++i) material.base_color[static_cast<std::size_t>(i)] = std::clamp(color[i], 0.0, 1.0);
    return material;
  }

  [[nodiscard]] std::map<std::uint32_t, glm::dvec3> deltas_of(const FbxObject& shape, const mesh::Part& part,
                                                              const glm::dmat3& placed) {
    std::map<std::uint32_t, glm::dvec3> out;
    const std::vector<std::int64_t> indices = shape.record->wholes("Indexes");
    const std::vector<double> numbers = shape.record->numbers("Vertices");
    if (!spend(indices.size())) return out;
    for (std::size_t i = 0; i < std::min(indices.size(), numbers.size() / 3); ++i) {
      if (indices[i] < 0 || indices[i] >= static_cast<std::int64_t>(part.vertex_count)) continue;
      const glm::dvec3 delta = placed * glm::dvec3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
      if (!std::isfinite(delta.x + delta.y + delta.z) || delta == glm::dvec3(0)) continue;
      out[part.first_vertex + static_cast<std::uint32_t>(indices[i])] = delta;
    }
    return out;
  }

  void add_shape(const std::string& name, double value, const std::map<std::uint32_t, glm::dvec3>& deltas) {
    auto [at, is_new] = shapes_.try_emplace(name);
    if (is_new) at->second.order = shapes_.size();
    if (is_new) at->second.value = value;
    for (const auto& [vertex, delta] : deltas) at->second.deltas[vertex] = glm::vec3(delta);
  }

  void read_channel(const FbxObject& channel, const mesh::Part& part, const glm::dmat3& placed) {
    const auto targets = scene_.parts_of(channel.id, "Geometry", "Shape");
    if (targets.empty()) return;
    const double value =
        FbxScene::property(
            channel, "DeformPercent",
            channel.record->find("DeformPercent") != nullptr ? channel.record->find("DeformPercent")->number(0) : 0.0) /
        100.0;
    const std::string& name = channel.name.empty() ? targets.back()->name : channel.name;
    const auto full = deltas_of(*targets.back(), part, placed);
    add_shape(name, std::isfinite(value) ? std::clamp(value, -10.0, 10.0) : 0.0, full);
    const std::vector<double> weights = channel.record->numbers("FullWeights");
    for (std::size_t i = 0; i + 1 < targets.size(); ++i) {
      const double percent = i < weights.size() ? weights[i] : 0.0;
      const double share = weights.size() == targets.size() && weights.back() > 0.0 ? percent / weights.back() : 0.0;
      auto more = deltas_of(*targets[i], part, placed);
      for (const auto& [vertex, delta] : full) more[vertex] -= delta * share;
      const std::string own =
          name + "_" +
          std::to_string(static_cast<int>(std::lround(std::isfinite(percent) ? std::clamp(percent, -1e6, 1e6) : 0.0)));
      if (!between_said_) notes_.push_back("shapes between others are controls of their own: " + own);
      between_said_ = true;
      add_shape(own, 0.0, more);
    }
  }

  const FbxScene& scene_;
  const FbxJoints& joints_;
  std::vector<std::string>& notes_;
  glm::dmat4 world_;
  FbxMeshes out_;
  std::map<std::string, Shape> shapes_;
  std::vector<std::pair<std::size_t, std::size_t>> order_;
  bool between_said_ = false;
  std::size_t entries_ = 0;
};

}  // namespace

base::Result<FbxMeshes> read_fbx_meshes(const FbxScene& scene, const FbxJoints& joints,
                                        std::vector<std::string>& notes) {
  return Meshes(scene, joints, notes).read();
}

}  // namespace penpose::io
