#pragma once

#include <memory>
#include <optional>
#include <span>

#include "core/document/document.h"
#include "core/drawing/tool.h"
#include "core/posing/live_pose.h"

namespace penpose::app {

/// What the face does while a stroke is being drawn: a preview alone, made anew for every stroke; the command that the
/// stroke becomes has the last word.
class LiveFollow {
 public:
  /// A stroke began. Nothing follows when it means no target.
  void begin(const document::Document& document, const drawing::Tool& tool, const document::View& view,
             const curve::Stroke& stroke);
  /// The stroke so far. True when the pose moved.
  bool follow(const curve::Stroke& stroke);
  void end();

  [[nodiscard]] bool active() const { return poser_.has_value(); }
  /// The pose to show; precondition: active.
  [[nodiscard]] const rig::Pose& pose() const { return poser_->pose(); }
  [[nodiscard]] document::CurveId curve() const { return curve_; }

 private:
  std::shared_ptr<const document::Model> model_;  ///< keeps the rig alive, whatever is undone meanwhile
  document::CurveId curve_;
  std::optional<document::DrawnTarget> over_;  ///< oversketch: the target, as a line of this view
  std::optional<posing::LivePoser> poser_;
};

}  // namespace penpose::app
