#include "ui/app/input/touch_gestures.h"

namespace penpose::app {

using Kind = TouchAct::Kind;

PxPoint TouchGestures::middle() const {
  PxPoint sum;
  for (const auto& [id, at] : fingers_) sum = sum + at;
  return fingers_.empty() ? sum : sum * (1.0 / static_cast<double>(fingers_.size()));
}

double TouchGestures::spread() const {
  double sum = 0;
  for (const auto& [id, at] : fingers_) sum += geometry::distance(at, middle());
  return sum;
}

std::vector<TouchAct> TouchGestures::cancel() {
  std::vector<TouchAct> acts;
  if (pen_) acts.push_back({Kind::pen_up, fingers_[*pen_], {}, 1});
  fingers_.clear();
  waiting_.reset();
  pen_.reset();
  gesture_ = false;
  return acts;
}

std::vector<TouchAct> TouchGestures::add(FingerKind kind, std::int64_t finger, PxPoint at) {
  std::vector<TouchAct> acts;
  if (kind == FingerKind::down) {
    fingers_[finger] = at;
    if (pen_) return acts;  // a palm that comes down while a finger draws
    if (fingers_.size() == 1 && !gesture_) {
      waiting_ = finger;
      first_ = at;
    } else {
      waiting_.reset();
      gesture_ = true;
    }
    return acts;
  }
  const auto found = fingers_.find(finger);
  if (found == fingers_.end()) return acts;
  const PxPoint middle_before = middle();
  const double spread_before = spread();
  found->second = at;
  if (waiting_ == finger) {
    if (kind == FingerKind::move && geometry::distance(first_, at) < slack_px_) return acts;
    waiting_.reset();
    pen_ = finger;
    acts.push_back({Kind::pen_down, first_, {}, 1});
  }
  if (pen_ == finger) {
    acts.push_back({Kind::pen_move, at, {}, 1});
    if (kind == FingerKind::up) {
      acts.push_back({Kind::pen_up, at, {}, 1});
      pen_.reset();
    }
  } else if (gesture_ && !pen_ && fingers_.size() >= 2) {
    const PxPoint by = middle() - middle_before;
    const double after = spread();
    if (fingers_.size() == 2 && spread_before > 1 && after > 1) {
      acts.push_back({Kind::zoom, middle(), {}, spread_before / after});
    }
    acts.push_back({fingers_.size() == 2 ? Kind::orbit : Kind::pan, middle(), by, 1});
  }
  if (kind == FingerKind::up) {
    fingers_.erase(finger);
    if (fingers_.empty()) gesture_ = false;
  }
  return acts;
}

}  // namespace penpose::app
