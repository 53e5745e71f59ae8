#include "core/articulation/measure/strain.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/mesh/topology.h"

namespace penpose::articulation {
namespace {

/// A triangle pressed to this share of its area counts as pressed to nothing.
constexpr double k_flat = 0.02;
/// A triangle counts as turned over already where it stands nearly upright on the surface around it (the sum of three
/// unit normals against its own).
constexpr double k_steep = 0.15;
/// Cosine between the normals at an edge below which two triangles count as lying on each other: 110 degrees.
constexpr double k_folded = -0.34;

/// The same as geometry::length, here where it is asked for most.
inline double length_of(const ModelVector& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

/// How much a triangle with this normal faces as the surface at its corners does.
inline double facing(const ModelVector& normal, const ModelVector& a, const ModelVector& b, const ModelVector& c) {
  const ModelVector around = a + b + c;
  const double size = length_of(normal);
  return size > 0.0 ? glm::dot(normal, around) / size : 0.0;
}

}  // namespace

Strain worse(const Strain& a, const Strain& b) {
  Strain both = a.stretch >= b.stretch ? a : b;
  both.energy = a.energy + b.energy;
  both.turned_over = std::max(a.turned_over, b.turned_over);
  both.creased = std::max(a.creased, b.creased);
  return both;
}

Strainmeter::Strainmeter(const Patch& patch, Creases creases)
    : patch_(patch),
      places_(patch.rests().begin(), patch.rests().end()),
      normals_(patch.triangles().size()),
      node_normals_(patch.node_count()),
      over_(patch.triangles().size(), 0) {
  find_normals(places_);
  cells_.reserve(normals_.size());
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    const mesh::Triangle& t = patch.triangles()[i];
    const ModelVector e = places_[t[1]] - places_[t[0]];
    const ModelVector f = places_[t[2]] - places_[t[0]];
    const double twice = geometry::length(normals_[i]);
    const double square = glm::dot(e, e);
    Cell cell;
    // Without a surface there is nothing to distort.
    if (twice > 1e-12 * (square + glm::dot(f, f))) {
      const double length = std::sqrt(square);
      cell.a = 1.0 / length;
      cell.b = -glm::dot(e, f) / (length * twice);
      cell.c = length / twice;
      cell.area = 0.5 * twice;
      const double upright = uprightness(i);
      // One that is turned over at rest already never counts.
      cell.limit = upright < 0.0 ? -4.0 : std::min(k_steep, 0.5 * upright);
    }
    area_ += cell.area;
    cells_.push_back(cell);
  }
  if (creases == Creases::counted) find_hinges();
}

void Strainmeter::find_hinges() {
  const auto edges = mesh::sorted_edges(patch_.triangles(), patch_.node_count());
  for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
    for (end = i + 1; end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high;) ++end;
    if (end - i != 2) continue;
    const Hinge hinge{edges[i].triangle, edges[i + 1].triangle};
    const bool moves =
        edges[i].low < patch_.inner_count() ||  // the lowest nodes are those of the region
        std::min({patch_.triangles()[hinge.first][0], patch_.triangles()[hinge.first][1],
                  patch_.triangles()[hinge.first][2], patch_.triangles()[hinge.second][0],
                  patch_.triangles()[hinge.second][1], patch_.triangles()[hinge.second][2]}) < patch_.inner_count();
    if (moves && glm::dot(normals_[hinge.first], normals_[hinge.second]) > 0.0) hinges_.push_back(hinge);
  }
}

bool Strainmeter::folded(const Hinge& hinge) const {
  const ModelVector& a = normals_[hinge.first];
  const ModelVector& b = normals_[hinge.second];
  const double dot = glm::dot(a, b);
  return dot < 0.0 && dot * dot > k_folded * k_folded * glm::dot(a, a) * glm::dot(b, b);
}

void Strainmeter::find_normals(std::span<const ModelPoint> places) {
  std::fill(node_normals_.begin(), node_normals_.end(), ModelVector{0});
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    const mesh::Triangle& t = patch_.triangles()[i];
    normals_[i] = glm::cross(places[t[1]] - places[t[0]], places[t[2]] - places[t[0]]);
    for (const std::uint32_t node : t) node_normals_[node] += normals_[i];
  }
  for (ModelVector& normal : node_normals_) {
    const double size = length_of(normal);
    normal = size > 1e-300 ? normal / size : ModelVector{0};
  }
}

double Strainmeter::uprightness(std::size_t triangle) const {
  const mesh::Triangle& t = patch_.triangles()[triangle];
  return facing(normals_[triangle], node_normals_[t[0]], node_normals_[t[1]], node_normals_[t[2]]);
}

Strain Strainmeter::measure(std::span<const ModelVector> moves) {
  Strain strain;
  const auto rests = patch_.rests();
  const auto triangles = patch_.triangles();
  for (std::size_t i = 0; i < rests.size(); ++i) places_[i] = rests[i] + moves[i];
  find_normals(places_);
  double worst = 1;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Cell& cell = cells_[i];
    over_[i] = 0;
    if (!(cell.area > 0.0)) continue;
    const mesh::Triangle& t = triangles[i];
    const ModelVector e = places_[t[1]] - places_[t[0]];
    const ModelVector f = places_[t[2]] - places_[t[0]];
    const ModelVector u = e * cell.a;
    const ModelVector v = e * cell.b + f * cell.c;
    const double uu = glm::dot(u, u);
    const double vv = glm::dot(v, v);
    const double uv = glm::dot(u, v);
    const double size = uu + vv;
    const bool over = facing(normals_[i], node_normals_[t[0]], node_normals_[t[1]], node_normals_[t[2]]) < cell.limit;
    over_[i] = over ? 1 : 0;
    strain.turned_over += over ? 1 : 0;
    const double squeeze = over ? k_flat * k_flat : std::max(uu * vv - uv * uv, k_flat * k_flat);
    strain.energy += cell.area * (size + size / squeeze - 4.0);
    // The largest stretch in any direction bounds that of the edges; only where it could be the largest they are asked.
    const double half = 0.5 * (uu - vv);
    if (0.5 * size + std::sqrt(half * half + uv * uv) <= worst) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const double ratio = squared_stretch(t[k], t[(k + 1) % 3]);
      if (ratio > worst) {
        worst = ratio;
        strain.node = t[k];
      }
    }
  }
  for (const Hinge& hinge : hinges_) strain.creased += folded(hinge) ? 1 : 0;
  strain.stretch = std::sqrt(worst);
  strain.energy = area_ > 0.0 ? strain.energy / area_ : 0.0;
  return strain;
}

double Strainmeter::squared_stretch(std::uint32_t a, std::uint32_t b) const {
  const ModelVector was = patch_.rests()[b] - patch_.rests()[a];
  const ModelVector is = places_[b] - places_[a];
  const double square = glm::dot(was, was);
  return square > 0.0 ? glm::dot(is, is) / square : 1.0;
}

void Strainmeter::mark_worst(double bound, std::span<std::uint8_t> nodes) const {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const mesh::Triangle& t = patch_.triangles()[i];
    bool bad = over_[i] != 0;
    for (std::size_t k = 0; k < 3 && !bad; ++k) bad = squared_stretch(t[k], t[(k + 1) % 3]) > bound * bound;
    if (!bad) continue;
    for (const std::uint32_t node : t) nodes[node] = 1;
  }
  for (const Hinge& hinge : hinges_) {
    if (!folded(hinge)) continue;
    for (const std::uint32_t node : patch_.triangles()[hinge.first]) nodes[node] = 1;
    for (const std::uint32_t node : patch_.triangles()[hinge.second]) nodes[node] = 1;
  }
}

}  // namespace penpose::articulation
