#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/animation/face/lids.h"
#include "core/animation/points/curve_transfer.h"
#include "core/geometry/camera.h"
#include "core/rig/rig.h"

namespace penpose::animation {

/// Controls that move together from rest to `full`, and how far the lids close on the way.
struct LidTravel {
  std::vector<std::size_t> parameters;
  std::vector<double> full;  ///< their values at the end of the way
  std::vector<double>
      reached;  ///< at even steps of the way: the closing, 0 at rest, increasing (for opening: the widening)
};

/// The controls that close and widen one eye of a model.
struct LidControls {
  LidTravel close;
  LidTravel widen;
};

/// Finds the controls that close the lids of each eye, by what they move and never by name: the one that does so while
/// it moves other parts of the model least, and more if that one is not enough. An eye that no control can close by
/// half has none. One entry an eye.
[[nodiscard]] std::vector<LidControls> find_lid_controls(const rig::Rig& rig, std::span<const double> rest,
                                                         std::span<const std::size_t> free, const Transfer& transfer,
                                                         std::span<const EyeCurves> eyes,
                                                         const geometry::Camera& camera);

/// Those of `free` that move lids and few other tracked points. The remaining ones are solved from the other curves.
[[nodiscard]] std::vector<std::size_t> without_lid_controls(const rig::Rig& rig, std::span<const double> rest,
                                                            std::span<const std::size_t> free, const Transfer& transfer,
                                                            std::span<const EyeCurves> eyes,
                                                            const geometry::Camera& camera);

/// Sets the controls of the eyes: `closed` one an eye as in EyeMotion. Controls of several eyes take the mean.
void set_lids(const rig::Rig& rig, std::span<const LidControls> controls, std::span<const double> closed,
              std::span<double> pose);

}  // namespace penpose::animation
