#include "core/io/fbx/fbx_meshes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/io/fbx/fbx_skin.h"
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
  Meshes(const FbxScene& scene, FbxPlaces& places, FbxJoints& joints, std::vector<std::string>& notes)
      : scene_(scene), places_(places), joints_(joints), notes_(notes), shapes_(scene) {}

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
    take_shapes();
    return std::move(out_);
  }

 private:
  /// False: too much has been looked at.
  bool spend(std::size_t entries) {
    entries_ += entries + 1;
    return entries_ <= k_most_entries;
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
    FbxSkin skin = read_fbx_skin(scene_, node, geometry, numbers, places_, joints_);
    if (!spend(skin.looked_at)) return base::Done{};
    for (std::size_t v = 0; v < part.vertex_count; ++v) {
      const glm::dvec4 at(numbers[3 * v], numbers[3 * v + 1], numbers[3 * v + 2], 1.0);
      const bool loose = v < skin.loose.size() && skin.loose[v];
      out_.source.positions.emplace_back(glm::dvec3((loose ? skin.placed_loose : skin.placed) * at));
      out_.influences.push_back(std::move(skin.influences[v]));
    }
    if (auto status = add_polygons(node, corners, part); !status) return status;
    part.triangle_count = static_cast<std::uint32_t>(out_.source.triangles.size()) - part.first_triangle;
    out_.source.parts.push_back(part);
    out_.materials.push_back(material_of(node));
    for (const FbxObject* deformer : scene_.parts_of(geometry.id, "Deformer", "BlendShape")) {
      for (const FbxObject* channel : scene_.parts_of(deformer->id, "Deformer", "BlendShapeChannel")) {
        if (entries_ > k_most_entries) break;
        spend(shapes_.add(*channel,
                          {static_cast<std::uint32_t>(out_.source.parts.size()), part.first_vertex, part.vertex_count,
                           node.name, glm::dmat3(skin.placed), glm::dmat3(skin.placed_loose), &skin.loose}));
      }
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

  [[nodiscard]] document::Material material_of(const FbxObject& node) const {
    document::Material material;
    const auto all = scene_.parts_of(node.id, "Material");
    if (all.empty()) return material;
    material.name = all.front()->name;
    const glm::dvec3 color = FbxScene::vector(*all.front(), "DiffuseColor", glm::dvec3(0.8));
    for (int i = 0; i < 3; ++i) material.base_color[static_cast<std::size_t>(i)] = std::clamp(color[i], 0.0, 1.0);
    return material;
  }

  void take_shapes() {
    std::vector<std::string> names;
    for (const rig::BlendShape& shape : shapes_.shapes) names.push_back(shape.parameter.name);
    make_unique(names);
    for (std::size_t i = 0; i < names.size(); ++i) shapes_.shapes[i].parameter.name = names[i];
    out_.shapes = std::move(shapes_.shapes);
    out_.values = std::move(shapes_.values);
    out_.channels = std::move(shapes_.channels);
    if (shapes_.between.empty()) return;
    notes_.push_back(std::to_string(shapes_.between.size()) +
                     " shapes that a channel goes through on its way are controls of their own, and its keys move "
                     "them: " +
                     shapes_.between.front() + (shapes_.between.size() > 1 ? ", ..." : ""));
  }

  const FbxScene& scene_;
  FbxPlaces& places_;
  FbxJoints& joints_;
  std::vector<std::string>& notes_;
  FbxMeshes out_;
  FbxShapes shapes_;
  std::size_t entries_ = 0;
};

}  // namespace

base::Result<FbxMeshes> read_fbx_meshes(const FbxScene& scene, FbxPlaces& places, FbxJoints& joints,
                                        std::vector<std::string>& notes) {
  return Meshes(scene, places, joints, notes).read();
}

}  // namespace penpose::io
