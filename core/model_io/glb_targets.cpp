#include "core/model_io/glb_targets.h"

#include <algorithm>
#include <set>

#include "core/model_io/deformer_sample.h"

namespace penpose::model_io {

GlbTargets::GlbTargets(const document::Model& model, double tolerance)
    : size_(document::rest_world_box(model).diagonal()), between_tolerance_(0.25 * tolerance * size_) {
  if (model.shapes) {
    for (const rig::BlendShape& shape : model.shapes->shapes()) targets_.push_back(&shape);
  }
  if (!model.deformers) return;
  samples_.reserve(model.deformers->size());
  for (const auto& deformer : model.deformers->deformers()) {
    samples_.push_back(sample_deformer(*deformer));
    targets_.push_back(&samples_.back());
  }
  bake(model, tolerance);
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
  return all;
}

}  // namespace penpose::model_io
