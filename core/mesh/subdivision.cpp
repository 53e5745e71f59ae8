#include "core/mesh/subdivision.h"

#include <algorithm>
#include <string>

#include "core/mesh/halfedges.h"

namespace penpose::mesh {
namespace {

using geometry::ModelPoint;

base::Error bad_quad(std::size_t quad, const char* what) {
  return {what, "quad " + std::to_string(quad), "use quads that form a manifold"};
}

ModelPoint divided(const ModelPoint& p, double by) { return {p.x / by, p.y / by, p.z / by}; }

ModelPoint middle_of(const QuadMesh& mesh, const Quad& quad) {
  ModelPoint sum{0, 0, 0};
  for (const std::uint32_t v : quad) sum = sum + mesh.positions[v];
  return divided(sum, 4);
}

/// Half of a border edge; of an inner one the mean of its ends and of the middles of both quads.
ModelPoint edge_point(const QuadMesh& mesh, const Halfedges& edges, const std::vector<ModelPoint>& middles,
                      std::size_t edge) {
  const auto along = static_cast<Halfedges::Id>(2 * edge);
  const Halfedges::Id against = Halfedges::opposite(along);
  ModelPoint sum = mesh.positions[edges.end(along)] + mesh.positions[edges.end(against)];
  if (edges.is_border(along) || edges.is_border(against)) return sum * 0.5;
  sum = sum + middles[edges.face(along)];
  sum = sum + middles[edges.face(against)];
  return sum * 0.25;
}

/// F/n + 2E/n + (n - 3)V/n, formed from the neighbours P of V: with E the mean of (V + P)/2 it is the sum of P over n
/// squared, (n - 2)V/n, and the sum of F over n squared.
ModelPoint inner_point(const QuadMesh& mesh, const Halfedges& edges, const std::vector<ModelPoint>& middles,
                       std::uint32_t vertex) {
  const Halfedges::Id first = edges.outgoing(vertex);
  ModelPoint ends{0, 0, 0};
  ModelPoint faces{0, 0, 0};
  double valence = 0;
  Halfedges::Id halfedge = first;
  do {
    ends = ends + mesh.positions[edges.end(halfedge)];
    faces = faces + middles[edges.face(halfedge)];
    valence += 1;
    halfedge = edges.turned(halfedge);
  } while (halfedge != first);
  const ModelPoint own = divided(mesh.positions[vertex] * (valence - 2), valence);
  return divided(ends, valence * valence) + (own + divided(faces, valence * valence));
}

/// A third of the vertex and the points of its border edges. (Of a vertex without quads, which nothing shows, a third.)
ModelPoint border_point(const QuadMesh& mesh, const Halfedges& edges, const std::vector<ModelPoint>& edge_points,
                        std::uint32_t vertex) {
  ModelPoint sum = mesh.positions[vertex];
  const Halfedges::Id first = edges.outgoing(vertex);
  if (first == Halfedges::k_none) return divided(sum, 3);
  Halfedges::Id halfedge = first;
  do {
    if (edges.is_border(halfedge) || edges.is_border(Halfedges::opposite(halfedge))) {
      sum = sum + edge_points[halfedge / 2];
    }
    halfedge = edges.turned(halfedge);
  } while (halfedge != first);
  return divided(sum, 3);
}

}  // namespace

base::Result<QuadMesh> catmull_clark(const QuadMesh& mesh) {
  const std::size_t count = mesh.quads.size();
  Halfedges edges(mesh.positions.size());
  for (std::size_t q = 0; q < count; ++q) {
    Quad sorted = mesh.quads[q];
    std::stable_sort(sorted.begin(), sorted.end());
    if (sorted[3] >= mesh.positions.size()) return bad_quad(q, "an index is out of range");
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) return bad_quad(q, "a vertex is repeated");
    if (!edges.add(mesh.quads[q])) return bad_quad(q, "the mesh is no manifold");
  }
  std::vector<ModelPoint> middles;
  for (const Quad& quad : mesh.quads) middles.push_back(middle_of(mesh, quad));
  std::vector<ModelPoint> edge_points;
  for (std::size_t e = 0; e < edges.edge_count(); ++e) edge_points.push_back(edge_point(mesh, edges, middles, e));

  // Vertices of the mesh, then one an edge, then one a quad.
  QuadMesh finer;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const Halfedges::Id first = edges.outgoing(v);
    const bool inner = first != Halfedges::k_none && !edges.is_border(first);
    finer.positions.push_back(inner ? inner_point(mesh, edges, middles, v) : border_point(mesh, edges, edge_points, v));
  }
  const auto first_edge = static_cast<std::uint32_t>(finer.positions.size());
  finer.positions.insert(finer.positions.end(), edge_points.begin(), edge_points.end());
  const auto first_middle = static_cast<std::uint32_t>(finer.positions.size());
  finer.positions.insert(finer.positions.end(), middles.begin(), middles.end());

  // Of the four quads of quad q one is quad q again, the one before the edge of the highest number; the three that
  // follow it around q come after all of those.
  finer.quads.resize(4 * count);
  finer.parents.resize(4 * count);
  for (std::size_t q = 0; q < count; ++q) {
    const Quad& quad = mesh.quads[q];
    Quad sides{};
    for (std::size_t i = 0; i < 4; ++i) sides[i] = edges.find(quad[i], quad[(i + 1) & 3U]) / 2;
    const auto last = static_cast<std::size_t>(std::max_element(sides.begin(), sides.end()) - sides.begin());
    for (std::size_t turn = 0; turn < 4; ++turn) {
      const std::size_t corner = (last + turn) & 3U;
      const std::size_t place = turn == 0 ? q : count + 3 * q + turn - 1;
      finer.quads[place] = {first_middle + static_cast<std::uint32_t>(q), first_edge + sides[(corner + 3) & 3U],
                            quad[corner], first_edge + sides[corner]};
      finer.parents[place] = static_cast<std::uint32_t>(q);
    }
  }
  return finer;
}

}  // namespace penpose::mesh
