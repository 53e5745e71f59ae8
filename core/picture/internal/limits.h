#pragma once

#include <cstdint>

namespace penpose::picture {

/// A file that unfolds to more px than these is not unpacked: these many always may, and so many for each byte.
inline constexpr std::uint64_t k_always_px = 10'000'000;
inline constexpr std::uint64_t k_px_of_byte = 400;

}  // namespace penpose::picture
