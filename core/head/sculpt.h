#pragma once

#include "core/head/cage.h"

namespace penpose::head {

/// Gives the bare half its forms: brow ridge, sockets, cheeks, muzzle, chin. A point moves by a sum of smooth fields,
/// each of which looks at the bare position and its loops only.
[[nodiscard]] ModelPoint carved(const ModelPoint& bare, const LoopMark& mark);
/// Draws the brow: vertices around it slide together until it is slim and pointed, and its own rise a little.
[[nodiscard]] ModelPoint with_brow(const ModelPoint& carved, const LoopMark& mark);

/// Height of the middle of the brow at x.
[[nodiscard]] double brow_line(double x);

}  // namespace penpose::head
