#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/rig/rig.h"

// What poses that were keyed before say of one that is half made.

namespace penpose::prior {

/// A normal distribution of poses. Values are shares of each parameter's range. The samples are the distinct keys and
/// the rest pose, which is a pose of every character and without which a few keys of one mood would count as its
/// nature; n of them in all, in an order that does not depend on that of the keys. With X the samples less their mean:
///
///   covariance = (1 - rho) X'X / n + rho mu I,      mu = tr(X'X) / (n p),
///
/// rho by `oracle_shrinkage` for n samples of the p parameters that varied.
struct PosePrior {
  std::vector<std::size_t> varied;  ///< p parameters that the keys differ in, ascending
  std::size_t keys = 0;             ///< distinct ones
  std::size_t samples = 0;          ///< n
  std::vector<double> mean;         ///< one a varied parameter
  std::vector<double> deviations;   ///< X: n runs of p
  double shrinkage = 1;             ///< rho
  double spread = 0;                ///< mu
};

/// Keys vary in a parameter where they differ by more than this share of its range: less is not seen.
inline constexpr double k_least_variation = 1e-4;
/// A suggestion within this share of a parameter's range of where it stands leaves it there.
inline constexpr double k_least_change = 5e-3;

/// The keys without those that are there already, bit for bit, in their order.
[[nodiscard]] std::vector<std::size_t> distinct(std::span<const rig::Pose> keys);

/// Errors: a pose of another number of values or with one that is no number; fewer than two distinct keys; keys that
/// differ in nothing that can be seen.
[[nodiscard]] base::Result<PosePrior> learn(std::span<const rig::Parameter> parameters,
                                            std::span<const rig::Pose> keys);

/// The likeliest pose with the parameters of `held` (ascending, each once) as `pose` has them: for the others that
/// varied their conditional mean
///
///   m_u + C_uk C_kk^-1 (k - m_k),
///
/// within their ranges, and `strength` (0..1) of the way there. What never varied stays. The equations are solved in
/// the space of the held parameters or in that of the samples, whichever is smaller. Errors: no held
/// parameter varies in the keys, so that they say nothing about the others.
[[nodiscard]] base::Result<rig::Pose> suggest(const PosePrior& prior, std::span<const rig::Parameter> parameters,
                                              const rig::Pose& pose, std::span<const std::size_t> held,
                                              double strength = 1);

}  // namespace penpose::prior
