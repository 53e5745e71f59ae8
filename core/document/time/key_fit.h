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

  /// Adds keys where the fit is off by most, until no pose is off by more than the tolerance. `error(fitted, f)` says
  /// by how much pose f is off.
  void refine(double tolerance, const std::function<double(const rig::Pose& fitted, std::size_t f)>& error);

  /// Adds a key at a pose that is off, or between the keys around it where it is one. False: every pose there is a key.
  bool add(std::size_t pose);

  /// The poses that are keys, by number, ascending.
  [[nodiscard]] const std::vector<std::size_t>& keys() const { return keys_; }
  /// Value and slope (a second) of the control of that number in the list at a key, by the number of its pose.
  [[nodiscard]] std::pair<double, double> at(std::size_t control, std::size_t pose) const;

 private:
  void fit();
  void fit_control(std::size_t control);
  [[nodiscard]] rig::Pose fitted(std::size_t pose) const;
  [[nodiscard]] std::size_t segment_of(std::size_t pose) const;

  std::span<const double> moments_s_;
  std::span<const rig::Pose> poses_;
  std::span<const std::size_t> controls_;
  std::vector<std::size_t> keys_;
  std::vector<std::vector<std::pair<double, double>>> values_;  ///< a row a control: value and slope of each key
};

}  // namespace penpose::document
