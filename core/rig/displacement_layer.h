#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/interface.h"
#include "core/rig/rig.h"

namespace penpose::rig {

/// A layer evaluated at a few vertices only.
class BoundLayer : public base::Interface {
 public:
  /// Adds the layer's displacements at its parameter values (one for each parameter of the layer). Never allocates.
  virtual void add(std::span<const double> values, std::span<ModelVector> displacements) = 0;
  /// False when no value of the layer's parameter moves any bound vertex.
  [[nodiscard]] virtual bool moves(std::size_t parameter) const = 0;
  /// Writes the displacement for one unit of the parameter and returns true when the layer is linear in it; false
  /// otherwise.
  virtual bool column(std::size_t parameter, std::span<ModelVector> displacements) const = 0;
};

/// A set of parameters that each displace rest vertices. The displacements of all layers add up; joints act after the
/// sum.
class DisplacementLayer : public base::Interface {
 public:
  [[nodiscard]] virtual std::span<const Parameter> parameters() const = 0;
  /// A layer without parameters of its own that what others are set to brings in: it and what is bound of it are given
  /// the values of the whole rig, by whose numbers `moves` and `column` go.
  [[nodiscard]] virtual bool driven() const { return false; }
  /// Adds to all vertices.
  virtual void add(std::span<const double> values, std::span<ModelVector> displacements) const = 0;
  [[nodiscard]] virtual std::unique_ptr<BoundLayer> bind(std::span<const std::uint32_t> vertices) const = 0;
};

}  // namespace penpose::rig
