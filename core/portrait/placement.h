#pragma once

#include <span>
#include <vector>

#include "core/portrait/face_view.h"

namespace penpose::portrait {

/// Where the sheet lies on the face: face = along * sheet + across * (sheet turned by 90 degrees) + shift.
struct Placement {
  double along = 1, across = 0;
  PxPoint shift{0, 0};

  [[nodiscard]] PxPoint operator()(const PxPoint& p) const {
    return {along * p.x - across * p.y + shift.x, along * p.y + across * p.x + shift.y};
  }
  [[nodiscard]] Trace operator()(const Trace& trace) const;
  [[nodiscard]] double scale() const;
};

/// First guesses: the box of the drawing on boxes of parts of the face, by its diagonal, its width and its height.
[[nodiscard]] std::vector<Placement> first_placements(const FaceView& face, std::span<const Trace> lines);

/// A line of the drawing and where its points should be.
struct Match {
  Trace line{};
  Trace goal{};
  double weight = 1;  ///< of each of its points
};

/// The similarity that brings lines to their goals with the least weighted sum of distances (by repeated weighing of
/// least squares). `from`: what is returned where the lines have no extent.
[[nodiscard]] Placement placed(std::span<const Match> matches, const Placement& from);

}  // namespace penpose::portrait
