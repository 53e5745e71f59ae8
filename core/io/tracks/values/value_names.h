#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace penpose::io {

/// Whether a name, whatever its case and separators, is that of one of ARKit's 52 blend shapes.
[[nodiscard]] bool is_arkit_shape(std::string_view name);

/// The names of a take without what is none of the name: a prefix ("blendShapes.") behind which one of ARKit's shapes
/// or turns stands, or that more than half of the names share.
[[nodiscard]] std::vector<std::string> plain_names(const std::vector<std::string_view>& names);

}  // namespace penpose::io
