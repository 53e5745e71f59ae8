#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::app {

using geometry::PxPoint;

enum class FingerKind : std::uint8_t { down, move, up };

/// What fingers did. One finger is a pen; two turn (drag) and zoom (pinch); three pan.
struct TouchAct {
  enum class Kind : std::uint8_t { pen_down, pen_move, pen_up, orbit, pan, zoom };
  Kind kind = Kind::pen_move;
  PxPoint at;         ///< of the pen; for the others the middle of the fingers
  PxPoint by;         ///< px moved
  double factor = 1;  ///< zoom: distance between the fingers, before / after
};

/// Tells drawing with one finger from gestures with more. The first finger touches only when it has moved a little or
/// lifts again, because until then a second one may come.
class TouchGestures {
 public:
  /// `slack_px`: how far a finger moves before it draws.
  explicit TouchGestures(double slack_px = 8) : slack_px_(slack_px) {}

  std::vector<TouchAct> add(FingerKind kind, std::int64_t finger, PxPoint at);
  /// Nothing touches any more, whatever was missed.
  [[nodiscard]] std::vector<TouchAct> cancel();

 private:
  [[nodiscard]] PxPoint middle() const;
  [[nodiscard]] double spread() const;

  double slack_px_;
  std::map<std::int64_t, PxPoint> fingers_;
  std::optional<std::int64_t> waiting_;  ///< the finger that may become the pen
  PxPoint first_;                        ///< where it came down
  std::optional<std::int64_t> pen_;      ///< the finger that draws
  bool gesture_ = false;                 ///< until all fingers are up again
};

}  // namespace penpose::app
