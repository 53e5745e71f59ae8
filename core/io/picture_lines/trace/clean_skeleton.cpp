#include <algorithm>
#include <cmath>
#include <utility>

#include "core/io/picture_lines/trace/internal/skeleton.h"

namespace penpose::io {
namespace {

constexpr double k_shared = 1.1;            ///< of the ink that two lines share where they cross, in that of strips
constexpr double k_least_half_sine = 0.05;  ///< lines at a smaller angle are side by side

/// One of the two ends of an edge.
struct EdgeEnd {
  std::size_t edge = 0;
  std::size_t side = 0;
};

class SkeletonCleaner {
 public:
  explicit SkeletonCleaner(Skeleton& skeleton)
      : skeleton_(skeleton), ends_(skeleton.nodes.size()), gone_(skeleton.edges.size()) {
    for (std::size_t i = 0; i < skeleton_.edges.size(); ++i) {
      if (skeleton_.edges[i].is_loop()) continue;
      for (std::size_t side = 0; side < 2; ++side) ends_[skeleton_.edges[i].nodes[side]].push_back({i, side});
    }
  }

  void clean() {
    while (cut_spurs()) {
    }
    contract_bridges();
    cut_small_loops();
    for (std::size_t node = 0; node < ends_.size(); ++node) {
      if (ends_[node].size() == 2) join_at(node);
    }
    forget_what_is_gone();
  }

 private:
  [[nodiscard]] SkeletonEdge& edge(std::size_t i) { return skeleton_.edges[i]; }
  [[nodiscard]] double width_at(std::size_t node) const { return 2 * skeleton_.nodes[node].radius; }

  /// The side of an edge at which it is a spur: short, free at its other end.
  [[nodiscard]] bool is_spur(std::size_t i, std::size_t side) {
    if (gone_[i] || edge(i).is_loop()) return false;
    const std::size_t node = edge(i).nodes[side];
    return ends_[node].size() >= 3 && ends_[edge(i).nodes[1 - side]].size() == 1 && edge(i).length() < width_at(node);
  }

  /// The shortest first, since what meets at a node may be one line when they are gone.
  bool cut_spurs() {
    std::vector<std::pair<double, EdgeEnd>> spurs;
    for (std::size_t i = 0; i < skeleton_.edges.size(); ++i) {
      for (std::size_t side = 0; side < 2; ++side) {
        if (is_spur(i, side)) spurs.push_back({edge(i).length(), {i, side}});
      }
    }
    std::stable_sort(spurs.begin(), spurs.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [length, spur] : spurs) {
      if (!is_spur(spur.edge, spur.side)) continue;
      const std::size_t node = edge(spur.edge).nodes[spur.side];
      remove(spur.edge);
      if (ends_[node].size() == 2) join_at(node);
    }
    return !spurs.empty();
  }

  void contract_bridges() {
    for (const bool by_angle : {false, true}) {
      std::vector<std::pair<double, std::size_t>> bridges;
      for (std::size_t i = 0; i < skeleton_.edges.size(); ++i) {
        if (is_bridge(i, by_angle)) bridges.push_back({edge(i).length(), i});
      }
      std::stable_sort(bridges.begin(), bridges.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      for (const auto& [length, i] : bridges) {
        if (is_bridge(i, by_angle)) contract(i, length);
      }
    }
  }

  bool is_bridge(std::size_t i, bool by_angle) {
    if (gone_[i] || edge(i).is_loop()) return false;
    const auto [first, second] = edge(i).nodes;
    if (first == second || ends_[first].size() < 3 || ends_[second].size() < 3) return false;
    const double width = std::max(width_at(first), width_at(second));
    const double length = edge(i).length();
    if (!by_angle) return length <= width + 1;
    if (ends_[first].size() != 3 || ends_[second].size() != 3) return false;
    return length <= 1.5 + k_shared * width / std::max(half_sine(first, i), k_least_half_sine) &&
           length <= 1.5 + k_shared * width / std::max(half_sine(second, i), k_least_half_sine);
  }

  /// The sine of half of the angle between the two lines that meet a bridge at a node.
  double half_sine(std::size_t node, std::size_t bridge) {
    geometry::PxPoint between;
    bool first = true;
    for (const EdgeEnd& end : ends_[node]) {
      if (end.edge == bridge) continue;
      const auto direction = leaving_direction(skeleton_, edge(end.edge), end.side);
      between = first ? direction : between - direction;
      first = false;
    }
    return std::sqrt(geometry::dot(between, between)) / 2;
  }

  /// Makes one node of the two at the ends of an edge.
  void contract(std::size_t i, double length) {
    const auto [kept, other] = edge(i).nodes;
    remove(i);
    SkeletonNode& node = skeleton_.nodes[kept];
    const SkeletonNode& gone = skeleton_.nodes[other];
    node.place = (node.place + gone.place) * 0.5;
    node.radius = std::max(node.radius, gone.radius);
    node.reach = std::max(node.reach, gone.reach) + length / 2;
    for (const EdgeEnd& end : ends_[other]) {
      edge(end.edge).nodes[end.side] = kept;
      ends_[kept].push_back(end);
    }
    ends_[other].clear();
  }

  void cut_small_loops() {
    for (std::size_t i = 0; i < skeleton_.edges.size(); ++i) {
      if (gone_[i] || edge(i).is_loop() || edge(i).nodes[0] != edge(i).nodes[1]) continue;
      if (edge(i).length() < 2 * width_at(edge(i).nodes[0])) remove(i);
    }
  }

  void remove(std::size_t i) {
    for (const std::size_t node : edge(i).nodes) {
      std::erase_if(ends_[node], [&](const EdgeEnd& end) { return end.edge == i; });
    }
    gone_[i] = true;
  }

  /// Makes one edge of the two that meet at a node, or a loop of the one that begins and ends there.
  void join_at(std::size_t node) {
    const EdgeEnd first = ends_[node][0];
    const EdgeEnd second = ends_[node][1];
    ends_[node].clear();
    SkeletonEdge& kept = edge(first.edge);
    if (first.edge == second.edge) {
      kept.nodes = {SkeletonEdge::k_none, SkeletonEdge::k_none};
      kept.points.back() = kept.points.front();
      return;
    }
    SkeletonEdge& other = edge(second.edge);
    const double own_length = kept.length();
    const double other_length = other.length();
    kept.radius = (kept.radius * own_length + other.radius * other_length) / std::max(own_length + other_length, 1e-9);
    if (first.side == 0) std::reverse(kept.points.begin(), kept.points.end());
    if (second.side == 1) std::reverse(other.points.begin(), other.points.end());
    const std::size_t begin = kept.nodes[1 - first.side];
    const std::size_t end = other.nodes[1 - second.side];
    kept.points.insert(kept.points.end(), other.points.begin() + 1, other.points.end());
    kept.nodes = {begin, end};
    for (EdgeEnd& one : ends_[begin]) {
      if (one.edge == first.edge) one.side = 0;
    }
    for (EdgeEnd& one : ends_[end]) {
      if (one.edge == second.edge) one = {first.edge, 1};
    }
    other.points.clear();
    gone_[second.edge] = true;
  }

  void forget_what_is_gone() {
    std::size_t count = 0;
    for (std::size_t i = 0; i < gone_.size(); ++i) {
      if (gone_[i]) continue;
      if (count != i) skeleton_.edges[count] = std::move(skeleton_.edges[i]);
      ++count;
    }
    skeleton_.edges.resize(count);
    for (std::size_t node = 0; node < ends_.size(); ++node) skeleton_.nodes[node].degree = ends_[node].size();
  }

  Skeleton& skeleton_;
  std::vector<std::vector<EdgeEnd>> ends_;
  std::vector<bool> gone_;
};

}  // namespace

void clean_up(Skeleton& skeleton) { SkeletonCleaner(skeleton).clean(); }

}  // namespace penpose::io
