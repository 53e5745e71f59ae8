#pragma once

#include "core/head/cage.h"

namespace penpose::head {

/// Gives the bare, subdivided half its features: brow ridge, sockets, nose, cheeks, lips, chin. A point moves by a sum
/// of smooth fields, each of which looks at the bare position and its loops only.
[[nodiscard]] ModelPoint sculpted(const ModelPoint& bare, const LoopMark& mark);

}  // namespace penpose::head
