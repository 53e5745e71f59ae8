#include "core/rig/blend_shapes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace penpose::rig {
namespace {

std::optional<base::Error> check_shape(const BlendShape& shape, std::size_t index, std::size_t vertex_count) {
  const std::string place = "target " + (shape.parameter.name.empty() ? std::to_string(index) : shape.parameter.name);
  const auto fail = [&](const char* what, const char* remedy) { return base::Error{what, place, remedy}; };
  if (shape.deltas.size() != shape.vertices.size())
    return fail("has another number of deltas than of vertices", "export the model again");
  if (!shape.normal_deltas.empty() && shape.normal_deltas.size() != shape.vertices.size()) {
    return fail("has another number of normals than of vertices", "export the model again");
  }
  for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
    if (shape.vertices[i] >= vertex_count) return fail("moves a vertex that does not exist", "export the model again");
    if (i > 0 && shape.vertices[i] <= shape.vertices[i - 1])
      return fail("lists its vertices out of order", "export the model again");
    const glm::vec3& d = shape.deltas[i];
    if (!std::isfinite(d.x) || !std::isfinite(d.y) || !std::isfinite(d.z)) {
      return fail("has a delta that is not a finite number", "export the model again without NaN or infinite deltas");
    }
  }
  const Parameter& p = shape.parameter;
  if (!(p.minimum < p.maximum) || !(p.rest >= p.minimum && p.rest <= p.maximum)) {
    return fail("has a range without room for its rest value", "give minimum <= rest <= maximum");
  }
  return std::nullopt;
}

/// Deltas of a few vertices, one sparse run a shape.
class BoundBlendShapes final : public BoundLayer {
 public:
  BoundBlendShapes(const BlendShapes& shapes, std::span<const std::uint32_t> vertices)
      : first_(shapes.shapes().size() + 1, 0) {
    for (const std::uint32_t v : vertices) {
      for (const auto& entry : shapes.entries_of(v)) ++first_[entry.shape + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    entries_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t place = 0; place < vertices.size(); ++place) {
      for (const auto& entry : shapes.entries_of(vertices[place]))
        entries_[next[entry.shape]++] = {place, ModelVector(entry.delta)};
    }
  }

  void add(std::span<const double> values, std::span<ModelVector> displacements) override {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] == 0.0) continue;
      for (const Entry& entry : run(i)) displacements[entry.place] += entry.delta * values[i];
    }
  }
  [[nodiscard]] bool moves(std::size_t parameter) const override { return !run(parameter).empty(); }
  bool column(std::size_t parameter, std::span<ModelVector> displacements) const override {
    std::fill(displacements.begin(), displacements.end(), ModelVector{0});
    for (const Entry& entry : run(parameter)) displacements[entry.place] = entry.delta;
    return true;
  }

 private:
  struct Entry {
    std::uint32_t place;
    ModelVector delta;
  };
  [[nodiscard]] std::span<const Entry> run(std::size_t i) const {
    return std::span(entries_).subspan(first_[i], first_[i + 1] - first_[i]);
  }
  std::vector<std::size_t> first_;
  std::vector<Entry> entries_;
};

}  // namespace

base::Result<std::shared_ptr<const BlendShapes>> BlendShapes::make(std::vector<BlendShape> shapes,
                                                                   std::size_t vertex_count) {
  auto made = std::make_shared<BlendShapes>();
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    if (auto error = check_shape(shapes[i], i, vertex_count)) return *error;
    made->parameters_.push_back(shapes[i].parameter);
  }
  made->first_entry_.assign(vertex_count + 1, 0);
  for (const BlendShape& shape : shapes) {
    for (const std::uint32_t v : shape.vertices) ++made->first_entry_[v + 1];
  }
  std::partial_sum(made->first_entry_.begin(), made->first_entry_.end(), made->first_entry_.begin());
  made->entries_.resize(made->first_entry_.back());
  std::vector<std::uint32_t> next(made->first_entry_.begin(), made->first_entry_.end() - 1);
  for (std::uint32_t s = 0; s < shapes.size(); ++s) {
    for (std::size_t k = 0; k < shapes[s].vertices.size(); ++k)
      made->entries_[next[shapes[s].vertices[k]]++] = {s, shapes[s].deltas[k]};
  }
  made->shapes_ = std::move(shapes);
  return std::shared_ptr<const BlendShapes>(std::move(made));
}

void BlendShapes::add(std::span<const double> values, std::span<ModelVector> displacements) const {
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    if (values[i] == 0.0) continue;
    const BlendShape& shape = shapes_[i];
    for (std::size_t k = 0; k < shape.vertices.size(); ++k) {
      displacements[shape.vertices[k]] += ModelVector(shape.deltas[k]) * values[i];
    }
  }
}

std::unique_ptr<BoundLayer> BlendShapes::bind(std::span<const std::uint32_t> vertices) const {
  return std::make_unique<BoundBlendShapes>(*this, vertices);
}

}  // namespace penpose::rig
