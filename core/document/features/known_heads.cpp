#include "core/document/features/known_heads.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "core/rig/rig.h"

namespace penpose::document {
namespace {

/// Vertices of the face, the head and the neck, which come first in every cut of ICT FaceKit.
constexpr std::size_t k_ict_skin_vertices = 11248;
constexpr std::array<const char*, 3> k_ict_names{"jawOpen", "eyeBlink_L", "browInnerUp_L"};

std::vector<VertexCurve> ict_curves() {
  return {{"brow_R", {268, 493, 1914, 2044, 1401}},
          {"brow_L", {3615, 4240, 4114, 2734, 2509}},
          {"eyelid_upper_R", {1507, 1542, 1537, 1528}},
          {"eyelid_lower_R", {1507, 1511, 1518, 1528}},
          {"eyelid_upper_L", {3742, 3751, 3756, 3721}},
          {"eyelid_lower_L", {3742, 3732, 3725, 3721}},
          {"lip_upper", {5708, 5695, 2081, 0, 4275, 6200, 6213}},
          {"lip_lower", {5708, 5841, 5957, 5518, 6461, 6346, 6213}},
          {"lip_upper_inner", {5702, 5711, 5533, 6216, 6207}},
          {"lip_lower_inner", {5702, 5966, 5517, 6470, 6207}}};
}

/// A vertex of the curves and its neighbour along a side of one of the quads that the kit is made of: every
/// triangulation of it has these edges, whosever face it is.
constexpr std::array<std::array<std::uint32_t, 2>, 42> k_ict_edges{
    {{268, 267},   {493, 295},   {1914, 309},  {2044, 2038}, {1401, 1402}, {3615, 3616}, {4240, 4234},
     {4114, 2550}, {2734, 2536}, {2509, 2508}, {1507, 570},  {1542, 1023}, {1537, 617},  {1528, 620},
     {1511, 860},  {1518, 591},  {3742, 2861}, {3751, 2858}, {3756, 3243}, {3721, 2811}, {3732, 2832},
     {3725, 3101}, {5708, 5680}, {5695, 143},  {2081, 154},  {0, 2},       {4275, 2395}, {6200, 2384},
     {6213, 6185}, {5841, 5825}, {5957, 5956}, {5518, 5520}, {6461, 6460}, {6346, 6330}, {5702, 5674},
     {5711, 5656}, {5533, 5526}, {6216, 6161}, {6207, 6179}, {5966, 5867}, {5517, 5515}, {6470, 6372}}};

/// How many of the edges the mesh has.
std::size_t edges_of(const mesh::TriangleMesh& mesh) {
  std::vector<bool> there(k_ict_edges.size(), false);
  for (const mesh::Triangle& triangle : mesh.triangles()) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k];
      const std::uint32_t b = triangle[(k + 1) % 3];
      for (std::size_t e = 0; e < k_ict_edges.size(); ++e) {
        const auto& edge = k_ict_edges[e];
        if ((edge[0] == a && edge[1] == b) || (edge[0] == b && edge[1] == a)) there[e] = true;
      }
    }
  }
  return static_cast<std::size_t>(std::count(there.begin(), there.end(), true));
}

geometry::ModelPoint middle_of(std::span<const geometry::ModelPoint> positions, const std::vector<VertexCurve>& curves,
                               std::size_t first, std::size_t last) {
  geometry::ModelPoint sum(0);
  double count = 0;
  for (std::size_t c = first; c <= last; ++c) {
    for (const std::uint32_t v : curves[c].vertices) {
      sum += positions[v];
      count += 1;
    }
  }
  return sum / count;
}

}  // namespace

std::vector<VertexCurve> known_head_curves(const Model& model) {
  const auto positions = model.mesh->positions();
  if (positions.size() < k_ict_skin_vertices || !model.shapes) return {};
  // Names alone may be those of many heads, edges alone are enough.
  const std::size_t edges = edges_of(*model.mesh);
  const bool named = std::all_of(k_ict_names.begin(), k_ict_names.end(), [&](const char* name) {
    return rig::find_parameter(model.rig->parameters(), name).has_value();
  });
  constexpr double k_surely = 0.9;
  constexpr double k_with_names = 0.6;
  if (static_cast<double>(edges) < (named ? k_with_names : k_surely) * static_cast<double>(k_ict_edges.size()))
    return {};
  auto curves = ict_curves();
  // From the brows down to the mouth come the eyes, however the head is turned and whatever its form.
  const auto brows = middle_of(positions, curves, 0, 1);
  const auto eyes = middle_of(positions, curves, 2, 5);
  const auto lips = middle_of(positions, curves, 6, 9);
  const geometry::ModelVector down = lips - brows;
  const double along = glm::dot(eyes - brows, down);
  if (!(along > 0 && along < glm::dot(down, down))) curves.clear();
  return curves;
}

}  // namespace penpose::document
