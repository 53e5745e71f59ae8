#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace penpose::cli {

/// A check of an option's text for CLI::Validator: a finite number from `low` to `high`. CLI::Range lets NaN pass.
[[nodiscard]] std::function<std::string(std::string&)> number_range(double low, double high);

/// The same for a whole number.
[[nodiscard]] std::function<std::string(std::string&)> whole_range(std::int64_t low, std::int64_t high);

}  // namespace penpose::cli
