#include "core/geometry/bvh.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/algebra/simd.h"

namespace penpose::geometry {
namespace {

using algebra::Double4;
using algebra::Float4;
using algebra::Int4;
using algebra::lower;
using algebra::splat;
using algebra::upper;
using algebra::widen;

constexpr float k_infinity = std::numeric_limits<float>::infinity();

Float4 load4(const std::array<float, 4>& lanes) {
  Float4 value;
  std::memcpy(&value, lanes.data(), sizeof value);
  return value;
}

}  // namespace

/// A ray made ready for its tests: sheared so that it runs along one axis from the origin.
struct TriangleBvh::Query {
  std::size_t kx, ky, kz;
  Double4 origin[3];
  Double4 shear_x, shear_y, shear_z;
  double nearest = std::numeric_limits<double>::infinity();
  std::uint32_t triangle = k_no_hint;
  double u = 0, v = 0, w = 0;

  explicit Query(const Ray& ray) {
    const ModelVector d = ray.direction;
    const ModelVector a{std::abs(d.x), std::abs(d.y), std::abs(d.z)};
    kz = a.x > a.y ? (a.x > a.z ? 0 : 2) : (a.y > a.z ? 1 : 2);
    kx = (kz + 1) % 3;
    ky = (kx + 1) % 3;
    const auto component = [](const ModelVector& vector, std::size_t axis) { return vector[static_cast<int>(axis)]; };
    if (component(d, kz) < 0.0) std::swap(kx, ky);
    for (std::size_t axis = 0; axis < 3; ++axis) origin[axis] = splat(component(ray.origin, axis));
    shear_x = splat(component(d, kx) / component(d, kz));
    shear_y = splat(component(d, ky) / component(d, kz));
    shear_z = splat(1.0 / component(d, kz));
  }
};

void TriangleBvh::test_block(const Block& block, Query& q) {
  Double4 x[3];
  Double4 y[3];
  Double4 z[3];
  for (std::size_t corner = 0; corner < 3; ++corner) {
    z[corner] = widen(load4(block.corner[corner][q.kz])) - q.origin[q.kz];
    x[corner] = (widen(load4(block.corner[corner][q.kx])) - q.origin[q.kx]) - q.shear_x * z[corner];
    y[corner] = (widen(load4(block.corner[corner][q.ky])) - q.origin[q.ky]) - q.shear_y * z[corner];
  }
  const Double4 u = x[2] * y[1] - y[2] * x[1];
  const Double4 v = x[0] * y[2] - y[0] * x[2];
  const Double4 w = x[1] * y[0] - y[1] * x[0];
  // The sign bits tell inside from outside: no corner function may differ in sign from another. Most blocks end here.
  const Double4 least = lower(lower(u, v), w);
  const Double4 most = upper(upper(u, v), w);
  std::array<double, 4> low;
  std::array<double, 4> high;
  std::memcpy(low.data(), &least, sizeof least);
  std::memcpy(high.data(), &most, sizeof most);
  const auto inside = [&](std::size_t lane) { return !(low[lane] < 0.0) || !(high[lane] > 0.0); };
  if (!inside(0) && !inside(1) && !inside(2) && !inside(3)) return;
  const Double4 det = u + v + w;
  const Double4 t = (u * z[0] + v * z[1] + w * z[2]) * q.shear_z;
  for (int lane = 0; lane < 4; ++lane) {
    if (!inside(static_cast<std::size_t>(lane)) || det[lane] == 0.0) continue;
    const double distance = t[lane] / det[lane];
    const std::uint32_t triangle = block.triangle[static_cast<std::size_t>(lane)];
    if (!(distance > 0.0) || distance > q.nearest || (distance == q.nearest && triangle >= q.triangle)) continue;
    q.nearest = distance;
    q.triangle = triangle;
    q.u = u[lane] / det[lane];
    q.v = v[lane] / det[lane];
    q.w = w[lane] / det[lane];
  }
}

void TriangleBvh::load_block(Block& block, std::span<const glm::vec3> positions) const {
  for (std::size_t lane = 0; lane < 4; ++lane) {
    const auto& t = triangles_[block.triangle[lane]];
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const glm::vec3& p = positions[t[corner]];
      block.corner[corner][0][lane] = p.x;
      block.corner[corner][1][lane] = p.y;
      block.corner[corner][2][lane] = p.z;
    }
  }
}

void TriangleBvh::refit(std::span<const glm::vec3> positions) {
  for (Block& block : blocks_) load_block(block, positions);
  const auto across = [](const std::array<std::array<float, 4>, 3>& lanes, std::size_t axis, auto pick) {
    const auto& l = lanes[axis];
    return pick(pick(l[0], l[1]), pick(l[2], l[3]));
  };
  const auto least = [](float a, float b) { return a < b ? a : b; };
  const auto most = [](float a, float b) { return a > b ? a : b; };
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    Node& node = nodes_[n];
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const std::uint32_t child = node.child[lane];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        float low = k_infinity;
        float high = -k_infinity;
        if (child != k_empty && (child & k_leaf) != 0) {
          const Block& block = blocks_[child & ~k_leaf];
          const Float4 a = load4(block.corner[0][axis]);
          const Float4 b = load4(block.corner[1][axis]);
          const Float4 c = load4(block.corner[2][axis]);
          const Float4 small = lower(lower(a, b), c);
          const Float4 large = upper(upper(a, b), c);
          low = least(least(small[0], small[1]), least(small[2], small[3]));
          high = most(most(large[0], large[1]), most(large[2], large[3]));
        } else if (child != k_empty) {
          low = across(nodes_[child].minimum, axis, least);
          high = across(nodes_[child].maximum, axis, most);
        }
        node.minimum[axis][lane] = low;
        node.maximum[axis][lane] = high;
      }
    }
  }
  extent_ = 0;
  for (std::size_t axis = 0; axis < 3 && !nodes_.empty(); ++axis) {
    extent_ = most(extent_, most(std::abs(across(nodes_[0].minimum, axis, least)),
                                 std::abs(across(nodes_[0].maximum, axis, most))));
  }
}

std::optional<RayHit> TriangleBvh::nearest_hit(const Ray& ray, std::uint32_t hint) const {
  if (nodes_.empty()) return std::nullopt;
  Query query(ray);
  const std::uint32_t tested = hint < slot_of_.size() ? slot_of_[hint] : k_empty;
  if (tested != k_empty) test_block(blocks_[tested], query);

  // Box tests run in float on boxes grown by more than the rounding of the subtraction and the product.
  const double reach =
      std::max({static_cast<double>(extent_), std::abs(ray.origin.x), std::abs(ray.origin.y), std::abs(ray.origin.z)});
  const float slack = static_cast<float>(reach * 4e-7);
  Float4 inverse[3];
  Float4 near_origin[3];
  Float4 far_origin[3];
  bool forward[3];
  for (int axis = 0; axis < 3; ++axis) {
    double d = ray.direction[axis];
    if (std::abs(d) < 1e-25) d = d < 0 ? -1e-25 : 1e-25;
    forward[axis] = d > 0;
    inverse[axis] = splat(static_cast<float>(1.0 / d));
    const float origin = static_cast<float>(ray.origin[axis]);
    near_origin[axis] = splat(forward[axis] ? origin + slack : origin - slack);
    far_origin[axis] = splat(forward[axis] ? origin - slack : origin + slack);
  }

  struct Entry {
    std::uint32_t child;
    float distance;
  };
  const bool sorted = query.triangle == k_no_hint;
  std::array<Entry, 256> stack;  // three more a level; k_deepest_costed_level + 31 halvings is the deepest tree
  std::size_t depth = 0;
  stack[depth++] = {0, 0.0F};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (static_cast<double>(entry.distance) > query.nearest) continue;
    if ((entry.child & k_leaf) != 0) {
      const std::uint32_t block = entry.child & ~k_leaf;
      if (block != tested) test_block(blocks_[block], query);
      continue;
    }
    const Node& node = nodes_[entry.child];
    Float4 enter = splat(0.0F);
    const double bound = query.nearest * 1.000001;
    Float4 leave = splat(bound < 3e38 ? static_cast<float>(bound) : k_infinity);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Float4 low = load4(forward[axis] ? node.minimum[axis] : node.maximum[axis]);
      const Float4 high = load4(forward[axis] ? node.maximum[axis] : node.minimum[axis]);
      enter = upper(enter, (low - near_origin[axis]) * inverse[axis]);
      leave = lower(leave, (high - far_origin[axis]) * inverse[axis]);
    }
    std::array<std::int32_t, 4> overlaps;
    std::array<float, 4> distance;
    const Int4 overlap = enter * 0.999999F <= leave * 1.000001F;
    const Float4 nearest = enter * 0.999999F;
    std::memcpy(overlaps.data(), &overlap, sizeof overlap);
    std::memcpy(distance.data(), &nearest, sizeof nearest);
    const std::size_t first = depth;
    for (std::size_t lane = 0; lane < 4; ++lane) {
      if (overlaps[lane] == 0) continue;  // an empty lane's box overlaps nothing
      // Far children first, so that the nearest is taken next. Once the hint was hit, little is left to find and any
      // order does.
      std::size_t place = depth++;
      while (sorted && place > first && stack[place - 1].distance < distance[lane]) {
        stack[place] = stack[place - 1];
        --place;
      }
      stack[place] = {node.child[lane], distance[lane]};
    }
  }
  if (query.triangle == k_no_hint) return std::nullopt;
  return RayHit{query.nearest, query.triangle, {query.u, query.v, query.w}};
}

std::size_t TriangleBvh::memory() const {
  return nodes_.size() * sizeof(Node) + blocks_.size() * sizeof(Block) + triangles_.size() * sizeof(triangles_[0]) +
         slot_of_.size() * 4;
}

}  // namespace penpose::geometry
