#pragma once

#include <memory>
#include <span>

#include "core/character/character.h"
#include "core/intent/live.h"

namespace penpose::character {

/// The pose that follows a target while it is being drawn: a preview, as the window shows it. It changes no character;
/// Character::draw_target with the whole line has the last word. What it was begun on may go away meanwhile.
class LiveTarget {
 public:
  /// Errors: no such reference, a view that cannot be or does not see it, nothing that is free to move.
  [[nodiscard]] static base::Result<LiveTarget> begin(Character& character, CurveId curve, const View& view);

  /// The line so far, all of it since the pen went down. True when the pose moved.
  bool follow(std::span<const PxPoint> line) { return poser_.follow(line).solved; }
  [[nodiscard]] const rig::Pose& pose() const { return poser_.pose(); }

 private:
  LiveTarget(std::shared_ptr<const document::Model> model, intent::LivePoser poser)
      : model_(std::move(model)), poser_(std::move(poser)) {}

  std::shared_ptr<const document::Model> model_;  ///< keeps the rig alive
  intent::LivePoser poser_;
};

}  // namespace penpose::character
