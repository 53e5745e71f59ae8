#pragma once

#include <memory>
#include <span>

#include "core/base/result.h"
#include "core/intent/model/whole_model.h"
#include "core/intent/problem.h"

namespace penpose::intent {

/// What one pen report did.
struct LiveStep {
  bool solved = false;
  std::size_t evaluations = 0;
};

/// Follows a target that is still being drawn or changed, by the energy of `solve`. Each report looks once at the
/// curves as the last solution posed them and chooses from the controls of the last choice on, so that a step costs
/// little and the face does not flicker between readings that are equally good. When the pen lifts, `solve` with the
/// whole target has the last word.
class LivePoser {
 public:
  /// `problem.drawn.front()` is the curve whose target is drawn; its line is not read and may be empty. Others, known
  /// and kept curves hold what they hold. Errors: those of check_problem. The rig must outlive it.
  static base::Result<LivePoser> start(const rig::Rig& rig, WholeModel whole, IntentProblem problem);
  ~LivePoser();
  LivePoser(LivePoser&&) noexcept;
  LivePoser& operator=(LivePoser&&) noexcept;

  /// The target as drawn so far, all samples since pen-down: a line shorter than the reference belongs to its beginning
  /// (or its end, where it was begun there). Reports left out are not missed. With fewer than two distinct samples
  /// nothing moves.
  LiveStep follow(std::span<const PxPoint> line);
  /// A target that is there as a whole and is being changed.
  LiveStep follow_whole(std::span<const PxPoint> line);

  [[nodiscard]] const rig::Pose& pose() const;
  /// Parameters that move the curves.
  [[nodiscard]] std::size_t variables() const;

 private:
  struct State;
  explicit LivePoser(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace penpose::intent
