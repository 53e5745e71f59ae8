#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/animation/face/lids.h"
#include "core/animation/face/rest_choice.h"
#include "core/animation/solve/frame_solver.h"

namespace penpose::animation {

/// A control that an action unit of the track gives evidence for.
struct UnitControl {
  std::size_t unit = 0;  ///< number in PointTrack::unit_names
  std::size_t parameter = 0;
};

/// How a point track drives a rig.
struct TrackSetup {
  std::vector<TrackedCurve> curves;
  StablePoints points;
  std::vector<std::size_t> free;       ///< parameters that may move, ascending
  rig::Pose rest;                      ///< the pose of the neutral frame
  std::optional<std::size_t> neutral;  ///< a frame; by default from choose_rest, else the first that shows a face
  double least_confidence = 0.2;       ///< frames below this show no face
  /// How far points shake, px of the track (`denoise`); by default 1, or less where the face is smaller than 320 px.
  std::optional<double> tremor_px;
  std::vector<UnitControl> units;         ///< action units as evidence in addition to the curves; for linear rigs only
  double unit_weight = 0.02;              ///< of that evidence, in the unit of FrameOptions::near_last
  double smooth_s = 0;                    ///< as smooth_over_time, for parameters and the head's turn
  std::vector<std::uint32_t> components;  ///< of the mesh, one a vertex, to find eyeballs; or none
  FrameOptions frame;                     ///< tremor_px is ignored; it follows from the above
};

/// The result: one entry a frame of the track.
struct TrackedAnimation {
  std::vector<double> times_s;
  std::vector<rig::Pose> poses;
  std::vector<std::size_t> held;   ///< frames that show no face and keep the pose before
  StillTrack still;                ///< the head's turns, and the track without them
  Transfer transfer;               ///< which point of the track drives which point of the model
  std::size_t variables = 0;       ///< parameters in the search
  std::optional<RestChoice> rest;  ///< if it was chosen from the clip
  EyeMotion eyes;                  ///< motion of the eyes, if the curves have lids
  std::size_t gaze_controls = 0;   ///< how many controls the gaze drives
};

/// Called around the solving of each frame, before (false) and after (true), for a clock and a progress bar.
using FrameWatch = std::function<void(bool done)>;

/// Animation from tracked curves (method, section 4): removes the head's motion, denoises the curves, transfers them to
/// the image plane of `camera` and solves the frames in order. The rig must outlive the call. Errors: those of
/// take_head_motion_out, make_transfer and FrameSolver::make.
[[nodiscard]] base::Result<TrackedAnimation> animate_track(const rig::Rig& rig, const PointTrack& track,
                                                           const TrackSetup& setup, const geometry::Camera& camera,
                                                           const FrameWatch& watch = {});

}  // namespace penpose::animation
