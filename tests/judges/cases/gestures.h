#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/project/case_file.h"
#include "tests/judges/cases/gesture_kinds.h"
#include "tests/judges/cases/picture.h"
#include "tests/judges/hands/hand.h"
#include "tests/judges/measures/measure.h"

namespace penpose::judges {

/// Lines as an artist bends them, which no pose of the rig meets exactly.
struct Gesture {
  io::PoseCase asked;
  std::string hand;
  std::vector<std::vector<std::string>> needed;  ///< of each group a control has to move; joints without ".rx"
  std::vector<std::string> accepted;             ///< controls that may help
  bool still_is_right = false;                   ///< nothing of the rig does what was drawn
};

/// Draws on a rig, seen from its front. Precondition: the rig has lines, and outlives it.
class GestureArtist {
 public:
  explicit GestureArtist(const Rig& rig);
  /// What a gesture asks of the rig, without its lines; nothing where no controls of the rig do it.
  [[nodiscard]] std::optional<Gesture> meant(const GestureKind& kind) const;
  /// Adds its lines. The same rig and name give the same lines.
  void draw(Gesture& gesture, const GestureKind& kind, const Hand& hand, std::string name) const;

 private:
  const Rig& rig_;
  std::vector<ModelPoint> rest_;
  Picture picture_;
  bool moves_brows_;
  PxPoint middle_;
  double half_ = 0;  ///< of the mouth's width, px
};

/// Smiles, frowns, mouths opened, narrowed, widened and aside, smirks, brows, winks and blinks, of those that the rig
/// has controls for. Precondition: the rig has lines.
[[nodiscard]] std::vector<Gesture> gestures(const Rig& rig, Extent extent);

}  // namespace penpose::judges
