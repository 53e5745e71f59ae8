#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/geometry/camera.h"
#include "core/posing/problem.h"

namespace penpose::posing {

struct LiveOptions {
  std::size_t max_evaluations = 300;      ///< of the simplex, for each report: the budget that bounds a step
  std::size_t max_finish_iterations = 3;  ///< for linear rigs, for each report
  double near_weight = 1e-4;              ///< as SolveOptions
  double relevance = 1e-5;                ///< as SolveOptions
};

struct LiveSetup {
  std::vector<CurvePoint> reference;  ///< in its order along the curve, at least two points
  std::vector<Constraint> constraints;
  std::vector<std::size_t> free;  ///< ascending
  rig::Pose start;
  geometry::Camera camera;  ///< through which the target is drawn; does not move meanwhile
  LiveOptions options;
};

/// What one pen report did.
struct LiveStep {
  std::size_t matched = 0;  ///< reference points that have a target so far
  std::size_t evaluations = 0;
  double energy = 0;  ///< of the matched points and the constraints, model units
};

/// Live posing (method, section 2): while a target is being drawn, its drawn part of length L is matched with the first
/// L of the reference (lengths in px on the image plane), and the pose is solved again from the last solution at every
/// pen report. A target longer than the reference is matched as a whole. A step never takes more than its budget of
/// evaluations, so that the face follows the pen; when the pen lifts, `solve` with the whole target has the last word.
class LivePoser {
 public:
  /// Errors: those of check_problem; a reference behind the camera or of no length in this view. The rig must outlive
  /// it.
  static base::Result<LivePoser> start(const rig::Rig& rig, LiveSetup setup);
  ~LivePoser();
  LivePoser(LivePoser&&) noexcept;
  LivePoser& operator=(LivePoser&&) noexcept;

  /// The target as drawn so far, all samples since pen-down. Call it for each report, or for each frame; reports left
  /// out are not missed. With fewer than two distinct samples nothing moves.
  LiveStep follow(std::span<const geometry::PxPoint> target);
  /// The same for a target that is there as a whole and is being changed: where each reference point should go. Weights
  /// are one a point, or none for 1 everywhere; other numbers move nothing.
  LiveStep follow_points(std::span<const geometry::ModelPoint> targets, std::span<const double> weights = {});

  /// All parameters of the rig, as solved by the last step.
  [[nodiscard]] const rig::Pose& pose() const;
  [[nodiscard]] std::size_t variables() const;

 private:
  struct State;
  explicit LivePoser(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace penpose::posing
