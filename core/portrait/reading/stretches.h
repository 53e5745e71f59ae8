#pragma once

#include <array>
#include <deque>
#include <map>

#include "core/portrait/face_view.h"

namespace penpose::portrait {

/// The stretches of curves that lines of a drawing are taken for: those of the face first, in its order, then finer
/// ones as they are asked for.
class Stretches {
 public:
  explicit Stretches(const FaceView& face) : face_(face), all_(face.stretches().begin(), face.stretches().end()) {}

  [[nodiscard]] const Stretch& operator[](std::size_t number) const { return all_[number]; }
  [[nodiscard]] std::size_t size() const { return all_.size(); }
  /// The number of a stretch that ends within 1/48 of these shares of the curve's length; at least a sixth of it.
  [[nodiscard]] std::size_t near(std::size_t curve, double from, double to);

 private:
  const FaceView& face_;
  std::deque<Stretch> all_;
  std::map<std::array<std::size_t, 3>, std::size_t> finer_;
};

/// The share of a line's points at which it is nearest to a point.
[[nodiscard]] double share_nearest(const Trace& line, PxPoint p);

}  // namespace penpose::portrait
