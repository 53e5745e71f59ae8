#include "ui/render/face_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>

#include "core/algebra/elimination.h"
#include "core/base/text/letters.h"
#include "core/mesh/topology.h"

namespace penpose::render {
namespace {

using geometry::ModelPoint;
using geometry::ModelVector;

constexpr double k_sphere_rms = 0.06, k_smallest_eye = 0.01, k_largest_eye = 0.12, k_same_size = 0.1, k_cover_gap = 0.2;
constexpr double k_cover_share = 0.85, k_lash_gap = 0.5, k_largest_tooth = 0.1;
constexpr std::size_t k_fewest_teeth = 8;
constexpr double k_bulge = 1.025;

struct Component {
  std::vector<std::uint32_t> vertices;
  geometry::Box box;
  double area = 0;
  bool closed = true;
};

std::vector<Component> gather(const mesh::TriangleMesh& mesh, std::span<const ModelPoint> positions) {
  std::vector<Component> parts(mesh.component_count());
  const auto component = mesh.components();
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    parts[component[v]].vertices.push_back(v);
    parts[component[v]].box.add(positions[v]);
  }
  std::vector<mesh::Triangle> welded(mesh.triangles().begin(), mesh.triangles().end());
  for (mesh::Triangle& t : welded) {
    const ModelVector n = glm::cross(positions[t[1]] - positions[t[0]], positions[t[2]] - positions[t[0]]);
    parts[component[t[0]]].area += 0.5 * geometry::length(n);
    for (std::uint32_t& v : t) v = mesh.weld()[v];
  }
  const auto edges = mesh::sorted_edges(welded, positions.size());
  for (std::size_t i = 0; i < edges.size();) {
    const bool pair = i + 1 < edges.size() && edges[i + 1].low == edges[i].low && edges[i + 1].high == edges[i].high;
    if (!pair) parts[component[edges[i].low]].closed = false;
    i += pair ? 2 : 1;
  }
  return parts;
}

struct Sphere {
  ModelPoint center{0};
  double radius = 0;
  double rms = 0;  ///< of the deviation, as a share of the radius
};

/// Least squares of |p|^2 = 2 c.p + k (Coope 1993).
std::optional<Sphere> fit_sphere(const Component& part, std::span<const ModelPoint> positions) {
  if (part.vertices.size() < 12) return std::nullopt;
  const ModelPoint middle = part.box.center();
  const double scale = part.box.diagonal();
  if (!(scale > 0)) return std::nullopt;
  algebra::Equations<4> m{};
  for (const std::uint32_t v : part.vertices) {
    const ModelVector p = (positions[v] - middle) / scale;
    const std::array<double, 5> row{2 * p.x, 2 * p.y, 2 * p.z, 1, glm::dot(p, p)};
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 5; ++j) m[i][j] += row[i] * row[j];
    }
  }
  const auto solved = algebra::solve(m, 1e-9);
  if (!solved) return std::nullopt;
  const auto& x = *solved;
  const ModelVector c{x[0], x[1], x[2]};
  const double square = x[3] + glm::dot(c, c);
  if (!(square > 0)) return std::nullopt;
  Sphere sphere{middle + c * scale, std::sqrt(square) * scale, 0};
  double sum = 0;
  for (const std::uint32_t v : part.vertices) {
    const double off = geometry::distance(positions[v], sphere.center) / sphere.radius - 1;
    sum += off * off;
  }
  sphere.rms = std::sqrt(sum / static_cast<double>(part.vertices.size()));
  return sphere;
}

bool holds(const geometry::Box& box, const ModelPoint& p) {
  return glm::all(glm::lessThanEqual(box.minimum, p)) && glm::all(glm::lessThanEqual(p, box.maximum));
}

std::vector<Eye> find_eyes(std::span<const Component> parts, std::size_t body, std::span<const ModelPoint> positions) {
  const double size = parts[body].box.diagonal();
  std::vector<Eye> eyes;
  for (std::size_t c = 0; c < parts.size(); ++c) {
    if (c == body || !parts[c].closed || parts[c].box.diagonal() > 4 * k_largest_eye * size) continue;
    const auto sphere = fit_sphere(parts[c], positions);
    if (!sphere || sphere->rms > k_sphere_rms || sphere->radius < k_smallest_eye * size ||
        sphere->radius > k_largest_eye * size || !holds(parts[body].box, sphere->center)) {
      continue;
    }
    // Of two spheres around one middle the outer one is what is seen.
    const auto same = std::find_if(eyes.begin(), eyes.end(), [&](const Eye& eye) {
      return geometry::distance(eye.center, sphere->center) < 0.5 * std::max(eye.radius, sphere->radius);
    });
    const Eye found{static_cast<std::uint32_t>(c), sphere->center, sphere->radius, ModelVector{0}};
    if (same == eyes.end()) {
      eyes.push_back(found);
    } else if (found.radius > same->radius) {
      *same = found;
    }
  }
  const bool two = eyes.size() == 2 && std::abs(eyes[0].radius - eyes[1].radius) < k_same_size * eyes[0].radius &&
                   geometry::distance(eyes[0].center, eyes[1].center) > 1.5 * eyes[0].radius;
  if (!two) eyes.clear();
  for (Eye& eye : eyes) {
    ModelVector sum{0};
    for (const std::uint32_t v : parts[eye.component].vertices) {
      const ModelVector d = positions[v] - eye.center;
      if (geometry::length(d) > k_bulge * eye.radius) sum += d;
    }
    eye.gaze = geometry::normalized(sum, ModelVector{0});
  }
  return eyes;
}

PartKind kind_at_eye(const Component& part, const Eye& eye, std::span<const ModelPoint> positions) {
  if (part.box.diagonal() > 5 * eye.radius) return PartKind::surface;
  std::size_t near = 0;
  double nearest = 1e300;
  double farthest = 0;
  for (const std::uint32_t v : part.vertices) {
    const double away = geometry::distance(positions[v], eye.center) / eye.radius;
    near += std::abs(away - 1) < k_cover_gap ? 1 : 0;
    nearest = std::min(nearest, std::abs(away - 1));
    farthest = std::max(farthest, away);
  }
  if (part.closed) return farthest < 1 + k_cover_gap ? PartKind::eyeball : PartKind::surface;
  const auto share = static_cast<double>(near) / static_cast<double>(part.vertices.size());
  if (share > k_cover_share) return PartKind::eye_cover;
  return nearest < k_lash_gap ? PartKind::lash : PartKind::surface;
}

void find_teeth(std::span<const Component> parts, std::size_t body, std::span<PartKind> kinds) {
  std::vector<std::size_t> teeth;
  for (std::size_t c = 0; c < parts.size(); ++c) {
    if (c != body && kinds[c] == PartKind::surface && parts[c].closed && parts[c].vertices.size() >= 8 &&
        parts[c].box.diagonal() < k_largest_tooth * parts[body].box.diagonal() &&
        holds(parts[body].box, parts[c].box.center())) {
      teeth.push_back(c);
    }
  }
  if (teeth.size() < k_fewest_teeth) return;
  for (const std::size_t c : teeth) kinds[c] = PartKind::tooth;
  for (std::size_t c = 0; c < parts.size(); ++c) {
    if (c == body || kinds[c] != PartKind::surface) continue;
    const auto held = std::count_if(teeth.begin(), teeth.end(),
                                    [&](std::size_t tooth) { return holds(parts[c].box, parts[tooth].box.center()); });
    if (2 * static_cast<std::size_t>(held) >= teeth.size()) kinds[c] = PartKind::gum;
  }
}

}  // namespace

FaceParts recognise_face_parts(const mesh::TriangleMesh& mesh, std::span<const ModelPoint> positions) {
  FaceParts found;
  found.kind_of_component.assign(mesh.component_count(), PartKind::surface);
  if (mesh.component_count() < 3) return found;
  const auto parts = gather(mesh, positions);
  std::size_t body = 0;
  double area = 0;
  for (std::size_t c = 0; c < parts.size(); ++c) {
    area += parts[c].area;
    if (parts[c].area > parts[body].area) body = c;
  }
  if (parts[body].area < 0.5 * area) return found;
  found.eyes = find_eyes(parts, body, positions);
  if (found.eyes.empty()) return found;
  for (std::size_t c = 0; c < parts.size(); ++c) {
    if (c == body) continue;
    for (const Eye& eye : found.eyes) {
      if (found.kind_of_component[c] == PartKind::surface) {
        found.kind_of_component[c] = kind_at_eye(parts[c], eye, positions);
      }
    }
  }
  for (const Eye& eye : found.eyes) found.kind_of_component[eye.component] = PartKind::eyeball;
  find_teeth(parts, body, found.kind_of_component);
  return found;
}

std::vector<Eye> find_called_eyes(const mesh::TriangleMesh& mesh, std::span<const ModelPoint> positions,
                                  const std::vector<bool>& called) {
  constexpr double k_called_rms = 0.12;
  std::vector<Component> parts(mesh.component_count());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    if (!called[v]) continue;
    parts[mesh.components()[v]].vertices.push_back(v);
    parts[mesh.components()[v]].box.add(positions[v]);
  }
  std::vector<Eye> eyes;
  for (std::uint32_t c = 0; c < parts.size(); ++c) {
    if (parts[c].vertices.size() < 8) continue;
    // A ball, or a shell of one that is as wide.
    const auto sphere = fit_sphere(parts[c], positions);
    const ModelVector half = (parts[c].box.maximum - parts[c].box.minimum) * 0.5;
    Eye found{c, parts[c].box.center(), std::max(half.x, half.y), ModelVector{0}};
    if (sphere && sphere->rms < k_called_rms) found = {c, sphere->center, sphere->radius, ModelVector{0}};
    const auto same = std::find_if(eyes.begin(), eyes.end(), [&](const Eye& eye) {
      return geometry::distance(eye.center, found.center) < std::max(eye.radius, found.radius);
    });
    if (same == eyes.end()) {
      eyes.push_back(found);
    } else if (found.radius > same->radius) {
      *same = found;
    }
  }
  return eyes;
}

bool names_eyeball(std::string_view name) {
  const std::string low = base::lower_case(name);
  if (low.find("eye") == std::string::npos) return false;
  const auto is_beside = [&](std::string_view word) { return low.find(word) != std::string::npos; };
  constexpr std::array<std::string_view, 14> k_beside{"brow", "lash", "lid",  "glass",  "wear",      "shadow", "shell",
                                                      "line", "tear", "duct", "socket", "occlusion", "blink",  "fluid"};
  return std::none_of(k_beside.begin(), k_beside.end(), is_beside);
}

ModelVector forward_of(const Eye& one, const Eye& other, std::span<const ModelPoint> positions) {
  const ModelVector across = other.center - one.center;
  const ModelPoint middle = one.center + across * 0.5;
  const ModelVector ahead = geometry::normalized(glm::cross(across, ModelVector{0, 1, 0}), ModelVector{0});
  ModelVector head{0};
  for (const ModelPoint& p : positions) {
    if (geometry::distance(p, middle) < 3 * geometry::length(across)) head += middle - p;
  }
  return glm::dot(head, ahead) < 0 ? -ahead : ahead;
}

}  // namespace penpose::render
