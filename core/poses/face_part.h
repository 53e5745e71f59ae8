#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace penpose::poses {

/// A part of a face; `all` of them.
enum class FacePart : std::uint8_t { all, brows, eyes, mouth };

/// The part that a feature curve is of, by its name; none: the nose and what is not known.
[[nodiscard]] std::optional<FacePart> part_of_feature(std::string_view feature);

/// "all", "brows", "eyes", "mouth".
[[nodiscard]] std::string_view name_of(FacePart part);
[[nodiscard]] std::optional<FacePart> part_named(std::string_view name);

}  // namespace penpose::poses
