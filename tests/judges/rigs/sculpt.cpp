#include "tests/judges/rigs/sculpt.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace penpose::judges {

std::vector<double> around(std::span<const ModelPoint> places, const ModelPoint& center, const ModelVector& radii) {
  std::vector<double> share;
  share.reserve(places.size());
  for (const ModelPoint& p : places) {
    const ModelVector d = (p - center) / radii;
    const double square = d.x * d.x + d.y * d.y + d.z * d.z;
    share.push_back(square < 6 ? base::exp(-square) : 0.0);
  }
  return share;
}

double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Field pushed(std::span<const double> share, const ModelVector& way) {
  Field field;
  field.reserve(share.size());
  for (const double s : share) field.push_back(way * s);
  return field;
}

Field turned(std::span<const ModelPoint> places, std::span<const double> share, const ModelPoint& center,
             const ModelVector& axis, double degrees) {
  const double c = base::cos(base::radians(degrees));
  const double s = base::sin(base::radians(degrees));
  const ModelVector k = geometry::normalized(axis);
  Field field;
  field.reserve(places.size());
  for (std::size_t v = 0; v < places.size(); ++v) {
    const ModelVector p = places[v] - center;
    const ModelVector across{k.y * p.z - k.z * p.y, k.z * p.x - k.x * p.z, k.x * p.y - k.y * p.x};
    const double along = k.x * p.x + k.y * p.y + k.z * p.z;
    field.push_back((p * (c - 1) + across * s + k * (along * (1 - c))) * share[v]);
  }
  return field;
}

Field times(const Field& field, std::span<const double> share) {
  Field out = field;
  for (std::size_t v = 0; v < out.size(); ++v) out[v] *= share[v];
  return out;
}

std::vector<double> product(std::span<const double> a, std::span<const double> b) {
  std::vector<double> out(a.begin(), a.end());
  for (std::size_t v = 0; v < out.size(); ++v) out[v] *= b[v];
  return out;
}

void add_to(Field& field, double amount, const Field& other) {
  for (std::size_t v = 0; v < field.size(); ++v) field[v] += other[v] * amount;
}

std::vector<double> side_share(std::span<const ModelPoint> places, bool left, double width) {
  std::vector<double> share;
  share.reserve(places.size());
  for (const ModelPoint& p : places) share.push_back(smooth_step(-width, width, left ? p.x : -p.x));
  return share;
}

}  // namespace penpose::judges
