#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::intent {

using geometry::ModelPoint;
using geometry::ModelVector;

[[nodiscard]] inline double square_of(const ModelVector& v) { return v.x * v.x + v.y * v.y + v.z * v.z; }

/// What a control does to samples of a model: those that it moves, ascending, and the way of each.
struct ControlField {
  std::span<const std::uint32_t> samples;
  std::span<const ModelVector> ways;
};

/// What each control does to the whole model, on a sample of its vertices.
class ControlFields {
 public:
  ControlFields() = default;
  /// Chooses samples, evenly by number. `rest`: positions at rest.
  explicit ControlFields(std::span<const ModelPoint> rest);

  /// Adds the next parameter's field: `per` times the way of each of some vertices, ascending, that it may move.
  void add(std::span<const std::uint32_t> vertices, std::span<const ModelPoint> rest, std::span<const ModelPoint> moved,
           double per);

  [[nodiscard]] std::size_t control_count() const { return fields_.size(); }
  /// The vertices that are samples, ascending.
  [[nodiscard]] std::span<const std::uint32_t> samples() const { return samples_; }
  /// The samples at rest.
  [[nodiscard]] std::span<const ModelPoint> places() const { return places_; }
  /// Model units for the parameter's whole range; of a joint's angle for a radian.
  [[nodiscard]] ControlField field(std::size_t control) const {
    return {fields_[control].samples, fields_[control].ways};
  }
  /// Inner product of two fields.
  [[nodiscard]] double product(std::size_t a, std::size_t b) const;
  /// The ways of each sample by some controls, zero where one moves none: for products with many others. Those past
  /// the last control move none.
  static constexpr std::size_t k_together = 4;
  using Spread = std::vector<std::array<ModelVector, k_together>>;
  void spread(std::span<const std::size_t> controls, Spread& ways) const;
  /// product(control, other) of each that was spread, to the bit.
  [[nodiscard]] std::array<double, k_together> products(const Spread& ways, std::size_t other) const;
  /// The same as product(control, control - back), kept for the angles of one joint. Precondition: back is 1 or 2.
  [[nodiscard]] double product_with_last(std::size_t control, std::size_t back) const {
    return last_products_[control][back - 1];
  }
  /// Product of a field with itself, and the way of what it moves most: root mean square, each sample weighted by the
  /// square of its own way.
  [[nodiscard]] double square(std::size_t control) const { return squares_[control]; }
  [[nodiscard]] double usual_way(std::size_t control) const { return usual_ways_[control]; }

 private:
  struct Moved {
    std::vector<std::uint32_t> samples;
    std::vector<ModelVector> ways;
  };

  std::size_t step_ = 1;
  std::vector<std::uint32_t> sample_at_;  ///< of every step-th vertex; that of no sample where it is no number
  std::vector<std::uint32_t> samples_;
  std::vector<ModelPoint> places_;
  std::vector<Moved> fields_;
  std::vector<double> squares_, usual_ways_;
  std::vector<std::array<double, 2>> last_products_;
};

}  // namespace penpose::intent
