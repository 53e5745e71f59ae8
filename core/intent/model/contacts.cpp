#include "core/intent/model/contacts.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace penpose::intent {
namespace {

using geometry::ModelPoint;
using geometry::ModelVector;

/// Vertices that look for a partner, at most.
constexpr std::size_t k_most_pairs = 1500;
/// Partners lie within this share of the size of what shapes move, and behind each other by no more than `k_behind`.
constexpr double k_touch_reach = 0.02;
constexpr double k_behind = 0.003;
/// Their normals are against each other by at least this cosine.
constexpr double k_against = 0.3;
/// This share of the pairs is less deep than what is called the depth: single vertices say little.
constexpr double k_share = 0.98;

std::vector<ModelVector> normals_of(const mesh::TriangleMesh& mesh, std::span<const ModelPoint> rest) {
  std::vector<ModelVector> normals(rest.size(), ModelVector{0});
  for (const mesh::Triangle& t : mesh.triangles()) {
    const ModelVector normal = glm::cross(rest[t[1]] - rest[t[0]], rest[t[2]] - rest[t[0]]);
    for (const std::uint32_t v : t) normals[mesh.weld()[v]] += normal;
  }
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const ModelVector whole = normals[mesh.weld()[v]];
    normals[v] = geometry::normalized(whole, ModelVector{0});
  }
  return normals;
}

}  // namespace

Contacts::Contacts(const mesh::TriangleMesh& mesh, std::span<const ModelPoint> rest, const std::vector<bool>& moved) {
  geometry::Box box;
  std::vector<std::uint32_t> by_x;
  for (std::size_t v = 0; v < rest.size(); ++v) {
    if (!moved[v] || !std::isfinite(rest[v].x + rest[v].y + rest[v].z)) continue;
    box.add(rest[v]);
    by_x.push_back(static_cast<std::uint32_t>(v));
  }
  size_ = box.diagonal();
  if (!(size_ > 0.0)) return;
  const std::vector<ModelVector> normals = normals_of(mesh, rest);
  const std::vector<std::uint32_t> all = by_x;
  std::stable_sort(by_x.begin(), by_x.end(), [&](auto a, auto b) { return rest[a].x < rest[b].x; });
  const double reach = k_touch_reach * size_;
  const auto vertex = [&](std::uint32_t v) {
    vertices_.push_back(v);
    return vertices_.size() - 1;
  };
  const std::size_t step = (all.size() + k_most_pairs - 1) / k_most_pairs;
  for (std::size_t i = 0; i < all.size(); i += step) {
    const std::uint32_t a = all[i];
    const double first_x = rest[a].x - reach;
    auto at = std::lower_bound(by_x.begin(), by_x.end(), first_x, [&](auto v, double x) { return rest[v].x < x; });
    double nearest = reach;
    std::uint32_t b = a;
    for (; at != by_x.end() && rest[*at].x <= rest[a].x + reach; ++at) {
      if (glm::dot(normals[a], normals[*at]) > -k_against) continue;
      const ModelVector way = rest[*at] - rest[a];
      const double far = geometry::length(way);
      if (!(far < nearest) || glm::dot(way, normals[a]) < -k_behind * size_) continue;
      nearest = far;
      b = *at;
    }
    if (b == a) continue;
    const double gap = std::max(0.0, glm::dot(rest[b] - rest[a], normals[a]));
    pairs_.push_back({vertex(a), vertex(b), normals[a], gap});
  }
}

void Contacts::add(std::span<const ModelPoint> rest, std::span<const ModelPoint> there, double per) {
  auto& own = closings_.emplace_back();
  double& depth = depths_.emplace_back();
  if (there.empty() || pairs_.empty()) return;
  std::vector<double> by_pair;
  for (const Pair& pair : pairs_) {
    const ModelVector way = (there[pair.a] - rest[pair.a]) - (there[pair.b] - rest[pair.b]);
    const double closing = glm::dot(way, pair.normal) * per;
    own.push_back(static_cast<float>(std::isfinite(closing) ? closing : 0.0));
    by_pair.push_back(own.back() - pair.gap);
  }
  depth = depth_of(by_pair);
}

double Contacts::depth_of(std::vector<double>& by_pair) const {
  std::stable_sort(by_pair.begin(), by_pair.end());
  const auto at = static_cast<std::size_t>(k_share * static_cast<double>(by_pair.size() - 1));
  return std::max(0.0, by_pair[at] / size_);
}

double Contacts::depth(std::size_t control, std::span<const double> pose) const {
  if (closings_[control].empty()) return 0;
  std::vector<double> by_pair(pairs_.size());
  for (std::size_t i = 0; i < pairs_.size(); ++i) by_pair[i] = closings_[control][i] - pairs_[i].gap;
  for (std::size_t p = 0; p < pose.size(); ++p) {
    if (pose[p] == 0.0 || closings_[p].empty()) continue;
    for (std::size_t i = 0; i < pairs_.size(); ++i) by_pair[i] += pose[p] * closings_[p][i];
  }
  return depth_of(by_pair);
}

}  // namespace penpose::intent
