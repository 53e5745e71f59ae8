#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace penpose::geometry {

/// A point of the viewport in px: origin top left, x to the right, y down. No other 2D space uses this type.
struct PxPoint {
  double x = 0;
  double y = 0;
  friend bool operator==(const PxPoint&, const PxPoint&) = default;
};

inline PxPoint operator+(PxPoint a, PxPoint b) { return {a.x + b.x, a.y + b.y}; }
inline PxPoint operator-(PxPoint a, PxPoint b) { return {a.x - b.x, a.y - b.y}; }
inline PxPoint operator*(PxPoint a, double s) { return {a.x * s, a.y * s}; }
[[nodiscard]] inline double dot(PxPoint a, PxPoint b) { return a.x * b.x + a.y * b.y; }

/// A point or a vector of model space: right-handed, y up, the model's own unit of length (glTF says metres).
using ModelPoint = glm::dvec3;
using ModelVector = glm::dvec3;

/// Where on the way from a to b the place nearest to p lies, 0..1; 0 where they are one place.
[[nodiscard]] inline double nearest_share(PxPoint p, PxPoint a, PxPoint b) {
  const PxPoint along = b - a;
  const PxPoint from = p - a;
  const double square = dot(along, along);
  return square > 0.0 ? std::clamp(dot(from, along) / square, 0.0, 1.0) : 0.0;
}

/// Distances with an exact square root, so that they are the same on every machine.
[[nodiscard]] inline double distance(PxPoint a, PxPoint b) {
  const PxPoint d = a - b;
  return std::sqrt(d.x * d.x + d.y * d.y);
}
[[nodiscard]] inline double length(const ModelVector& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }
[[nodiscard]] inline double distance(const ModelPoint& a, const ModelPoint& b) { return length(a - b); }
/// v / |v|, or `fallback` for a vector too short to have a direction.
[[nodiscard]] inline ModelVector normalized(const ModelVector& v, const ModelVector& fallback = {0, 0, 1}) {
  const double size = length(v);
  return size > 1e-300 ? v / size : fallback;
}

/// A half line: origin + t direction, t >= 0. The direction has length one unless its maker says otherwise.
struct Ray {
  ModelPoint origin;
  ModelVector direction;
};

/// An axis-aligned box. Empty (minimum above maximum) until something is added.
struct Box {
  ModelPoint minimum{1e300};
  ModelPoint maximum{-1e300};

  void add(const ModelPoint& p);
  [[nodiscard]] bool empty() const { return minimum.x > maximum.x; }
  [[nodiscard]] ModelPoint center() const { return (minimum + maximum) * 0.5; }
  /// Length of the diagonal; 0 for an empty box.
  [[nodiscard]] double diagonal() const;
};

}  // namespace penpose::geometry
