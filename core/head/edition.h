#pragma once

#include <cstdint>

namespace penpose::head {

/// The second has lower teeth and a tongue, which hang on the floor of the mouth and go along with a jaw, and its mouth
/// and nostrils are dark inside. The third has nostrils that are seen from the front, brows that lie on the skin and
/// run out at both ends, no crease from brow to hair, and lips that are dark behind where they meet. Older ones stay as
/// they were for sessions that were drawn on them.
enum class HeadEdition : std::uint8_t { first, second, third };

}  // namespace penpose::head
