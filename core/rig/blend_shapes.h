#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/rig/displacement_layer.h"

namespace penpose::rig {

/// One morph target: the vertices that it moves, ascending and without repeats, and by how much at value one. Deltas
/// are in the space of the rest vertices, in float, the precision of glTF. `normal_deltas` is empty or has one entry a
/// vertex.
struct BlendShape {
  Parameter parameter;
  std::vector<std::uint32_t> vertices;
  std::vector<glm::vec3> deltas;
  std::vector<glm::vec3> normal_deltas;
};

/// Morph targets, as glTF adds them: rest + sum of value times delta.
class BlendShapes final : public DisplacementLayer {
 public:
  /// Errors (place "target NAME"): a vertex out of range or out of order, a delta that is not finite, another number of
  /// deltas than vertices, a range without room.
  static base::Result<std::shared_ptr<const BlendShapes>> make(std::vector<BlendShape> shapes,
                                                               std::size_t vertex_count);

  /// One vertex's share of one shape.
  struct Entry {
    std::uint32_t shape;
    glm::vec3 delta;
  };

  [[nodiscard]] std::span<const BlendShape> shapes() const { return shapes_; }
  /// Of the mesh that they are for.
  [[nodiscard]] std::size_t vertex_count() const { return first_entry_.size() - 1; }
  /// The shapes that move a vertex, ascending.
  [[nodiscard]] std::span<const Entry> entries_of(std::uint32_t vertex) const {
    return std::span(entries_).subspan(first_entry_[vertex], first_entry_[vertex + 1] - first_entry_[vertex]);
  }
  [[nodiscard]] std::span<const Parameter> parameters() const override { return parameters_; }
  void add(std::span<const double> values, std::span<ModelVector> displacements) const override;
  [[nodiscard]] std::unique_ptr<BoundLayer> bind(std::span<const std::uint32_t> vertices) const override;

 private:
  std::vector<BlendShape> shapes_;
  std::vector<Parameter> parameters_;
  std::vector<std::uint32_t> first_entry_;  ///< one a vertex and one past the end
  std::vector<Entry> entries_;
};

}  // namespace penpose::rig
