#include "core/articulation/measure/relaxation.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>

namespace penpose::articulation {
namespace {

/// The edges are brought a little below the bound, so that sweeps end.
constexpr double k_below = 0.995;
/// ... and farther than that at a time, which sweeps need less of.
constexpr double k_over = 1.3;
/// Steps by which a rotation is found from the one before.
constexpr int k_first_steps = 24, k_relaxation_steps = 3;
/// How much more the edges within a fold say than those around it.
constexpr double k_stiff = 25;

glm::dquat unit(const glm::dquat& q) {
  const double length = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return length > 0.0 ? q * (1.0 / length) : glm::dquat{1, 0, 0, 0};
}

/// The rotation that `to` (columns: what became of the axes, weighted) comes nearest to, from a first guess (Mueller,
/// Bender, Chentanez and Macklin 2016). It never is a mirror image, whatever was turned over.
void follow(const glm::dmat3& to, int steps, glm::dquat& q) {
  for (int step = 0; step < steps; ++step) {
    const glm::dmat3 r = glm::mat3_cast(q);
    const ModelVector turn = glm::cross(r[0], to[0]) + glm::cross(r[1], to[1]) + glm::cross(r[2], to[2]);
    const double size = std::abs(glm::dot(r[0], to[0]) + glm::dot(r[1], to[1]) + glm::dot(r[2], to[2]));
    const ModelVector half = turn * (0.5 / (size + 1e-300));
    const double length = glm::dot(half, half);
    // At most a right angle at a time.
    const ModelVector bounded = length > 1.0 ? half / std::sqrt(length) : half;
    q = unit(glm::dquat{1, bounded.x, bounded.y, bounded.z} * q);
    if (length < 1e-12) break;
  }
}

}  // namespace

Relaxation::Relaxation(const Patch& patch, std::vector<double> give) : patch_(patch), give_(std::move(give)) {
  give_.resize(patch.node_count(), 0.0);
  const auto rests = patch.rests();
  begins_.reserve(patch.node_count() + 1);
  for (std::uint32_t node = 0; node < patch.node_count(); ++node) {
    begins_.push_back(static_cast<std::uint32_t>(neighbours_.size()));
    if (node >= patch.inner_count()) continue;
    for (const std::uint32_t t : patch.star(node)) {
      for (const std::uint32_t other : patch.triangles()[t]) {
        if (other == node) continue;
        const auto known = std::span(neighbours_).subspan(begins_[node]);
        if (std::any_of(known.begin(), known.end(), [&](const Neighbour& n) { return n.node == other; })) continue;
        const double length = geometry::distance(rests[node], rests[other]);
        if (!(length > 0.0)) continue;
        neighbours_.push_back({other, 1.0 / length});
        if (node < other || other >= patch.inner_count()) edges_.push_back({{node, other}, length});
      }
    }
  }
  begins_.push_back(static_cast<std::uint32_t>(neighbours_.size()));
  edge_begins_.assign(patch.node_count() + 1, 0);
  for (const Edge& edge : edges_) {
    for (const std::uint32_t node : edge.ends) ++edge_begins_[node + 1];
  }
  for (std::size_t i = 1; i < edge_begins_.size(); ++i) edge_begins_[i] += edge_begins_[i - 1];
  edges_about_.resize(edge_begins_.back());
  std::vector<std::uint32_t> next(edge_begins_.begin(), edge_begins_.end() - 1);
  for (std::uint32_t i = 0; i < edges_.size(); ++i) {
    for (const std::uint32_t node : edges_[i].ends) edges_about_[next[node]++] = i;
  }
  turns_.resize(patch.node_count());
  matrices_.resize(patch.node_count());
  turned_.resize(patch.node_count(), 0);
}

bool Relaxation::limit_stretch(double bound, int sweeps, std::span<ModelPoint> places) {
  waiting_.assign((edges_.size() + 63) / 64, ~std::uint64_t{0});
  if (edges_.size() % 64 != 0) waiting_.back() = (std::uint64_t{1} << (edges_.size() % 64)) - 1;
  const auto wake = [&](std::uint32_t node) {
    for (std::uint32_t at = edge_begins_[node]; at < edge_begins_[node + 1]; ++at) {
      waiting_[edges_about_[at] / 64] |= std::uint64_t{1} << (edges_about_[at] % 64);
    }
  };
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    bool held = true;
    for (std::size_t word = 0; word < waiting_.size(); ++word) {
      // In the order of the edges: one that wakes an earlier one leaves it to the next sweep.
      for (std::uint64_t left = ~std::uint64_t{0}; (waiting_[word] & left) != 0;) {
        const int bit = std::countr_zero(waiting_[word] & left);
        left = bit == 63 ? 0 : ~std::uint64_t{0} << (bit + 1);
        waiting_[word] &= ~(std::uint64_t{1} << bit);
        const Edge& edge = edges_[word * 64 + static_cast<std::size_t>(bit)];
        const auto [a, b] = edge.ends;
        const ModelVector way = places[b] - places[a];
        const double most = bound * edge.length;
        const double square = glm::dot(way, way);
        if (!(square > most * most)) continue;
        const double sum = give_[a] + give_[b];
        if (!(sum > 0.0)) continue;
        held = false;
        const ModelVector pull = way * (k_over * (1.0 - k_below * most / std::sqrt(square)) / sum);
        places[a] += pull * give_[a];
        places[b] -= pull * give_[b];
        if (give_[a] > 0.0) wake(a);
        if (give_[b] > 0.0) wake(b);
      }
    }
    if (held) return true;
  }
  return false;
}

void Relaxation::unfold(std::span<const std::uint8_t> stiff, std::span<const std::uint8_t> marked, int sweeps,
                        std::span<ModelPoint> places) {
  const auto rests = patch_.rests();
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < patch_.inner_count(); ++node) {
    if (marked[node] != 0) nodes.push_back(node);
  }
  const auto weight = [&](std::uint32_t node, const Neighbour& beside) {
    const double says = beside.says * beside.says;
    return stiff[node] != 0 && stiff[beside.node] != 0 ? k_stiff * says : says;
  };
  const auto find_turn = [&](std::uint32_t node, int steps) {
    if (turned_[node] == 0) {
      turned_[node] = 1;
      turns_[node] = glm::dquat{1, 0, 0, 0};
      found_.push_back(node);
    }
    glm::dmat3 to{0};
    for (const Neighbour& beside : around(node)) {
      const ModelVector was = rests[beside.node] - rests[node];
      const ModelVector is = (places[beside.node] - places[node]) * weight(node, beside);
      to[0] += is * was.x;
      to[1] += is * was.y;
      to[2] += is * was.z;
    }
    follow(to, steps, turns_[node]);
    matrices_[node] = glm::mat3_cast(turns_[node]);
  };
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const int steps = sweep == 0 ? k_first_steps : k_relaxation_steps;
    for (const std::uint32_t node : nodes) {
      find_turn(node, steps);
      if (sweep > 0) continue;
      for (const Neighbour& beside : around(node)) {
        if (turned_[beside.node] == 0 && beside.node < patch_.inner_count() && marked[beside.node] == 0) {
          find_turn(beside.node, steps);
        }
      }
    }
    for (const std::uint32_t node : nodes) {
      if (!(give_[node] > 0.0)) continue;
      ModelPoint place{0};
      double count = 0;
      for (const Neighbour& beside : around(node)) {
        const ModelVector was = rests[node] - rests[beside.node];
        // A node of the rim stays as it is.
        const glm::dmat3& other = beside.node < patch_.inner_count() ? matrices_[beside.node] : matrices_[node];
        const double says = weight(node, beside);
        place += (places[beside.node] + (matrices_[node] * was + other * was) * 0.5) * says;
        count += says;
      }
      if (count > 0.0) places[node] = place / count;
    }
  }
  for (const std::uint32_t node : found_) turned_[node] = 0;
  found_.clear();
}

}  // namespace penpose::articulation
