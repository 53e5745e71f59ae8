#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/interface.h"
#include "core/geometry/space.h"

namespace penpose::rig {

using geometry::ModelPoint;
using geometry::ModelVector;

/// One control of a rig. The solver never leaves minimum..maximum.
struct Parameter {
  std::string name;
  double rest = 0;
  double minimum = 0;
  double maximum = 1;
  friend bool operator==(const Parameter&, const Parameter&) = default;
};

/// One value for each parameter of a rig, in its order.
using Pose = std::vector<double>;

/// Positions that depend on some parameters in an affine way: position[v] = constant[v] + sum over i of x[i]
/// columns[i][v]. columns holds one run of constant.size() vectors after the other, one run for each free parameter in
/// the order asked for.
struct LinearForm {
  std::vector<ModelPoint> constant;
  std::vector<ModelVector> columns;
};

/// A few vertices of a rig, ready for being evaluated many times. Holds scratch memory: one object for each thread.
class BoundVertices : public base::Interface {
 public:
  [[nodiscard]] virtual std::size_t vertex_count() const = 0;
  /// World positions of the bound vertices, in the order in which they were bound. Never allocates.
  virtual void evaluate(std::span<const double> pose, std::span<ModelPoint> positions) = 0;
  /// False when no value of the parameter moves any bound vertex.
  [[nodiscard]] virtual bool moves(std::size_t parameter) const = 0;
  /// The affine form in the free parameters while all others stay at `pose`; nothing when a free parameter acts in
  /// another way.
  [[nodiscard]] virtual std::optional<LinearForm> linearize(std::span<const double> pose,
                                                            std::span<const std::size_t> free) = 0;
};

/// Anything that turns parameters into vertex positions. Immutable; safe to share between threads.
class Rig : public base::Interface {
 public:
  [[nodiscard]] virtual std::span<const Parameter> parameters() const = 0;
  [[nodiscard]] virtual std::size_t vertex_count() const = 0;
  /// World positions of all vertices. Precondition: pose has one value a parameter, positions one place a vertex.
  virtual void evaluate(std::span<const double> pose, std::span<ModelPoint> positions) const = 0;
  /// Vertices may repeat. Precondition: each exists, and the rig outlives what is returned.
  [[nodiscard]] virtual std::unique_ptr<BoundVertices> bind(std::span<const std::uint32_t> vertices) const = 0;
};

/// The rest value of every parameter.
[[nodiscard]] Pose rest_pose(const Rig& rig);
/// The number of the parameter of that name.
[[nodiscard]] std::optional<std::size_t> find_parameter(std::span<const Parameter> parameters, std::string_view name);

}  // namespace penpose::rig
