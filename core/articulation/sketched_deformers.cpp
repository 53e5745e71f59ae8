#include "core/articulation/sketched_deformers.h"

#include <algorithm>
#include <limits>
#include <set>

namespace penpose::articulation {
namespace {

/// Deformers at a few vertices. A deformer whose value has not changed since the last evaluation is not computed again:
/// a search that moves a few parameters at a time pays for those only.
class BoundDeformers final : public rig::BoundLayer {
 public:
  BoundDeformers(std::span<const std::shared_ptr<const Deformer>> deformers, std::span<const std::uint32_t> vertices) {
    for (const auto& deformer : deformers) {
      Part part;
      std::vector<std::uint32_t> places;
      const auto moved = deformer->vertices();
      for (std::uint32_t place = 0; place < vertices.size(); ++place) {
        const auto found = std::lower_bound(moved.begin(), moved.end(), vertices[place]);
        if (found == moved.end() || *found != vertices[place]) continue;
        part.places.push_back(place);
        places.push_back(static_cast<std::uint32_t>(found - moved.begin()));
      }
      part.skin = deformer->skin().subset(places);
      part.displacements.assign(places.size(), ModelVector{0});
      // Once here, so that no evaluation allocates.
      part.skin.displacements(1.0, work_, part.displacements);
      part.value = 1.0;
      parts_.push_back(std::move(part));
    }
  }

  void add(std::span<const double> values, std::span<ModelVector> displacements) override {
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      Part& part = parts_[i];
      if (values[i] == 0.0 || part.places.empty()) continue;
      if (values[i] != part.value) {
        part.skin.displacements(values[i], work_, part.displacements);
        part.value = values[i];
      }
      for (std::size_t k = 0; k < part.places.size(); ++k) displacements[part.places[k]] += part.displacements[k];
    }
  }

  [[nodiscard]] bool moves(std::size_t parameter) const override { return !parts_[parameter].places.empty(); }

  bool column(std::size_t parameter, std::span<ModelVector> displacements) const override {
    const Part& part = parts_[parameter];
    std::fill(displacements.begin(), displacements.end(), ModelVector{0});
    if (part.places.empty()) return true;
    if (!part.skin.linear()) return false;
    for (std::size_t k = 0; k < part.places.size(); ++k) displacements[part.places[k]] = part.skin.columns()[k];
    return true;
  }

 private:
  struct Part {
    std::vector<std::uint32_t> places;
    CurveSkin skin;
    std::vector<ModelVector> displacements;  ///< at `value`
    double value = 0;
  };
  std::vector<Part> parts_;
  CurveSkinWorkspace work_;
};

}  // namespace

base::Result<SketchedDeformers::Shared> SketchedDeformers::make(
    std::vector<std::shared_ptr<const Deformer>> deformers) {
  auto made = std::make_shared<SketchedDeformers>();
  std::set<std::string> names;
  for (std::size_t i = 0; i < deformers.size(); ++i) {
    made->parameters_.push_back(deformers[i]->parameter());
    if (!names.insert(made->parameters_.back().name).second) {
      return base::Error{"another control is called '" + made->parameters_.back().name + "' too",
                         std::to_string(i) + "/name", "rename one of them"};
    }
  }
  made->deformers_ = std::move(deformers);
  return Shared(std::move(made));
}

base::Result<SketchedDeformers::Shared> SketchedDeformers::build(std::span<const Sketch> sketches, const Canvas& canvas,
                                                                 std::size_t points) {
  std::vector<std::shared_ptr<const Deformer>> deformers;
  for (std::size_t i = 0; i < sketches.size(); ++i) {
    auto deformer = build_deformer(sketches[i], canvas, points);
    if (!deformer) {
      base::Error error = deformer.error();
      error.place = std::to_string(i) + "/" + error.place;
      return error;
    }
    deformers.push_back(std::move(deformer).value());
  }
  return make(std::move(deformers));
}

std::vector<Sketch> SketchedDeformers::sketches() const {
  std::vector<Sketch> sketches;
  for (const auto& deformer : deformers_) sketches.push_back(deformer->sketch());
  return sketches;
}

void SketchedDeformers::add(std::span<const double> values, std::span<ModelVector> displacements) const {
  CurveSkinWorkspace work;
  std::vector<ModelVector> moved;
  for (std::size_t i = 0; i < deformers_.size(); ++i) {
    if (values[i] == 0.0) continue;
    const auto vertices = deformers_[i]->vertices();
    moved.resize(vertices.size());
    deformers_[i]->skin().displacements(values[i], work, moved);
    for (std::size_t k = 0; k < vertices.size(); ++k) displacements[vertices[k]] += moved[k];
  }
}

std::unique_ptr<rig::BoundLayer> SketchedDeformers::bind(std::span<const std::uint32_t> vertices) const {
  return std::make_unique<BoundDeformers>(deformers_, vertices);
}

void add_to_hash(base::StateHash& hash, const SketchedDeformers& deformers) {
  hash.add("deformers");
  hash.add(std::uint64_t{deformers.size()});
  for (const auto& deformer : deformers.deformers()) add_to_hash(hash, deformer->sketch());
}

}  // namespace penpose::articulation
