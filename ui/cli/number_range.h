#pragma once

#include <functional>
#include <string>

namespace penpose::cli {

/// A check of an option's text for CLI::Validator: a finite number from `low` to `high`. CLI::Range lets NaN pass.
[[nodiscard]] std::function<std::string(std::string&)> number_range(double low, double high);

}  // namespace penpose::cli
