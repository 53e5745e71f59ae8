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

/// A control that turns an eyeball, whatever it is called and however it does so (a shape, a joint).
struct GazeControl {
  std::size_t parameter = 0;
  Gaze a_unit;  ///< how far the eye turns for each unit of it
};

/// Finds by what they move the controls that turn the eyeball of each eye: a piece of the mesh of its own
/// (`components`: one a vertex, triangle_mesh.h) near the eye's lids that goes round as a whole, while most of the
/// model stays. Where nothing does so, ARKit's eyeLook shapes by their names, which are taken to look 30 degrees at
/// their full. One list an eye; a control that turns both eyes is in both.
[[nodiscard]] std::vector<std::vector<GazeControl>> find_gaze_controls(const rig::Rig& rig,
                                                                       std::span<const double> rest,
                                                                       std::span<const std::uint32_t> components,
                                                                       const Transfer& transfer,
                                                                       std::span<const EyeCurves> eyes);

/// Where the eyes look, frame by frame, one list an eye (the picture's left one first): by the tracker's own word, or
/// from the irises where the track has those. Steadied, through blinks (`closed`: as EyeMotion, or none) straight on.
/// Empty: nothing is known of it.
[[nodiscard]] std::vector<std::vector<Gaze>> gaze_of(const PointTrack& track, const StillTrack& still,
                                                     std::span<const std::vector<double>> closed);

/// Sets the controls so that the eye looks there, as far as they go: the least squares of what is left.
void look(const rig::Rig& rig, std::span<const double> rest, std::span<const GazeControl> controls, const Gaze& gaze,
          std::span<double> pose);

}  // namespace penpose::animation
