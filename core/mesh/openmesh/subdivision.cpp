#include "core/mesh/subdivision.h"

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <algorithm>
#include <exception>
#include <new>
#include <string>

namespace penpose::mesh {
namespace {

struct DoubleTraits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<DoubleTraits>;
using Subdivider = OpenMesh::Subdivider::Uniform::CatmullClarkT<PolyMesh, double>;

base::Error wrong_quad(std::size_t quad, const char* what) {
  return {what, "quad " + std::to_string(quad), "use quads that form a manifold"};
}

}  // namespace

base::Result<QuadMesh> catmull_clark(const QuadMesh& mesh) {
  PolyMesh poly;
  for (const auto& p : mesh.positions) poly.add_vertex({p.x, p.y, p.z});
  for (std::size_t q = 0; q < mesh.quads.size(); ++q) {
    std::vector<PolyMesh::VertexHandle> corners;
    Quad sorted = mesh.quads[q];
    std::stable_sort(sorted.begin(), sorted.end());
    if (sorted[3] >= mesh.positions.size()) return wrong_quad(q, "an index is out of range");
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return wrong_quad(q, "a vertex is repeated");
    for (const std::uint32_t v : mesh.quads[q]) corners.emplace_back(static_cast<int>(v));
    // OpenMesh says why on std::cerr; the error returned here is the only one that a user sees.
    ::omerr().disable();
    const bool added = poly.add_face(corners).is_valid();
    ::omerr().enable();
    if (!added) return wrong_quad(q, "the mesh is no manifold");
  }
  const auto first_middle = static_cast<std::uint32_t>(poly.n_vertices() + poly.n_edges());
  try {
    Subdivider subdivider;
    if (!subdivider(poly, 1)) return base::Error{"the mesh cannot be subdivided", "", ""};
  } catch (const std::bad_alloc&) {
    throw;  // that there is no memory says nothing of the mesh
  } catch (const std::exception& problem) {
    return base::Error{problem.what(), "", ""};
  }
  QuadMesh finer;
  finer.positions.reserve(poly.n_vertices());
  for (const auto v : poly.vertices()) {
    const auto& p = poly.point(v);
    finer.positions.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto f : poly.faces()) {
    Quad quad{};
    std::size_t corner = 0;
    for (const auto v : poly.fv_range(f)) quad[corner++ & 3U] = static_cast<std::uint32_t>(v.idx());
    // Middles were added last, one a face and in the order of faces: exactly one corner is such.
    std::rotate(quad.begin(), std::max_element(quad.begin(), quad.end()), quad.end());
    finer.quads.push_back(quad);
    finer.parents.push_back(quad[0] - first_middle);
  }
  return finer;
}

}  // namespace penpose::mesh
