#include "core/head/sculpt.h"

#include <cmath>

namespace penpose::head {
namespace {

double square(double v) { return v * v; }

/// An ellipse in the front view: 1 in its middle, 0 on its edge.
double blob(const ModelPoint& p, double x, double y, double radius_x, double radius_y) {
  return bump(square((p.x - x) / radius_x) + square((p.y - y) / radius_y));
}

ModelVector face(const ModelPoint& p) {
  ModelVector move{0};
  // Sockets, nose side.
  move.z -= 0.35 * blob(p, 1.75, 0.6, 1.2, 1.9);
  // The ridge of the brows, broad and low.
  move.z += 0.35 * ramp(0.0, 1.4, p.x) * ramp(6.6, 4.0, p.x) * bump(square((p.y - brow_line(p.x) + 0.3) / 2.0));
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

/// How far the rows beside the brows' line are drawn towards it: 0 not at all, 1 onto it.
double pinch_of_brow(double x) {
  // No steep change beside the inner end: rows that part there stand as creases when the brow moves.
  return profile({{0.0, 0.42},
                  {0.5, 0.46},
                  {0.9, 0.54},
                  {1.4, 0.5},
                  {2.0, 0.42},
                  {3.4, 0.42},
                  {4.6, 0.65},
                  {5.3, 0.88},
                  {5.7, 0.86},
                  {6.1, 0.35},
                  {6.5, 0}},
                 x);
}

/// How much of the field of the face a vertex follows: lids and skull do not.
double in_face(const ModelPoint& p, const LoopMark& mark) {
  return mark.z > 1 ? 0 : ramp(0.5, 4.0, p.z) * ramp(2.2, 4.0, mark.x);
}

}  // namespace

double brow_line(double x) {
  return profile({{0.8, 2.83}, {1.6, 2.9}, {2.4, 3.14}, {3.4, 3.24}, {4.4, 3.04}, {5.0, 2.8}, {5.6, 2.45}}, x);
}

ModelPoint carved(const ModelPoint& bare, const LoopMark& mark) {
  const double off_plane = bare.x == 0 ? 0 : 1;
  return bare + face(bare) * ModelVector{off_plane, 1, 1} * in_face(bare, mark);
}

ModelPoint with_brow(const ModelPoint& p, const LoopMark& mark) {
  // Thinner than the control rows, with a pointed tail. Vertices slide along the face.
  const double line = brow_line(p.x);
  const double pinch = pinch_of_brow(p.x);
  const double off = p.y - line;
  const double share = in_face(p, mark);
  const double slide = -off * pinch * (off > 0 ? ramp(3.2, 0.75, off) : ramp(1.7, 0.7, -off)) * share;
  if (slide == 0 && (off > 1 || off < -1)) return p;
  ModelPoint moved{p.x, p.y + slide, p.z + bare_depth(p.x, p.y + slide) - bare_depth(p.x, p.y)};
  const double begins = ramp(0.35, 1.7, p.x);
  moved.z += 0.1 * share * begins * ramp(5.8, 4.9, p.x) * bump(square((moved.y - line) / 0.6));
  return moved;
}

}  // namespace penpose::head
