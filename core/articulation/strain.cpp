#include "core/articulation/strain.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace penpose::articulation {
namespace {

/// A triangle pressed to this share of its area counts as pressed to nothing.
constexpr double k_flat = 0.02;

/// v turned by a rotation given as axis times angle, by the first terms of it in half angles (Cayley): exact enough to
/// tell on which side something lies.
ModelVector turned(const ModelVector& v, const ModelVector& turn) {
  const double square = glm::dot(turn, turn);
  if (!(square > 1e-12)) return v;
  // tan(x/2) by a short fraction; whole turns are few and only blunt the test.
  const double angle = std::sqrt(square);
  const double x = std::min(angle, 3.0) * 0.5;
  const double tangent = x * (15.0 - x * x) / (15.0 - 6.0 * x * x);
  const ModelVector t = turn * (tangent / angle);
  const ModelVector once = glm::cross(t, v);
  return v + (once + glm::cross(t, once)) * (2.0 / (1.0 + glm::dot(t, t)));
}

}  // namespace

Strain worse(const Strain& a, const Strain& b) {
  Strain both = a.stretch >= b.stretch ? a : b;
  both.energy = a.energy + b.energy;
  both.turned_over = std::max(a.turned_over, b.turned_over);
  return both;
}

Strainmeter::Strainmeter(const Patch& patch) : patch_(patch) {
  const auto rests = patch.rests();
  cells_.reserve(patch.triangles().size());
  for (const mesh::Triangle& t : patch.triangles()) {
    const ModelVector e = rests[t[1]] - rests[t[0]];
    const ModelVector f = rests[t[2]] - rests[t[0]];
    const ModelVector normal = glm::cross(e, f);
    const double twice = geometry::length(normal);
    const double length = geometry::length(e);
    Cell cell;
    // Without a surface there is nothing to distort.
    if (twice > 1e-12 * (length * length + glm::dot(f, f))) {
      cell.a = 1.0 / length;
      cell.b = -glm::dot(e, f) / (length * twice);
      cell.c = length / twice;
      cell.area = 0.5 * twice;
      cell.normal = normal;
    }
    area_ += cell.area;
    cells_.push_back(cell);
  }
}

Strain Strainmeter::measure(std::span<const ModelVector> moves, std::span<const ModelVector> turns) const {
  Strain strain;
  const auto rests = patch_.rests();
  const auto triangles = patch_.triangles();
  double worst = 1;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const Cell& cell = cells_[i];
    if (!(cell.area > 0.0)) continue;
    const mesh::Triangle& t = triangles[i];
    const ModelPoint p = rests[t[0]] + moves[t[0]];
    const ModelVector e = rests[t[1]] + moves[t[1]] - p;
    const ModelVector f = rests[t[2]] + moves[t[2]] - p;
    const ModelVector u = e * cell.a;
    const ModelVector v = e * cell.b + f * cell.c;
    const double uu = glm::dot(u, u);
    const double vv = glm::dot(v, v);
    const double uv = glm::dot(u, v);
    const double size = uu + vv;
    ModelVector expected = cell.normal;
    if (!turns.empty()) expected = turned(expected, (turns[t[0]] + turns[t[1]] + turns[t[2]]) * (1.0 / 3.0));
    const bool over = glm::dot(glm::cross(e, f), expected) < 0.0;
    strain.turned_over += over ? 1 : 0;
    const double squeeze = over ? k_flat * k_flat : std::max(uu * vv - uv * uv, k_flat * k_flat);
    strain.energy += cell.area * (size + size / squeeze - 4.0);
    // The largest stretch in any direction bounds that of the edges; only where it could be the largest they are asked.
    const double half = 0.5 * (uu - vv);
    if (0.5 * size + std::sqrt(half * half + uv * uv) <= worst) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[(k + 1) % 3];
      const ModelVector was = rests[b] - rests[a];
      const ModelVector is = was + moves[b] - moves[a];
      const double ratio = glm::dot(is, is) / glm::dot(was, was);
      if (ratio > worst) {
        worst = ratio;
        strain.node = a;
      }
    }
  }
  strain.stretch = std::sqrt(worst);
  strain.energy = area_ > 0.0 ? strain.energy / area_ : 0.0;
  return strain;
}

}  // namespace penpose::articulation
