#pragma once

#include <cstdint>

namespace penpose::head {

/// The second has lower teeth and a tongue, which hang on the floor of the mouth and go along with a jaw, and its mouth
/// and nostrils are dark inside. The third has nostrils that are seen from the front, brows that lie on the skin and
/// run out at both ends, no crease from brow to hair, and lips that are dark behind where they meet. The fourth has
/// brows whose inner ends lie smoothly on the skin, so that no notch opens beside them when they are drawn together,
/// and lower teeth that are seen as a row. Older ones stay as they were for sessions that were drawn on them.
enum class HeadEdition : std::uint8_t { first, second, third, fourth };

}  // namespace penpose::head
