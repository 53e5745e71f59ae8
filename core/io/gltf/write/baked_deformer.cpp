#include "core/io/gltf/write/baked_deformer.h"

#include <algorithm>
#include <cmath>

#include "core/io/gltf/write/deformer_sample.h"

namespace penpose::io {
namespace {

using Moves = std::vector<geometry::ModelVector>;

double farthest(const Moves& moves) {
  double most = 0;
  for (const auto& move : moves) most = std::max(most, move.x * move.x + move.y * move.y + move.z * move.z);
  return std::sqrt(most);
}

double product(const Moves& a, const Moves& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].x * b[i].x + a[i].y * b[i].y + a[i].z * b[i].z;
  return sum;
}

/// A target with the weights of one sign, scaled to 0..1: programs clamp what lies outside.
void add_target(rig::BlendShape target, const std::vector<double>& weights, double largest, BakedDeformer& baked) {
  for (glm::vec3& delta : target.deltas) delta = glm::vec3(geometry::ModelVector(delta) * largest);
  std::vector<double>& own = baked.weights.emplace_back();
  for (const double w : weights) own.push_back(std::max(0.0, w / largest));
  baked.targets.push_back(std::move(target));
}

}  // namespace

double BakedDeformer::weight(std::size_t k, double amount) const {
  const double from = amounts.front();
  const double steps = static_cast<double>(amounts.size() - 1);
  const double place = std::clamp((amount - from) / (amounts.back() - from) * steps, 0.0, steps);
  const auto before = std::min(static_cast<std::size_t>(place), amounts.size() - 2);
  const double t = place - static_cast<double>(before);
  return weights[k][before] * (1.0 - t) + weights[k][before + 1] * t;
}

BakedDeformer bake_deformer(const articulation::Deformer& deformer, double tolerance, std::size_t most) {
  constexpr std::size_t k_amounts = 97;  // over the range; weights are linear between them
  BakedDeformer baked;
  const rig::Parameter range = deformer.parameter();
  const double low = std::min(0.0, range.minimum);
  const double high = std::max(1.0, range.maximum);
  const rig::BlendShape sample = sample_deformer(deformer);
  articulation::CurveSkinWorkspace work;
  std::vector<Moves> left;
  for (std::size_t j = 0; j < k_amounts; ++j) {
    const double amount = low + (high - low) * static_cast<double>(j) / static_cast<double>(k_amounts - 1);
    baked.amounts.push_back(amount);
    Moves& moves = left.emplace_back(sample.vertices.size());
    deformer.skin().displacements(amount, work, moves);
    for (std::size_t i = 0; i < moves.size(); ++i) moves[i] -= geometry::ModelVector(sample.deltas[i]) * amount;
  }
  while (true) {
    std::size_t worst = 0;
    baked.error = 0;
    for (std::size_t j = 0; j < left.size(); ++j) {
      const double off = farthest(left[j]);
      if (off > baked.error) {
        baked.error = off;
        worst = j;
      }
    }
    if (baked.error <= tolerance || baked.targets.size() >= most) break;
    rig::BlendShape target;
    target.vertices = sample.vertices;
    Moves basis;
    for (const auto& move : left[worst]) {
      target.deltas.emplace_back(move);
      basis.emplace_back(target.deltas.back());
    }
    const double square = product(basis, basis);
    if (!(square > 0)) break;
    std::vector<double> weights;
    for (Moves& moves : left) {
      weights.push_back(product(moves, basis) / square);
      for (std::size_t i = 0; i < moves.size(); ++i) moves[i] -= basis[i] * weights.back();
    }
    // What the numbers of the file leave is too little to go on with.
    const double most_weight = *std::max_element(weights.begin(), weights.end());
    const double least_weight = *std::min_element(weights.begin(), weights.end());
    if (most_weight > 0) add_target(target, weights, most_weight, baked);
    if (least_weight < -1e-3) add_target(target, weights, least_weight, baked);
  }
  // Between the amounts weights go straight and the deformer does not.
  for (std::size_t j = 0; j + 1 < k_amounts; ++j) {
    const double amount = (baked.amounts[j] + baked.amounts[j + 1]) / 2;
    Moves moves(sample.vertices.size());
    deformer.skin().displacements(amount, work, moves);
    for (std::size_t i = 0; i < moves.size(); ++i) {
      moves[i] -= geometry::ModelVector(sample.deltas[i]) * amount;
      for (std::size_t k = 0; k < baked.targets.size(); ++k) {
        moves[i] -= geometry::ModelVector(baked.targets[k].deltas[i]) * baked.weight(k, amount);
      }
    }
    baked.error = std::max(baked.error, farthest(moves));
  }
  return baked;
}

}  // namespace penpose::io
