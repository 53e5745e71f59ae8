#pragma once

#include <array>

namespace penpose::io {

/// The 52 blend shapes of ARKit (ARFaceAnchor.BlendShapeLocation), spelt and in the order of Live Link Face's CSV,
/// which has right before left for the jaw's and the mouth's sideways shapes.
extern const std::array<const char*, 52> k_arkit_shapes;

/// The columns that Live Link Face writes after them: turns of the head and the eyes, radians.
extern const std::array<const char*, 9> k_arkit_turns;

}  // namespace penpose::io
