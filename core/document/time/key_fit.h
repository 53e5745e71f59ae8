#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/rig/rig.h"

namespace penpose::document {

/// Few keys for many poses: cubic Hermite curves of some controls, all with keys at the same moments, by least squares
/// (one slope a key). The first and the last pose are met. Moments ascend, at least two, one pose each.
class KeyFit {
 public:
  KeyFit(std::span<const double> moments_s, std::span<const rig::Pose> poses, std::span<const std::size_t> controls);

  /// Adds keys where the fit is off by most, until no pose is off by more than the tolerance. `errors` says by how much
  /// each pose is off as the fit is now.
  void refine(double tolerance, const std::function<std::vector<double>()>& errors);

  /// The poses that are keys, by number, ascending.
  [[nodiscard]] const std::vector<std::size_t>& keys() const { return keys_; }
  /// What the curves make of a pose, by its number.
  [[nodiscard]] rig::Pose fitted(std::size_t pose) const;
  /// Value and slope (a second) of the control of that number in the list at a key, by the number of its pose.
  [[nodiscard]] std::pair<double, double> at(std::size_t control, std::size_t pose) const;

 private:
  /// Adds a key at a pose that is off, or beside it where it is one. False: every pose there is a key.
  bool add(std::size_t pose);
  void fit();
  void fit_control(std::size_t control);
  [[nodiscard]] std::size_t segment_of(std::size_t pose) const;

  std::span<const double> moments_s_;
  std::span<const rig::Pose> poses_;
  std::span<const std::size_t> controls_;
  std::vector<std::size_t> keys_;
  std::vector<std::vector<std::pair<double, double>>> values_;  ///< a row a control: value and slope of each key
};

}  // namespace penpose::document
