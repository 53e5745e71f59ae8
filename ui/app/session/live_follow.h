#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/document/commands/command.h"
#include "core/document/document.h"
#include "core/drawing/tool.h"
#include "core/intent/live.h"
#include "core/posing/problem.h"

namespace penpose::app {

/// How a target is held: where, and how far along it the pull is felt (curve/bend.h).
struct PullHold {
  curve::PxPoint at;
  double reach = curve::k_usual_reach;
};

/// What of the model is pulled without any line drawn along it.
struct PulledPlace {
  std::vector<posing::CurvePoint> points;  ///< at least two, in order along a line of the model
  PullHold hold;
};

/// What the face does while a stroke is being drawn: a preview alone, made anew for every stroke; the command that the
/// stroke becomes has the last word.
class LiveFollow {
 public:
  /// A stroke began. Nothing follows when it means no target.
  void begin(const document::Document& document, const drawing::Tool& tool, const document::View& view,
             const curve::Stroke& stroke);
  /// The stroke so far. True when the pose moved.
  bool follow(const curve::Stroke& stroke);
  /// A target that is there is taken in hand, as this view shows it: all of it, or at a place. `string`: the curve is
  /// pulled from where the face has it, and its controls follow from the first px on.
  void begin_drag(const document::Document& document, document::CurveId curve, const document::View& view,
                  const std::optional<PullHold>& pull = std::nullopt, bool string = false);
  /// A place of the model is taken in hand, to be pulled as by a string. Drawn lines do not hold it back, constraints
  /// do; what is locked is as if it were not there. False: no free control moves it.
  bool begin_pull(const document::Document& document, const document::View& view, const PulledPlace& place);
  /// How far it was moved since, px of that view.
  bool drag(curve::PxPoint by);
  void end();

  /// What the controls of the document's rig do to the whole model; measured once for a rig.
  const intent::WholeModel& whole_of(const document::Document& document);

  [[nodiscard]] bool active() const { return poser_.has_value(); }
  /// The pose to show; precondition: active.
  [[nodiscard]] const rig::Pose& pose() const { return poser_->pose(); }
  [[nodiscard]] document::CurveId curve() const { return curve_; }
  /// While a target is drawn over: all of it as it would be; null otherwise.
  [[nodiscard]] const document::DrawnTarget* target() const { return target_ ? &*target_ : nullptr; }

 private:
  void start(const document::Document& document, const document::PoseCurve& curve, const document::View& view);
  bool follow_target(const base::Result<document::DrawnTarget>& target, const document::DrawnTarget& before);
  bool pull_string(curve::PxPoint by);

  std::shared_ptr<const document::Model> model_;  ///< keeps the rig alive, whatever is undone meanwhile
  document::CurveId curve_;
  std::optional<document::DrawnTarget> whole_;   ///< drag: the target, as a line of this view
  std::optional<PullHold> pull_;                 ///< drag: at a place, of the target
  std::optional<document::DrawnTarget> pulled_;  ///< as it was
  bool string_ = false;                          ///< drag: what is pulled is the curve
  std::optional<document::DrawnTarget> before_;  ///< oversketch: the target as it was
  std::optional<document::DrawnTarget> target_;  ///< and as it would be
  document::View view_;
  std::vector<geometry::ModelPoint> reference_;         ///< its points before the stroke
  std::shared_ptr<const rig::CharacterRig> whole_rig_;  ///< what whole_model_ was measured on
  intent::WholeModel whole_model_;
  std::optional<intent::LivePoser> poser_;
};

/// What dropping a target that was dragged by some px of a view means.
[[nodiscard]] document::Command drag_command(const document::PoseCurve& curve, const document::View& view,
                                             curve::PxPoint by, const std::optional<PullHold>& pull = std::nullopt);

}  // namespace penpose::app
