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
/// Where more than one node in so many moved all is measured: what is about every node is more than three times as
/// much.
constexpr std::size_t k_few = 6;

/// How much a triangle with this normal faces as the surface at its corners does.
inline double facing(const ModelVector& normal, const ModelVector& a, const ModelVector& b, const ModelVector& c) {
  const ModelVector around = a + b + c;
  const double size = geometry::length(normal);
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

Strainmeter::Strainmeter(const Patch& patch)
    : patch_(patch),
      places_(patch.rests().begin(), patch.rests().end()),
      normals_(patch.triangles().size()),
      node_normals_(patch.node_count()),
      over_(patch.triangles().size(), 0),
      shares_(patch.triangles().size()) {
  find_normals();
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
  find_hinges();
  folded_.assign(hinges_.size(), 0);
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

void Strainmeter::find_hinges_about() {
  hinge_begins_.assign(normals_.size() + 1, 0);
  for (const Hinge& hinge : hinges_) {
    ++hinge_begins_[hinge.first + 1];
    ++hinge_begins_[hinge.second + 1];
  }
  for (std::size_t i = 1; i < hinge_begins_.size(); ++i) hinge_begins_[i] += hinge_begins_[i - 1];
  hinges_about_.resize(hinge_begins_.back());
  std::vector<std::uint32_t> next(hinge_begins_.begin(), hinge_begins_.end() - 1);
  for (std::uint32_t i = 0; i < hinges_.size(); ++i) {
    hinges_about_[next[hinges_[i].first]++] = i;
    hinges_about_[next[hinges_[i].second]++] = i;
  }
  triangle_seen_.assign(normals_.size(), 0);
  node_seen_.assign(patch_.node_count(), 0);
  hinge_seen_.assign(hinges_.size(), 0);
}

void Strainmeter::find_normal(std::size_t triangle) {
  const mesh::Triangle& t = patch_.triangles()[triangle];
  normals_[triangle] = glm::cross(places_[t[1]] - places_[t[0]], places_[t[2]] - places_[t[0]]);
}

void Strainmeter::find_normals() {
  std::fill(node_normals_.begin(), node_normals_.end(), ModelVector{0});
  for (std::size_t i = 0; i < normals_.size(); ++i) {
    find_normal(i);
    for (const std::uint32_t node : patch_.triangles()[i]) node_normals_[node] += normals_[i];
  }
  for (ModelVector& normal : node_normals_) normal = geometry::normalized(normal, ModelVector{0});
}

double Strainmeter::uprightness(std::size_t triangle) const {
  const mesh::Triangle& t = patch_.triangles()[triangle];
  return facing(normals_[triangle], node_normals_[t[0]], node_normals_[t[1]], node_normals_[t[2]]);
}

Strain Strainmeter::measure(std::span<const ModelVector> moves) {
  const auto rests = patch_.rests();
  moved_.clear();
  for (std::uint32_t i = 0; i < rests.size(); ++i) {
    const ModelPoint place = rests[i] + moves[i];
    if (place == places_[i]) continue;
    places_[i] = place;
    moved_.push_back(i);
  }
  if (!measured_ || moved_.size() > rests.size() / k_few) {
    find_all();
    measured_ = true;
  } else if (!moved_.empty()) {
    find_about_moved();
  }
  return sum();
}

void Strainmeter::find_all() {
  find_normals();
  for (std::size_t i = 0; i < cells_.size(); ++i) find_share(i);
  for (std::size_t i = 0; i < hinges_.size(); ++i) folded_[i] = folded(hinges_[i]) ? 1 : 0;
}

void Strainmeter::find_about_moved() {
  if (hinge_begins_.empty()) find_hinges_about();
  // Each of them once.
  const auto note = [](std::uint32_t one, std::vector<std::uint8_t>& seen, std::vector<std::uint32_t>& all) {
    if (seen[one] != 0) return;
    seen[one] = 1;
    all.push_back(one);
  };
  const auto forget = [](std::vector<std::uint8_t>& seen, std::vector<std::uint32_t>& all) {
    for (const std::uint32_t one : all) seen[one] = 0;
    all.clear();
  };
  for (const std::uint32_t node : moved_) {
    for (const std::uint32_t t : patch_.star(node)) note(t, triangle_seen_, triangles_moved_);
  }
  for (const std::uint32_t t : triangles_moved_) {
    find_normal(t);
    for (const std::uint32_t node : patch_.triangles()[t]) note(node, node_seen_, nodes_about_);
    for (std::uint32_t at = hinge_begins_[t]; at < hinge_begins_[t + 1]; ++at) hinge_seen_[hinges_about_[at]] = 1;
  }
  for (const std::uint32_t t : triangles_moved_) {
    for (std::uint32_t at = hinge_begins_[t]; at < hinge_begins_[t + 1]; ++at) {
      const std::uint32_t hinge = hinges_about_[at];
      if (hinge_seen_[hinge] == 0) continue;
      hinge_seen_[hinge] = 0;
      folded_[hinge] = folded(hinges_[hinge]) ? 1 : 0;
    }
  }
  forget(triangle_seen_, triangles_moved_);
  for (const std::uint32_t node : nodes_about_) {
    // In the order of the triangles, as find_normals adds them up.
    ModelVector normal{0};
    for (const std::uint32_t t : patch_.star(node)) {
      normal += normals_[t];
      note(t, triangle_seen_, cells_about_);
    }
    node_normals_[node] = geometry::normalized(normal, ModelVector{0});
  }
  for (const std::uint32_t cell : cells_about_) find_share(cell);
  forget(triangle_seen_, cells_about_);
  forget(node_seen_, nodes_about_);
}

void Strainmeter::find_share(std::size_t i) {
  const Cell& cell = cells_[i];
  if (!(cell.area > 0.0)) return;
  const mesh::Triangle& t = patch_.triangles()[i];
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
  const double squeeze = over ? k_flat * k_flat : std::max(uu * vv - uv * uv, k_flat * k_flat);
  const double half = 0.5 * (uu - vv);
  // The largest stretch in any direction bounds that of the edges.
  shares_[i] = {cell.area * (size + size / squeeze - 4.0), 0.5 * size + std::sqrt(half * half + uv * uv)};
}

Strain Strainmeter::sum() const {
  Strain strain;
  double worst = 1;
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    strain.energy += shares_[i].energy;
    // Only where one of them could be the largest the edges are asked.
    if (shares_[i].bound <= worst) continue;
    const mesh::Triangle& t = patch_.triangles()[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const double ratio = squared_stretch(t[k], t[(k + 1) % 3]);
      if (ratio > worst) {
        worst = ratio;
        strain.node = t[k];
      }
    }
  }
  for (const std::uint8_t over : over_) strain.turned_over += over;
  for (const std::uint8_t folded : folded_) strain.creased += folded;
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

void Strainmeter::mark_torn(std::span<std::uint8_t> nodes) const {
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (over_[i] == 0) continue;
    for (const std::uint32_t node : patch_.triangles()[i]) nodes[node] = 1;
  }
  for (std::size_t i = 0; i < hinges_.size(); ++i) {
    if (folded_[i] == 0) continue;
    for (const std::uint32_t node : patch_.triangles()[hinges_[i].first]) nodes[node] = 1;
    for (const std::uint32_t node : patch_.triangles()[hinges_[i].second]) nodes[node] = 1;
  }
}

}  // namespace penpose::articulation
