#pragma once

#include <span>
#include <vector>

#include "core/animation/points/curve_transfer.h"
#include "core/base/hidden.h"
#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "core/rig/rig.h"

namespace penpose::animation {

struct FrameOptions {
  std::size_t max_evaluations = 300;  ///< of the simplex, a frame; 100 a variable where the rig is not linear, if more
  std::size_t max_finish_iterations = 6;
  /// How strongly parameters are pulled to the frame before and to rest, as shares of the energy of moving every point
  /// by a tenth of the curves' extent, for a parameter that moves through its whole range. For linear rigs, near_rest
  /// is not squared: leaving rest costs in proportion to the distance, times how much of the whole model a control
  /// moves for what it moves of the curves (relative to the usual), so that few controls leave it.
  double near_last = 1e-3;
  double near_rest = 4e-3;
  double relevance = 1e-5;  ///< as posing::SolveOptions
  /// The tremor of points, px of the track: distances below it count as squares. A sum of plain distances would follow
  /// a few points closely, different ones in each frame, and the tremor of a single point would cause a jump.
  double tremor_px = 0;
};

/// Evidence for a parameter from another source than the curves.
struct Evidence {
  std::size_t parameter = 0;
  double value = 0;
  double weight = 0;  ///< in the unit of FrameOptions::near_last
};

/// Two parameters that undo each other on the curves.
struct OpposedParameters {
  std::size_t a = 0;
  std::size_t b = 0;
  double ratio = 1;  ///< b's movement over its range as a multiple of a's
};

/// Cancels the opposing parts of both controls, so that at most one of them is away from rest; the curves stay as they
/// are.
void take_apart(const rig::Rig& rig, std::span<const double> rest, std::span<const OpposedParameters> opposed,
                std::span<double> pose);

/// Finds the poses of frames in order, each starting from the last (method, section 4). The targets are points of the
/// image plane, lifted to where the model's points are in the pose before; for rigs that are linear in all parameters
/// that may move only the distance across the line of sight counts, which no longer depends on that pose.
class FrameSolver {
 public:
  /// Errors: those of posing::check_problem. The rig must outlive it. `free`: ascending.
  static base::Result<FrameSolver> make(const rig::Rig& rig, Transfer transfer, std::vector<std::size_t> free,
                                        rig::Pose rest, const geometry::Camera& camera, const FrameOptions& options);

  /// Solves a frame with a face, given its offsets, the doubt about its head (StillTrack), and its trust, 0..1. A frame
  /// of little trust moves little.
  const rig::Pose& follow(std::span<const PxPoint> offsets, double doubt, double confidence,
                          std::span<const Evidence> evidence = {});

  [[nodiscard]] const rig::Pose& pose() const;
  /// Indices of the parameters in the search, ascending.
  [[nodiscard]] std::span<const std::size_t> parameters() const;
  [[nodiscard]] std::span<const OpposedParameters> opposed() const;

 private:
  struct State;
  explicit FrameSolver(base::Hidden<State> state);
  base::Hidden<State> state_;
};

}  // namespace penpose::animation
