#include "ui/cli/number_range.h"

#include "core/base/numbers.h"

namespace penpose::cli {

Check number_range(double low, double high) {
  return [low, high](const std::string& text) -> std::string {
    const auto value = base::parse_double(text);
    if (value && *value >= low && *value <= high) return {};
    return "write a number from " + base::format_double(low) + " to " + base::format_double(high) + ", not \"" + text +
           "\"";
  };
}

Check whole_range(std::int64_t low, std::int64_t high) {
  return [low, high](const std::string& text) -> std::string {
    const auto value = base::parse_int(text);
    if (value && *value >= low && *value <= high) return {};
    return "write a whole number from " + std::to_string(low) + " to " + std::to_string(high) + ", not \"" + text +
           "\"";
  };
}

}  // namespace penpose::cli
