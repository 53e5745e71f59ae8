#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace penpose::posing {

/// Vectors of curve points, four points to a block: x of the four, y of the four, z of the four. Padded with zeros to
/// whole blocks.
using Residuals = std::vector<double>;
inline constexpr std::size_t k_block_points = 4;
inline constexpr std::size_t k_block_numbers = 12;
/// Index of a point's coordinate (axis 0..2) in Residuals.
[[nodiscard]] constexpr std::size_t residual_index(std::size_t point, std::size_t axis) {
  return point / k_block_points * k_block_numbers + axis * k_block_points + point % k_block_points;
}

/// Sum over the points of w_i sqrt(x_i^2 + y_i^2 + z_i^2 + softness^2): lengths, but those below `softness` count as
/// squares, so that many small ones are spread over all points instead of a few (Charbonnier, Blanc-Feraud, Aubert
/// and Barlaud 1994). Precondition: one weight a point, padding included.
[[nodiscard]] double weighted_lengths(const double* residuals, std::span<const double> weights, double softness = 0);

/// How residuals change with one variable: most variables move few of the points, so the blocks that are not all zero
/// are listed.
class Column {
 public:
  Column() = default;
  explicit Column(Residuals values);
  [[nodiscard]] const Residuals& values() const { return values_; }
  void scale(double factor);
  /// Sum of value_i b_i over all places.
  [[nodiscard]] double dot(const double* b) const;
  /// out_i = value_i b_i where the column is not zero; other entries of out do not change.
  void multiply(const double* b, double* out) const;
  /// Sum of a_i b_i over the places where this column is not zero.
  [[nodiscard]] double dot_within(const double* a, const double* b) const;
  /// out_i += factor value_i.
  void add_to(double factor, double* out) const;

 private:
  struct Run {
    std::uint32_t begin;
    std::uint32_t end;
  };
  Residuals values_;
  std::vector<Run> runs_;
};

}  // namespace penpose::posing
