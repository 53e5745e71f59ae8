#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/animation/face/lids.h"
#include "core/animation/head/head_motion.h"
#include "core/animation/points/curve_transfer.h"
#include "core/animation/track.h"
#include "core/geometry/camera.h"
#include "core/rig/rig.h"

namespace penpose::animation {

/// A control that turns an eyeball, whatever its name and kind (a shape, a joint).
struct GazeControl {
  std::size_t parameter = 0;
  Gaze a_unit;  ///< how far the eye turns for each unit of it
};

/// Finds the controls that turn the eyeball of each eye, by what they move: a separate piece of the mesh (`components`:
/// one a vertex, triangle_mesh.h) near the eye's lids that rotates as a whole, while most of the model stays. If there
/// are none, ARKit's eyeLook shapes by their names, assumed to look 30 degrees at their maximum. One list an eye; a
/// control that turns both eyes is in both.
[[nodiscard]] std::vector<std::vector<GazeControl>> find_gaze_controls(const rig::Rig& rig,
                                                                       std::span<const double> rest,
                                                                       std::span<const std::uint32_t> components,
                                                                       const Transfer& transfer,
                                                                       std::span<const EyeCurves> eyes);

/// Where the eyes look, frame by frame, one list an eye (the picture's left one first): from the tracker's own gaze, or
/// from the irises if the track has them. Denoised, and interpolated during blinks (`closed`: as EyeMotion, or none).
/// Empty: unknown.
[[nodiscard]] std::vector<std::vector<Gaze>> gaze_of(const PointTrack& track, const StillTrack& still,
                                                     std::span<const std::vector<double>> closed);

/// Sets the controls so that the eye looks there as nearly as they can, by least squares.
void look(const rig::Rig& rig, std::span<const double> rest, std::span<const GazeControl> controls, const Gaze& gaze,
          std::span<double> pose);

}  // namespace penpose::animation
