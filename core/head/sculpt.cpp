#include "core/head/sculpt.h"

#include <cmath>

namespace penpose::head {
namespace {

double square(double v) { return v * v; }

/// An ellipse in the front view: 1 in its middle, 0 on its edge.
double blob(const ModelPoint& p, double x, double y, double radius_x, double radius_y) {
  return bump(square((p.x - x) / radius_x) + square((p.y - y) / radius_y));
}

ModelVector nose(const ModelPoint& p) {
  ModelVector move{0};
  const double height = profile({{-5.0, 0}, {-4.7, 0.2}, {-4.35, 0.95}, {-4.0, 2.0}, {-3.6, 2.62}, {-3.1, 2.68}, {-2.3, 2.15}, {-1.2, 1.45},
                                 {0, 0.8}, {1.2, 0.3}, {2.4, 0.1}, {3.2, 0}}, p.y);
  const double width = profile({{-4.6, 1.5}, {-3.4, 1.6}, {-2.4, 1.5}, {-1, 1.35}, {0.4, 1.3}, {2.2, 1.9}}, p.y);
  const double across = square(p.x / width);
  move.z += height * bump(across * (0.65 + 0.35 * across));
  // Wings.
  const double wing = blob(p, 1.1, -3.75, 0.8, 0.75);
  move += ModelVector{0.22, 0.0, 0.75} * wing;
  // Tip.
  move.z += 0.25 * blob(p, 0, -3.3, 0.85, 0.8);
  // Nostrils.
  move += ModelVector{0, 0.28, -0.35} * blob(p, 0.58, -4.25, 0.42, 0.38);
  return move;
}

ModelVector brow(const ModelPoint& p) {
  ModelVector move{0};
  const double line = profile({{0.6, 2.3}, {1.6, 2.75}, {3.2, 3.25}, {4.4, 3.1}, {5.6, 2.45}}, p.x);
  const double thick = profile({{0.4, 0.2}, {0.9, 0.62}, {2.4, 0.68}, {4.2, 0.5}, {5.7, 0.2}}, p.x);
  const double ends = ramp(0.35, 0.95, p.x) * ramp(6.0, 5.0, p.x);
  move.z += 0.42 * ends * bump(square((p.y - line) / thick) * 0.8);
  // The ridge beneath, broad and low.
  move.z += 0.35 * ramp(0.0, 1.2, p.x) * ramp(6.4, 4.0, p.x) * bump(square((p.y - line + 0.3) / 1.9));
  return move;
}

ModelVector face(const ModelPoint& p) {
  ModelVector move{0};
  // Sockets, nose side.
  move.z -= 0.5 * blob(p, 1.75, 0.3, 1.1, 1.9);
  // Cheeks.
  move += ModelVector{0.18, 0.05, 0.55} * blob(p, 4.0, -3.3, 2.3, 2.3);
  // Beside the nose and mouth, the fold to the cheek.
  move.z -= 0.18 * blob(p, 2.6, -4.9, 0.9, 1.6);
  // Muzzle.
  move.z += 0.42 * blob(p, 0, -6.2, 3.6, 2.9);
  // Philtrum.
  move.z -= 0.14 * blob(p, 0, -5.05, 0.36, 0.75);
  // Fold under the lower lip, and the chin.
  move.z -= 0.42 * blob(p, 0, -8.15, 2.0, 0.85);
  move += ModelVector{0, 0, 0.75} * blob(p, 0, -9.6, 2.3, 1.6);
  // Hollow below the cheekbones, temples.
  move -= ModelVector{0.28, 0, 0.15} * blob(p, 5.6, -5.6, 2.0, 2.6);
  move.x -= 0.25 * bump(square((p.y - 2.4) / 2.6) + square((p.z - 4.2) / 3.0)) * ramp(4.5, 6.0, p.x);
  return move;
}

}  // namespace

ModelPoint sculpted(const ModelPoint& bare, const LoopMark& mark) {
  const double front = ramp(0.5, 4.0, bare.z);
  const double off_eye = ramp(2.2, 4.0, mark.x);
  const double in_mouth = ramp(0.0, -2.0, mark.y);
  const double ear = ramp(0.5, 1.5, mark.z);
  ModelVector move = nose(bare) * (1 - in_mouth) + brow(bare) + face(bare);
  move *= front * off_eye * (1 - ear);
  if (mark.z > 1) move = {0, 0, 0};
  return bare + move;
}

}  // namespace penpose::head
