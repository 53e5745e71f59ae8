#pragma once

#include <span>

#include "core/base/hidden.h"
#include "core/base/result.h"
#include "core/intent/model/whole_model.h"
#include "core/intent/problem.h"

namespace penpose::intent {

/// The effect of one pen report.
struct LiveStep {
  bool solved = false;
  std::size_t evaluations = 0;
};

/// Follows a target that is still being drawn or changed, by the energy of `solve`. Each report
/// linearises once at the last solution and starts from the controls chosen there, so that a step is cheap and the face
/// does not flicker between readings that are equally good. When the pen lifts, `solve` with the whole target decides.
class LivePoser {
 public:
  /// `problem.drawn.front()` is the curve whose target is being drawn; its line is not read and may be empty. All other
  /// curves keep their targets. Errors: those of check_problem. The rig must outlive it.
  static base::Result<LivePoser> start(const rig::Rig& rig, WholeModel whole, IntentProblem problem);

  /// The target as drawn so far, all samples since pen-down: a line shorter than the reference is matched with
  /// its beginning (or its end, if drawing started there). Reports may be left out. With fewer than two distinct
  /// samples nothing moves.
  LiveStep follow(std::span<const PxPoint> line);
  /// A complete target that is being changed. `stays`: points of the reference that the change does not touch
  /// (DrawnCurve::stays).
  LiveStep follow_whole(std::span<const PxPoint> line, const std::vector<bool>& stays = {});
  /// The curve is pulled as by a string, from where it is: its controls follow in small steps, from the first px on.
  /// `meant`: the line of a pull the same way that is long enough to tell which controls it means.
  LiveStep pull(std::span<const PxPoint> line, std::span<const PxPoint> meant, const std::vector<bool>& stays);

  [[nodiscard]] const rig::Pose& pose() const;
  /// Parameters that move the curves.
  [[nodiscard]] std::size_t variables() const;

 private:
  struct State;
  explicit LivePoser(base::Hidden<State> state);
  base::Hidden<State> state_;
};

}  // namespace penpose::intent
