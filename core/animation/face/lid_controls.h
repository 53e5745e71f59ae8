#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/animation/face/lids.h"
#include "core/animation/points/curve_transfer.h"
#include "core/geometry/camera.h"
#include "core/rig/rig.h"

namespace penpose::animation {

/// Controls that go together from rest to `full`, and how far the lids close on the way.
struct LidTravel {
  std::vector<std::size_t> parameters;
  std::vector<double> full;  ///< their values at the end of the way
  std::vector<double>
      reached;  ///< at even steps of the way: the closing, 0 at rest, growing (LidTravel of opening: widening)
};

/// What closes and what widens one eye of a model.
struct LidControls {
  LidTravel close;
  LidTravel widen;
};

/// Finds by what they move, never by name, the controls that bring the lids of each eye together: the one that does so
/// while it moves the rest of the model least, and others with it where it does not do alone. Eyes that nothing can
/// close by half have none. One entry an eye.
[[nodiscard]] std::vector<LidControls> find_lid_controls(const rig::Rig& rig, std::span<const double> rest,
                                                         std::span<const std::size_t> free, const Transfer& transfer,
                                                         std::span<const EyeCurves> eyes,
                                                         const geometry::Camera& camera);

/// Those of `free` that move lids and little else of what is tracked: what is left to find from the other curves.
[[nodiscard]] std::vector<std::size_t> without_lid_controls(const rig::Rig& rig, std::span<const double> rest,
                                                            std::span<const std::size_t> free, const Transfer& transfer,
                                                            std::span<const EyeCurves> eyes,
                                                            const geometry::Camera& camera);

/// Sets the controls of the eyes: `closed` one an eye as EyeMotion has it. Controls that serve several eyes take the
/// mean.
void set_lids(const rig::Rig& rig, std::span<const LidControls> controls, std::span<const double> closed,
              std::span<double> pose);

}  // namespace penpose::animation
