#include "core/io/gltf/write/glb_targets.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/io/gltf/write/deformer_sample.h"

namespace penpose::io {

GlbTargets::GlbTargets(const document::Model& model, double tolerance)
    : size_(document::rest_world_box(model).diagonal()), between_tolerance_(0.25 * tolerance * size_) {
  if (model.shapes) {
    for (const rig::BlendShape& shape : model.shapes->shapes()) targets_.push_back(&shape);
  }
  if (!model.deformers) {
    add_corrections(model);
    return;
  }
  samples_.reserve(model.deformers->size());
  for (const auto& deformer : model.deformers->deformers()) {
    samples_.push_back(sample_deformer(*deformer));
    targets_.push_back(&samples_.back());
  }
  bake(model, tolerance);
  add_corrections(model);
}

void GlbTargets::add_corrections(const document::Model& model) {
  if (!model.corrections) return;
  amounts_ = model.corrections;
  std::set<std::string> taken;
  for (const rig::BlendShape* target : targets_) taken.insert(target->parameter.name);
  for (const auto& one : model.corrections->all()) {
    rig::BlendShape& shape = corrections_.emplace_back();
    shape.parameter.name = one->drawn.sketch.name;
    // A target that baking made may have been given that name.
    while (!taken.insert(shape.parameter.name).second) shape.parameter.name += "~";
    shape.vertices = one->vertices;
    for (const geometry::ModelVector& move : one->moves) shape.deltas.emplace_back(move);
  }
  for (const rig::BlendShape& shape : corrections_) targets_.push_back(&shape);
}

void GlbTargets::bake(const document::Model& model, double tolerance) {
  std::set<std::string> taken;
  for (const rig::BlendShape* target : targets_) taken.insert(target->parameter.name);
  names_.resize(samples_.size());
  const std::size_t shapes = targets_.size() - samples_.size();
  for (std::size_t d = 0; d < samples_.size(); ++d) {
    baked_.push_back(bake_deformer(*model.deformers->deformers()[d], 0.75 * tolerance * size_));
    if (size_ > 0) bake_error_ = std::max(bake_error_, baked_.back().error / size_);
    for (std::size_t k = 0; k < baked_.back().targets.size(); ++k) {
      std::string name = samples_[d].parameter.name;
      name += "~";
      name += std::to_string(k + 2);
      while (!taken.insert(name).second) name += "~";
      baked_.back().targets[k].parameter.name = name;
      names_[d].push_back(name);
      places_.push_back({shapes + d, d, k});
    }
  }
  for (const Place& place : places_) targets_.push_back(&baked_[place.deformer].targets[place.target]);
}

std::vector<double> GlbTargets::weights(std::span<const double> values) const {
  std::vector<double> weights(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(own_count()));
  for (const Place& place : places_) {
    weights.push_back(baked_[place.deformer].weight(place.target, values[place.parameter]));
  }
  for (std::size_t i = 0; i < corrections_.size(); ++i) weights.push_back(amounts_->amount(i, values));
  return weights;
}

std::vector<double> GlbTargets::tangents(std::span<const double> tangents, std::span<const double> values) const {
  std::vector<double> all(tangents.begin(), tangents.begin() + static_cast<std::ptrdiff_t>(own_count()));
  for (const Place& place : places_) {
    const BakedDeformer& baked = baked_[place.deformer];
    const double step = baked.amounts[1] - baked.amounts[0];
    const double at = values[place.parameter];
    const double slope = (baked.weight(place.target, at + step) - baked.weight(place.target, at - step)) / (2 * step);
    all.push_back(slope * tangents[place.parameter]);
  }
  constexpr double k_step = 1e-4;
  std::vector<double> there(values.begin(), values.end());
  for (std::size_t i = 0; i < corrections_.size(); ++i) {
    double slope = 0;
    for (const auto& lever : amounts_->levers(i)) {
      const double at = values[lever.parameter];
      const double step = k_step * std::abs(lever.value - lever.rest);
      there[lever.parameter] = at + step;
      const double after = amounts_->amount(i, there);
      there[lever.parameter] = at - step;
      slope += (after - amounts_->amount(i, there)) / (2 * step) * tangents[lever.parameter];
      there[lever.parameter] = at;
    }
    all.push_back(slope);
  }
  return all;
}

}  // namespace penpose::io
