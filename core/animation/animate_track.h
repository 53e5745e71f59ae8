#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/animation/face/lids.h"
#include "core/animation/face/rest_choice.h"
#include "core/animation/solve/frame_solver.h"

namespace penpose::animation {

/// A control that an action unit of the track tells of.
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
  std::optional<std::size_t> neutral;  ///< a frame; by default as choose_rest says, else the first that shows a face
  double least_confidence = 0.2;       ///< frames below show no face
  /// How far points shake, px of the track (`denoise`); by default 1, or less where the face is smaller than 320 px.
  std::optional<double> tremor_px;
  std::vector<UnitControl> units;  ///< what action units say, as evidence beside the curves; linear rigs alone take it
  double unit_weight = 0.02;       ///< of it, in the unit of FrameOptions::near_last
  double smooth_s = 0;             ///< as smooth_over_time, for parameters and the head's turn
  std::vector<std::uint32_t> components;  ///< of the mesh, one a vertex, to know eyeballs by; or none
  FrameOptions frame;                     ///< but for its tremor_px, which follows from the above
};

/// What came out: one entry a frame of the track.
struct TrackedAnimation {
  std::vector<double> times_s;
  std::vector<rig::Pose> poses;
  std::vector<std::size_t> held;   ///< frames that show no face and keep the pose before
  StillTrack still;                ///< the head's turns, and what is left without them
  Transfer transfer;               ///< which point of the track drives which of the model
  std::size_t variables = 0;       ///< parameters in the search
  std::optional<RestChoice> rest;  ///< where it was chosen from the clip
  EyeMotion eyes;                  ///< what the eyes do, where the curves have lids
  std::size_t gaze_controls = 0;   ///< how many controls the gaze drives
};

/// Called around the solving of each frame, before (false) and after (true), for a clock and a progress bar.
using FrameWatch = std::function<void(bool done)>;

/// Animation from tracked curves (method, section 4): takes the head's motion out, steadies the curves, brings them to
/// the image plane of `camera` and solves the frames in order. The rig must outlive the call. Errors: those of
/// take_head_motion_out, make_transfer and FrameSolver::make.
[[nodiscard]] base::Result<TrackedAnimation> animate_track(const rig::Rig& rig, const PointTrack& track,
                                                           const TrackSetup& setup, const geometry::Camera& camera,
                                                           const FrameWatch& watch = {});

}  // namespace penpose::animation
