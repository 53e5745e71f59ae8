#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include "core/algebra/simd.h"
#include "core/geometry/bvh.h"

namespace penpose::geometry {
namespace {

using algebra::Float4;
using algebra::lower;
using algebra::splat;
using algebra::upper;

constexpr float k_unbounded = std::numeric_limits<float>::infinity();

struct FloatBox {
  Float4 minimum = splat(k_unbounded);
  Float4 maximum = splat(-k_unbounded);

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
    float best_cost = k_unbounded;
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
        right_cost[bin] = seen == 0 ? k_unbounded : sweep.area() * static_cast<float>(seen);
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

TriangleBvh::TriangleBvh(std::span<const glm::vec3> positions, std::span<const std::array<std::uint32_t, 3>> triangles,
                         Build build)
    : triangles_(triangles.begin(), triangles.end()), slot_of_(triangles.size(), 0) {
  if (triangles_.empty()) return;
  nodes_.reserve(triangles_.size() / 6 + 1);
  blocks_.reserve(triangles_.size() / 2 + 1);
  Builder builder(*this, positions, build);
  refit(positions);
}

}  // namespace penpose::geometry
