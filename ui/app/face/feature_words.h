#pragma once

#include <string>
#include <string_view>

namespace penpose::app {

/// What a feature is called in the window: "left upper eyelid" for eyelid_upper_L.
[[nodiscard]] std::string feature_words(std::string_view name);

}  // namespace penpose::app
