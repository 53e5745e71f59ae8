// One file above the usual size: building, refitting and asking share the layout of the nodes.

#include "core/geometry/bvh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>

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

struct FloatBox {
  Float4 minimum = splat(k_infinity);
  Float4 maximum = splat(-k_infinity);

  void add(Float4 p) {
    minimum = lower(minimum, p);
    maximum = upper(maximum, p);
  }
  void add(const FloatBox& box) {
    minimum = lower(minimum, box.minimum);
    maximum = upper(maximum, box.maximum);
  }
  /// Half the surface, the measure of how often a random ray hits.
  [[nodiscard]] float area() const {
    const Float4 d = maximum - minimum;
    return d[0] * d[1] + d[1] * d[2] + d[2] * d[0];
  }
};

Float4 load(const glm::vec3& p) { return Float4{p.x, p.y, p.z, 0.0F}; }
Float4 load4(const std::array<float, 4>& lanes) {
  Float4 value;
  std::memcpy(&value, lanes.data(), sizeof value);
  return value;
}

}  // namespace

/// Builds a binary tree by the surface area heuristic over binned centroids (Wald 2007), then folds it to four children
/// a node.
struct TriangleBvh::Builder {
  struct Binary {
    FloatBox box;
    std::uint32_t left = 0;  ///< 0: a leaf
    std::uint32_t right = 0;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    std::uint32_t level = 0;
  };
  static constexpr std::size_t k_bins = 16;
  // Below this level runs are halved whatever it costs, so that hostile geometry cannot make the tree a list.
  static constexpr std::uint32_t k_deepest_costed_level = 40;

  TriangleBvh& bvh;
  Build build;
  std::vector<FloatBox> boxes;
  std::vector<Float4> centroids;
  std::vector<std::uint32_t> order;
  std::vector<std::uint32_t> aside;  ///< scratch of `parted`
  std::vector<Binary> tree;

  Builder(TriangleBvh& target, std::span<const glm::vec3> positions, Build how) : bvh(target), build(how) {
    const std::size_t count = bvh.triangles_.size();
    boxes.resize(count);
    centroids.resize(count);
    order.resize(count);
    aside.resize(count);
    std::iota(order.begin(), order.end(), 0U);
    for (std::size_t t = 0; t < count; ++t) {
      for (const std::uint32_t v : bvh.triangles_[t]) boxes[t].add(load(positions[v]));
      centroids[t] = (boxes[t].minimum + boxes[t].maximum) * 0.5F;
    }
    tree.reserve(count);
    tree.push_back(make_binary(0, static_cast<std::uint32_t>(count), 0));
    std::vector<std::uint32_t> open{0};
    while (!open.empty()) {
      const std::uint32_t index = open.back();
      open.pop_back();
      const std::uint32_t middle = split(tree[index]);
      if (middle == 0) continue;
      const std::uint32_t left = static_cast<std::uint32_t>(tree.size());
      const Binary parent = tree[index];
      tree.push_back(make_binary(parent.begin, middle, parent.level + 1));
      tree.push_back(make_binary(middle, parent.end, parent.level + 1));
      tree[index].left = left;
      tree[index].right = left + 1;
      open.push_back(left + 1);
      open.push_back(left);
    }
    fold(0);
  }

  [[nodiscard]] Binary make_binary(std::uint32_t begin, std::uint32_t end, std::uint32_t level) const {
    Binary node;
    node.level = level;
    node.begin = begin;
    node.end = end;
    for (std::uint32_t i = begin; i < end; ++i) node.box.add(boxes[order[i]]);
    return node;
  }

  /// Where to cut the run, or 0 when it is a leaf. Reorders the run.
  std::uint32_t split(const Binary& node) {
    const std::uint32_t count = node.end - node.begin;
    if (count <= 4) return 0;
    FloatBox spread;
    for (std::uint32_t i = node.begin; i < node.end; ++i) spread.add(centroids[order[i]]);
    const Float4 size = spread.maximum - spread.minimum;
    if (build == Build::quick) return split_quickly(node, spread);
    std::size_t best_axis = 3;
    std::size_t best_bin = 0;
    float best_cost = k_infinity;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!(size[axis] > 0.0F) || node.level > k_deepest_costed_level) continue;
      std::array<FloatBox, k_bins> bin_box;
      std::array<std::uint32_t, k_bins> bin_count{};
      const float scale = static_cast<float>(k_bins) / size[axis];
      for (std::uint32_t i = node.begin; i < node.end; ++i) {
        const std::size_t bin = bin_of(centroids[order[i]][axis], spread.minimum[axis], scale);
        bin_box[bin].add(boxes[order[i]]);
        ++bin_count[bin];
      }
      std::array<float, k_bins> right_cost{};
      FloatBox sweep;
      std::uint32_t seen = 0;
      for (std::size_t bin = k_bins; bin-- > 1;) {
        sweep.add(bin_box[bin]);
        seen += bin_count[bin];
        right_cost[bin] = seen == 0 ? k_infinity : sweep.area() * static_cast<float>(seen);
      }
      sweep = {};
      seen = 0;
      for (std::size_t bin = 0; bin + 1 < k_bins; ++bin) {
        sweep.add(bin_box[bin]);
        seen += bin_count[bin];
        if (seen == 0) continue;
        const float cost = sweep.area() * static_cast<float>(seen) + right_cost[bin + 1];
        if (cost < best_cost) {
          best_cost = cost;
          best_axis = axis;
          best_bin = bin;
        }
      }
    }
    if (best_axis < 3) {
      const float scale = static_cast<float>(k_bins) / size[best_axis];
      const std::uint32_t middle = parted(node, [&](std::uint32_t t) {
        return bin_of(centroids[t][best_axis], spread.minimum[best_axis], scale) <= best_bin;
      });
      if (middle != node.begin && middle != node.end) return middle;
    }
    return node.begin + count / 2;  // all centroids in one place: any halves do
  }

  /// Half-way along the longest side of the centroids' box.
  std::uint32_t split_quickly(const Binary& node, const FloatBox& spread) {
    const std::uint32_t half = node.begin + (node.end - node.begin) / 2;
    const Float4 size = spread.maximum - spread.minimum;
    const std::size_t axis = size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : (size[1] > size[2] ? 1 : 2);
    if (!(size[axis] > 0.0F) || node.level > k_deepest_costed_level) return half;
    const float at = (spread.minimum[axis] + spread.maximum[axis]) * 0.5F;
    const std::uint32_t middle = parted(node, [&](std::uint32_t t) { return centroids[t][axis] <= at; });
    return middle != node.begin && middle != node.end ? middle : half;
  }

  /// Brings those of the run to its front that are wanted there; either part keeps its order. Returns where the other
  /// part begins.
  template <typename Wanted>
  std::uint32_t parted(const Binary& node, const Wanted& wanted) {
    std::uint32_t front = node.begin;
    std::size_t behind = 0;
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const std::uint32_t t = order[i];
      if (wanted(t)) {
        order[front++] = t;
      } else {
        aside[behind++] = t;
      }
    }
    std::copy_n(aside.begin(), behind, order.begin() + front);
    return front;
  }

  static std::size_t bin_of(float value, float minimum, float scale) {
    return std::min(k_bins - 1, static_cast<std::size_t>(std::max(0.0F, (value - minimum) * scale)));
  }

  /// Makes a node of the subtree: opens the child with the largest surface until there are four. Returns its number.
  std::uint32_t fold(std::uint32_t root) {
    std::array<std::uint32_t, 4> children{root};
    std::size_t count = 1;
    if (tree[root].left != 0) {
      children = {tree[root].left, tree[root].right};
      count = 2;
    }
    while (count < 4) {
      std::size_t widest = count;
      for (std::size_t i = 0; i < count; ++i) {
        const Binary& child = tree[children[i]];
        if (child.left != 0 && (widest == count || child.box.area() > tree[children[widest]].box.area())) widest = i;
      }
      if (widest == count) break;
      const std::uint32_t opened = children[widest];
      children[widest] = tree[opened].left;
      for (std::size_t i = count++; i > widest + 1; --i) children[i] = children[i - 1];
      children[widest + 1] = tree[opened].right;
    }
    const auto number = static_cast<std::uint32_t>(bvh.nodes_.size());
    bvh.nodes_.emplace_back();
    std::array<std::uint32_t, 4> child{};
    child.fill(k_empty);
    for (std::size_t i = 0; i < count; ++i) {
      const Binary& binary = tree[children[i]];
      child[i] = binary.left == 0 ? k_leaf | make_block(binary) : fold(children[i]);
    }
    bvh.nodes_[number].child = child;
    return number;
  }

  std::uint32_t make_block(const Binary& leaf) {
    const auto number = static_cast<std::uint32_t>(bvh.blocks_.size());
    Block block;
    for (std::uint32_t lane = 0; lane < 4; ++lane) {
      block.triangle[lane] = order[leaf.begin + (leaf.begin + lane < leaf.end ? lane : 0)];
      bvh.slot_of_[block.triangle[lane]] = number;
    }
    bvh.blocks_.push_back(block);
    return number;
  }
};

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

TriangleBvh::TriangleBvh(std::span<const glm::vec3> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
                         Build build)
    : triangles_(triangles.begin(), triangles.end()), slot_of_(triangles.size(), 0) {
  if (triangles_.empty()) return;
  nodes_.reserve(triangles_.size() / 6 + 1);
  blocks_.reserve(triangles_.size() / 2 + 1);
  Builder builder(*this, positions, build);
  refit(positions);
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
