#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace penpose::judges {

[[nodiscard]] inline bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Whether a parameter is the angle of a joint: "jaw.rx".
[[nodiscard]] inline bool is_angle(const std::string& parameter) {
  const std::size_t size = parameter.size();
  return size > 3 && parameter.compare(size - 3, 2, ".r") == 0 && parameter[size - 1] >= 'x' &&
         parameter[size - 1] <= 'z';
}

/// The joint of an angle, or the parameter itself.
[[nodiscard]] inline std::string control_of(const std::string& parameter) {
  return is_angle(parameter) ? parameter.substr(0, parameter.size() - 3) : parameter;
}

}  // namespace penpose::judges
