#include <cmath>

#include "core/base/math.h"
#include "core/geometry/bvh.h"
#include "core/head/parts.h"

namespace penpose::head {
namespace {

constexpr std::size_t k_strands = 64;
constexpr std::size_t k_rings = 13;
/// The middle from which hair grows outwards, and far enough away to be outside.
const ModelPoint k_middle{0, 3.2, -0.9};
constexpr double k_outside = 40;

/// Height of the hair line, by the angle around the head (0 front, 180 back).
double hair_line(double degrees) {
  return profile({{0, 7.45},
                  {14, 7.6},
                  {26, 7.35},
                  {36, 6.6},
                  {44, 5.3},
                  {50, 4.0},
                  {56, 2.6},
                  {61, 1.0},
                  {65, -0.4},
                  {70, -0.9},
                  {75, -0.2},
                  {80, 1.5},
                  {86, 2.6},
                  {100, 2.6},
                  {110, 1.3},
                  {118, -1.2},
                  {128, -3.6},
                  {140, -4.7},
                  {180, -5.1}},
                 degrees);
}

/// Rays against the skin from outside.
class Scalp {
 public:
  explicit Scalp(const Surface& skin) : bvh_(floats(skin), skin.triangles) {}
  /// The outermost point of the skin on the way to `target`; the target itself where there is none.
  [[nodiscard]] ModelPoint towards(const ModelPoint& target, const ModelVector& outward) const {
    const auto hit = bvh_.nearest_hit({target + outward * k_outside, -outward});
    return hit ? target + outward * (k_outside - hit->distance) : target;
  }

 private:
  static std::vector<glm::vec3> floats(const Surface& skin) { return {skin.points.begin(), skin.points.end()}; }

  geometry::TriangleBvh bvh_;
};

/// Where hair stands over a point of the scalp; `inside`: way from the hair line, cm.
ModelPoint grown(const ModelPoint& p, double inside) {
  const ModelVector out = geometry::normalized(p - k_middle);
  double thick = profile({{0, -0.08}, {0.15, 0.16}, {0.5, 0.42}, {1.4, 0.7}, {4, 1.0}, {8, 1.1}}, inside);
  const double body = ramp(0, 2.0, inside);
  const double top = ramp(3.5, 8.5, p.y);
  // The parting on the +x side, and the front that is swept up from it.
  const double parting = p.x - 2.6 + 0.1 * p.z;
  thick -= 0.5 * body * bump(parting * parting * 2.2) * top * ramp(-4.5, -1, p.z);
  const double across = (p.x + 0.5) / 8.0;
  const double along = (p.z - 5.4) / 5.4;
  const double front = ramp(-0.1, 1.6, inside) * bump(across * across + along * along) * top;
  // Strands fan out from the parting.
  const double fan = base::atan2(p.x - 2.6 + 0.1 * p.z, p.y + 0.5);
  thick += body * (0.08 * base::sin(fan * 15 + 0.25 * p.z) + 0.045 * base::sin(fan * 31 - 0.4 * p.z));
  return p + out * thick + ModelVector{-0.35, 1.35, 0.9} * front;
}

}  // namespace

Surface make_hair(const Surface& skin) {
  const Scalp scalp(skin);
  Surface hair;
  for (std::size_t j = 0; j < k_strands; ++j) {
    const double turn = 360.0 * static_cast<double>(j) / k_strands;
    const double around = base::radians(turn);
    const ModelVector level{base::sin(around), 0, base::cos(around)};
    const ModelPoint line = scalp.towards({0, hair_line(turn > 180 ? 360 - turn : turn), k_middle.z}, level);
    const ModelVector start = line - k_middle;
    const double lowest = base::atan2(start.y, std::sqrt(start.x * start.x + start.z * start.z));
    for (std::size_t i = 0; i < k_rings; ++i) {
      const double t = static_cast<double>(i) / k_rings;
      const double rise = lowest + (base::k_pi / 2 - lowest) * t * (0.35 + 0.65 * t);
      const ModelPoint p = scalp.towards(k_middle, level * base::cos(rise) + ModelVector{0, base::sin(rise), 0});
      hair.points.push_back(grown(p, geometry::distance(p, line)));
    }
  }
  const auto crown = static_cast<std::uint32_t>(hair.points.size());
  const ModelPoint top = scalp.towards(k_middle, {0, 1, 0});
  hair.points.push_back(grown(top, 8));
  const auto at = [](std::size_t j, std::size_t i) { return static_cast<std::uint32_t>(j % k_strands * k_rings + i); };
  for (std::size_t j = 0; j < k_strands; ++j) {
    for (std::size_t i = 0; i + 1 < k_rings; ++i) {
      hair.triangles.push_back({at(j, i), at(j + 1, i), at(j + 1, i + 1)});
      hair.triangles.push_back({at(j, i), at(j + 1, i + 1), at(j, i + 1)});
    }
    hair.triangles.push_back({at(j, k_rings - 1), at(j + 1, k_rings - 1), crown});
  }
  return hair;
}

}  // namespace penpose::head
