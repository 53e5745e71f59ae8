#include "core/posing/curve_system.h"

#include <algorithm>

namespace penpose::posing {

CurveSystem::CurveSystem(const rig::Rig& rig, const PoseProblem& problem) : rig_(rig) {
  std::vector<CurvePoint> points;
  for (const CurvePair& pair : problem.pairs) {
    points.insert(points.end(), pair.reference.begin(), pair.reference.end());
    targets_.insert(targets_.end(), pair.target.begin(), pair.target.end());
    for (std::size_t i = 0; i < pair.reference.size(); ++i)
      weights_.push_back(pair.weights.empty() ? 1.0 : pair.weights[i]);
  }
  for (const Constraint& constraint : problem.constraints) {
    points.insert(points.end(), constraint.points.begin(), constraint.points.end());
    targets_.insert(targets_.end(), constraint.positions.begin(), constraint.positions.end());
    weights_.resize(points.size(), 1.0);
  }
  weights_.resize((points.size() + k_block_points - 1) / k_block_points * k_block_points, 0.0);

  std::vector<std::uint32_t> vertices;
  for (const CurvePoint& point : points) vertices.insert(vertices.end(), point.vertex.begin(), point.vertex.end());
  std::stable_sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (const CurvePoint& point : points) {
    std::array<std::uint32_t, 3> slot{};
    for (std::size_t k = 0; k < 3; ++k) {
      slot[k] = static_cast<std::uint32_t>(std::lower_bound(vertices.begin(), vertices.end(), point.vertex[k]) -
                                           vertices.begin());
    }
    slots_.push_back(slot);
    shares_.push_back(point.weight);
  }
  bound_ = rig.bind(vertices);
  vertex_positions_.resize(vertices.size());
}

void CurveSystem::positions(std::span<const double> pose, std::span<ModelPoint> out) {
  bound_->evaluate(pose, vertex_positions_);
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const auto& slot = slots_[i];
    const auto& share = shares_[i];
    out[i] = vertex_positions_[slot[0]] * share[0] + vertex_positions_[slot[1]] * share[1] +
             vertex_positions_[slot[2]] * share[2];
  }
}

void CurveSystem::residuals(std::span<const double> pose, std::span<double> out) {
  bound_->evaluate(pose, vertex_positions_);
  std::fill(out.begin(), out.end(), 0.0);
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    const auto& slot = slots_[i];
    const auto& share = shares_[i];
    const ModelPoint r = vertex_positions_[slot[0]] * share[0] + vertex_positions_[slot[1]] * share[1] +
                         vertex_positions_[slot[2]] * share[2] - targets_[i];
    for (std::size_t axis = 0; axis < 3; ++axis) out[residual_index(i, axis)] = r[static_cast<int>(axis)];
  }
}

double CurveSystem::energy(std::span<const double> residuals) const {
  return weighted_lengths(residuals.data(), weights_, softness_);
}

double CurveSystem::longest(std::span<const double> residuals) const {
  double longest = 0;
  for (std::size_t i = 0; i < point_count(); ++i) {
    if (weights_[i] <= 0.0) continue;
    longest = std::max(longest, geometry::length({residuals[residual_index(i, 0)], residuals[residual_index(i, 1)],
                                                  residuals[residual_index(i, 2)]}));
  }
  return longest;
}

std::optional<std::vector<Column>> CurveSystem::columns(std::span<const double> pose,
                                                        std::span<const std::size_t> free) {
  const auto form = bound_->linearize(pose, free);
  if (!form) return std::nullopt;
  const std::size_t n = vertex_positions_.size();
  std::vector<Column> columns;
  columns.reserve(free.size());
  for (std::size_t j = 0; j < free.size(); ++j) {
    const auto column = std::span(form->columns).subspan(j * n, n);
    Residuals values(residual_count(), 0.0);
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      const auto& slot = slots_[i];
      const auto& share = shares_[i];
      const geometry::ModelVector c =
          column[slot[0]] * share[0] + column[slot[1]] * share[1] + column[slot[2]] * share[2];
      for (std::size_t axis = 0; axis < 3; ++axis) values[residual_index(i, axis)] = c[static_cast<int>(axis)];
    }
    columns.emplace_back(std::move(values));
  }
  return columns;
}

}  // namespace penpose::posing
