#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/portrait/proportions.h"

namespace penpose::portrait {

/// For each curve one that people draw wherever they draw it: a brow and an upper lid are drawn on both sides, a lower
/// lid below an upper one, the upper border of the lips with the lower one. None for what is drawn alone, as the line
/// between the lips is. `curves`: points in the picture, px, y down.
[[nodiscard]] std::vector<std::optional<std::size_t>> companions_of(
    std::span<const std::vector<geometry::PxPoint>> curves, std::span<const Part> parts);

/// The two borders of the opening of the mouth, the upper one first: one line where the lips are shut. None where a
/// model has fewer than four curves of lips.
[[nodiscard]] std::optional<std::array<std::size_t, 2>> parting_of(
    std::span<const std::vector<geometry::PxPoint>> curves, std::span<const Part> parts);

}  // namespace penpose::portrait
