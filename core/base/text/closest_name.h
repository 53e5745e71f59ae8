#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace penpose::base {

/// The name that somebody probably meant: fewest letters to change, add, drop or swap with a neighbour (optimal string
/// alignment), capitals counting little. Nothing when even the closest differs in more than half of its letters.
[[nodiscard]] std::optional<std::string> closest_name(std::string_view given, std::span<const std::string> names);

}  // namespace penpose::base
