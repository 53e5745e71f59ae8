#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "core/prior/pose_prior.h"

// How well keys foretell each other: each is left out in turn and suggested from the others.

namespace penpose::prior {

/// The parameters of a key that count as posed by the artist, ascending.
using HeldOf = std::function<std::vector<std::size_t>(const rig::Pose&)>;

/// At most so many keys are left out to find `trust`; of more, so many are taken evenly.
inline constexpr std::size_t k_most_left_out = 64;

/// The strength of suggestions that would have predicted the keys themselves best, in least squares over the vertices
/// of the whole model: every distinct key is left out, its posed parameters are held with the others at rest, and the
/// others are suggested from the other keys. 0..1; 1 where there is nothing to try it on.
[[nodiscard]] double trust(const rig::Rig& rig, std::span<const rig::Pose> keys, const HeldOf& held);

/// One key that was left out. Lengths are root sums of squares over the vertices of the whole model, model units.
struct LeftOut {
  std::size_t key = 0;   ///< its number among those given
  double way = 0;        ///< of the key's pose from the rest pose
  double still = 0;      ///< left where only what is held is as in the key, the others at rest
  double mean = 0;       ///< left where the others are at the mean of the other keys
  double suggested = 0;  ///< left by the suggestion
  double strength = 1;   ///< of the suggestion
  std::size_t held = 0;  ///< parameters that were held
};

/// Leaves every distinct key out. A key of which nothing is held is passed over; one for which the others say nothing
/// (`suggest` refuses) is judged as not moved. `strength`: none asks `trust` of the other keys. `done` is called after
/// each; may be empty. Errors: those of `learn` for all keys; fewer than three distinct keys.
[[nodiscard]] base::Result<std::vector<LeftOut>> leave_one_out(const rig::Rig& rig, std::span<const rig::Pose> keys,
                                                               const HeldOf& held, std::optional<double> strength,
                                                               const std::function<void()>& done = {});

}  // namespace penpose::prior
