#pragma once

#include <cstddef>
#include <string>

namespace penpose::film {

/// The file of picture `number` (from 1) of a sequence, as Blender names it: the number with leading zeros, four digits
/// or as many as `pattern` has # at its end, before the extension .png.
[[nodiscard]] std::string frame_name(const std::string& pattern, std::size_t number);

}  // namespace penpose::film
