#pragma once

#include <span>
#include <vector>

#include "core/base/interface.h"

namespace penpose::posing {

/// What a simplex minimises, in variables u that each run over 0..1.
///
/// An objective may carry an *image*: numbers that depend on u in an affine way and from which the value follows. The
/// simplex combines images with the weights with which it combines its vertices, so that a trial needs no evaluation
/// from scratch and costs the same for 15 and for 300 variables. A black box has an image of size 0.
class Objective : public base::Interface {
 public:
  [[nodiscard]] virtual std::size_t dimension() const = 0;
  [[nodiscard]] virtual std::size_t image_size() const = 0;
  /// The image at u, from scratch.
  virtual void make_image(std::span<const double> u, std::span<double> image) = 0;
  /// Updates the image for an increase of variable i of u by delta.
  virtual void shift_image(std::size_t i, double delta, std::span<double> image) = 0;
  /// The value at u, whose image is given. Counts as one evaluation.
  virtual double value(std::span<const double> u, std::span<const double> image) = 0;
};

}  // namespace penpose::posing
