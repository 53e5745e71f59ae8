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
  const double height = profile({{-5.0, 0}, {-4.75, 0.1}, {-4.45, 0.5}, {-4.15, 1.5}, {-3.8, 2.2}, {-3.3, 2.4}, {-2.6, 2.1},
                                 {-1.2, 1.25}, {0, 0.72}, {1.2, 0.35}, {2.4, 0.15}, {3.4, 0}},
                                p.y);
  const double width =
      profile({{-4.6, 1.35}, {-3.4, 1.5}, {-2.4, 1.5}, {-1, 1.4}, {0.4, 1.35}, {1.6, 1.7}, {2.6, 2.6}}, p.y);
  const double across = square(p.x / width);
  ModelVector move{0, 0, height * bump(across * (0.55 + 0.45 * across))};
  // Tip, a ball that lifts a little.
  move += ModelVector{0, 0.15, 0.6} * blob(p, 0, -3.45, 1.15, 1.1);
  // Wings.
  move += ModelVector{0.25, 0.05, 0.85} * blob(p, 1.12, -3.8, 0.8, 0.8);
  // Nostrils.
  move += ModelVector{0, 0.45, -0.6} * blob(p, 0.62, -4.3, 0.55, 0.5);
  return move;
}

ModelVector brow(const ModelPoint& p) {
  const double line = profile({{0.8, 2.83}, {1.6, 2.9}, {2.4, 3.14}, {3.4, 3.24}, {4.4, 3.04}, {5.0, 2.8}, {5.6, 2.45}}, p.x);
  ModelVector move{0};
  // Thinner than the control rows, with a pointed tail.
  const double pinch =
      profile({{0.6, 0.6}, {1.0, 0.5}, {2.0, 0.4}, {3.4, 0.42}, {4.6, 0.65}, {5.3, 0.9}, {5.7, 0.96}, {6.4, 0.5}, {7.2, 0}}, p.x);
  const double off = p.y - line;
  move.y -= off * pinch * (off > 0 ? ramp(3.2, 0.75, off) : ramp(1.7, 0.7, -off));
  move.z += 0.28 * ramp(0.5, 1.2, p.x) * ramp(5.9, 5.2, p.x) * bump(square(off / 0.75));
  // The ridge beneath, broad and low.
  move.z += 0.35 * ramp(0.0, 1.4, p.x) * ramp(6.6, 4.0, p.x) * bump(square((p.y - line + 0.3) / 2.0));
  return move;
}

ModelVector face(const ModelPoint& p) {
  ModelVector move{0};
  // Sockets, nose side.
  move.z -= 0.35 * blob(p, 1.75, 0.6, 1.2, 1.9);
  // Cheeks.
  move += ModelVector{0.15, 0.05, 0.5} * blob(p, 3.8, -3.5, 3.2, 3.0);
  // Beside the nose and mouth, the fold to the cheek.
  move.z -= 0.12 * blob(p, 2.6, -5.0, 1.1, 1.8);
  // Muzzle.
  move.z += 0.5 * blob(p, 0, -6.3, 3.8, 3.0);
  // Philtrum.
  move.z -= 0.12 * blob(p, 0, -5.05, 0.4, 0.85);
  // Fold under the lower lip, and the chin.
  move.z -= 0.25 * blob(p, 0, -8.15, 2.0, 0.9);
  move += ModelVector{0, -0.1, 0.85} * blob(p, 0, -9.7, 2.5, 1.9);
  // Hollow below the cheekbones, temples.
  move -= ModelVector{0.1, 0, 0.0} * blob(p, 5.4, -5.6, 2.0, 2.6);
  move.x -= 0.25 * bump(square((p.y - 2.4) / 2.6) + square((p.z - 4.2) / 3.0)) * ramp(4.5, 6.0, p.x);
  return move;
}

}  // namespace

ModelPoint sculpted(const ModelPoint& bare, const LoopMark& mark) {
  if (mark.z > 1) return bare;
  const double front = ramp(0.5, 4.0, bare.z);
  const double off_eye = ramp(2.2, 4.0, mark.x);
  const double outside_mouth = ramp(-2.0, 0.0, mark.y);
  const ModelVector move = nose(bare) * outside_mouth + brow(bare) + face(bare);
  const double off_plane = bare.x == 0 ? 0 : 1;
  return bare + move * ModelVector{off_plane, 1, 1} * (front * off_eye);
}

}  // namespace penpose::head
