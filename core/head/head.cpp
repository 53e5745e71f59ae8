#include "core/head/head.h"

#include <cstdlib>
#include <string>
#include <utility>

#include "core/head/curves.h"
#include "core/head/parts.h"
#include "core/head/skin.h"

namespace penpose::head {
namespace {

constexpr double k_metre = 0.01;

struct Assembly {
  mesh::MeshSource source;
  std::vector<document::Material> materials;

  void add(const std::string& name, const Surface& surface, document::Material material, bool mirror = false) {
    mesh::Part part;
    part.name = name;
    part.first_vertex = static_cast<std::uint32_t>(source.positions.size());
    part.vertex_count = static_cast<std::uint32_t>(surface.points.size());
    part.first_triangle = static_cast<std::uint32_t>(source.triangles.size());
    part.triangle_count = static_cast<std::uint32_t>(surface.triangles.size());
    for (const ModelPoint& p : surface.points) {
      source.positions.push_back(ModelPoint{mirror ? -p.x : p.x, p.y, p.z} * k_metre);
    }
    for (const mesh::Triangle& t : surface.triangles) {
      const std::uint32_t f = part.first_vertex;
      source.triangles.push_back(mirror ? mesh::Triangle{f + t[0], f + t[2], f + t[1]}
                                        : mesh::Triangle{f + t[0], f + t[1], f + t[2]});
    }
    source.parts.push_back(std::move(part));
    material.name = name;
    materials.push_back(std::move(material));
  }
};

document::Material material(double r, double g, double b, double roughness) { return {"", {r, g, b, 1}, 0, roughness}; }

}  // namespace

HeadLandmarks head_landmarks() {
  const ModelPoint center = ModelPoint{k_eye_center[0], k_eye_center[1], k_eye_center[2]} * k_metre;
  return {{center, k_eye_radius * k_metre}, {{-center.x, center.y, center.z}, k_eye_radius * k_metre}};
}

document::Model make_head() {
  const auto half = make_half();
  if (!half) std::abort();
  Assembly head;
  Skin skin = make_skin(*half);
  Surface teeth_lower = make_teeth_lower();
  Surface tongue = make_tongue();
  hang_on(skin.lining, teeth_lower);
  hang_on(skin.lining, tongue);
  head.add("skin", skin.bare, material(0.62, 0.40, 0.29, 0.55));
  head.add("lips", skin.lips, material(0.54, 0.27, 0.21, 0.42));
  head.add("brows", skin.brows, material(0.09, 0.045, 0.025, 0.7));
  head.add("lining", skin.lining, material(0.035, 0.008, 0.008, 0.9));
  head.add("lashes", skin.lashes, material(0.05, 0.028, 0.02, 0.6));
  const auto skin_triangles = static_cast<std::uint32_t>(head.source.triangles.size());
  const Surface white = make_eye_cap(1, 0, 180, 10, 22);
  const Surface rim = make_eye_cap(1.004, 17.2, 19.2, 1, 28);
  const Surface iris = make_eye_cap(1.004, 8.2, 17.2, 2, 28);
  const Surface pupil = make_eye_cap(1.004, 0, 8.2, 2, 28);
  for (const bool right : {false, true}) {
    const std::string side = right ? "_R" : "_L";
    head.add("eye" + side, white, material(0.82, 0.80, 0.77, 0.15), right);
    head.add("iris_rim" + side, rim, material(0.02, 0.03, 0.035, 0.15), right);
    head.add("iris" + side, iris, material(0.07, 0.16, 0.19, 0.15), right);
    head.add("pupil" + side, pupil, material(0.006, 0.006, 0.007, 0.1), right);
  }
  head.add("teeth", make_teeth(), material(0.78, 0.74, 0.66, 0.25));
  head.add("teeth_lower", teeth_lower, material(0.74, 0.70, 0.62, 0.3));
  head.add("tongue", tongue, material(0.36, 0.10, 0.09, 0.5));
  head.add("hair", make_hair(skin.bare), material(0.10, 0.05, 0.028, 0.5));
  auto built = mesh::TriangleMesh::build(std::move(head.source));
  if (!built) std::abort();
  auto model = document::make_model(std::move(built).value(), nullptr, nullptr);
  if (!model) std::abort();
  model->materials = std::move(head.materials);
  model->curves = make_curves(*half, *model->mesh, skin_triangles, k_metre);
  return std::move(model).value();
}

}  // namespace penpose::head
