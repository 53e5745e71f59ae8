#include "core/articulation/region/kept_surface.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace penpose::articulation {
namespace {

double lift_onto_ball(const Sphere& ball, const geometry::Ray& ray, double near, double level) {
  const ModelVector from = ray.origin - ball.center;
  const double b = glm::dot(from, ray.direction);
  const double square = b * b - (glm::dot(from, from) - level * level);
  const double half = square > 0.0 ? std::sqrt(square) : 0.0;
  const double first = -b - half;
  const double second = -b + half;
  const double lifted = std::abs(first - near) <= std::abs(second - near) ? first : second;
  return lifted > 0.0 ? lifted : near;
}

/// Newton's method on the signed distance along the ray.
double lift_onto_level(const geometry::ClosestPointTree& tree, double size, const geometry::Ray& ray, double near,
                       double level) {
  constexpr int k_steps = 40;
  double t = near;
  for (int i = 0; i < k_steps; ++i) {
    const ModelPoint p = ray.origin + ray.direction * t;
    const geometry::ClosestPoint at = tree.closest(p);
    const double side = glm::dot(p - at.point, at.normal) < 0.0 ? -1.0 : 1.0;
    const double error = side * at.distance - level;
    if (std::abs(error) <= 1e-12 * size) return t > 0.0 ? t : near;
    const ModelVector away = geometry::normalized((p - at.point) * side, at.normal);
    const double slope = glm::dot(away, ray.direction);
    if (std::abs(slope) < 0.05) return near;  // along the surface: no clear crossing
    t -= error / slope;
    if (!(std::abs(t - near) <= size)) return near;
  }
  return near;
}

}  // namespace

base::Result<KeptSurface> KeptSurface::make(const Surface& surface, const Canvas& canvas) {
  KeptSurface kept;
  if (const auto* ball = std::get_if<Sphere>(&surface)) kept.surface_ = *ball;
  const auto* wanted = std::get_if<PartSurface>(&surface);
  if (wanted == nullptr) return kept;
  const auto weld = canvas.mesh().weld();
  std::vector<mesh::Triangle> triangles;
  geometry::Box box;
  std::vector<std::array<std::uint32_t, 2>> vertices;
  for (const mesh::Part& part : canvas.mesh().parts()) {
    if (part.name != wanted->part) continue;
    vertices.push_back({part.first_vertex, part.first_vertex + part.vertex_count});
    for (const mesh::Triangle& t : canvas.mesh().triangles().subspan(part.first_triangle, part.triangle_count)) {
      triangles.push_back({weld[t[0]], weld[t[1]], weld[t[2]]});
      for (const std::uint32_t v : t) box.add(canvas.positions()[v]);
    }
  }
  if (vertices.empty()) {
    std::string names;
    for (const mesh::Part& part : canvas.mesh().parts()) names += (names.empty() ? "" : ", ") + part.name;
    return base::Error{"the model has no part '" + wanted->part + "'", "surface/mesh", "its parts are: " + names};
  }
  if (triangles.empty()) {
    return base::Error{"the part '" + wanted->part + "' has no triangles", "surface/mesh", "name another part"};
  }
  kept.surface_ = std::make_shared<const Part>(
      Part{geometry::ClosestPointTree(canvas.positions(), triangles), box.diagonal(), std::move(vertices)});
  return kept;
}

bool KeptSurface::consists_of(std::uint32_t vertex, const ModelPoint& rest) const {
  if (const auto* ball = std::get_if<Sphere>(&surface_)) {
    return geometry::distance(rest, ball->center) <= ball->radius * 1.001;
  }
  if (const auto* part = std::get_if<std::shared_ptr<const Part>>(&surface_)) {
    for (const auto& [first, end] : (*part)->vertices) {
      if (vertex >= first && vertex < end) return true;
    }
  }
  return false;
}

double KeptSurface::level(const ModelPoint& rest) const {
  if (const auto* ball = std::get_if<Sphere>(&surface_)) return geometry::distance(rest, ball->center);
  if (const auto* part = std::get_if<std::shared_ptr<const Part>>(&surface_))
    return (*part)->tree.signed_distance(rest);
  return 0.0;
}

ModelPoint KeptSurface::keep(const ModelPoint& moved, const ModelPoint& rest, double level) const {
  if (const auto* ball = std::get_if<Sphere>(&surface_)) {
    ModelVector ray = moved - ball->center;
    double size = geometry::length(ray);
    if (!(size > 1e-12 * level)) {
      ray = rest - ball->center;
      size = level;
    }
    return size > 0.0 ? ball->center + ray * (level / size) : rest;
  }
  if (const auto* part = std::get_if<std::shared_ptr<const Part>>(&surface_)) {
    const geometry::ClosestPoint at = (*part)->tree.closest(moved);
    const ModelVector off = moved - at.point;
    // Nearer than this the difference is rounding and has no direction.
    if (at.distance <= 1e-9 * (*part)->size) return at.point + at.normal * level;
    const double side = glm::dot(off, at.normal) < 0.0 ? -1.0 : 1.0;
    return at.point + off * (side * level / at.distance);
  }
  return moved;
}

double KeptSurface::lift(const geometry::Ray& ray, double near, double level) const {
  if (const auto* ball = std::get_if<Sphere>(&surface_)) return lift_onto_ball(*ball, ray, near, level);
  if (const auto* part = std::get_if<std::shared_ptr<const Part>>(&surface_)) {
    return lift_onto_level((*part)->tree, (*part)->size, ray, near, level);
  }
  return near;
}

}  // namespace penpose::articulation
