#include "ui/app/canvas/own_scale.h"

#include <algorithm>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"

namespace penpose::app {
namespace {

constexpr double k_least = 0.5, k_most = 4;
constexpr double k_scale_one_dpi = 96, k_least_dpi = 24, k_most_dpi = 768;

bool heeded(double scale) { return scale >= k_least && scale <= k_most; }

std::optional<double> number_of(const char* text) {
  return text == nullptr ? std::nullopt : base::parse_double(base::trim(text));
}

}  // namespace

double own_scale(const SystemScale& system) {
  if (const double text = system.text_dpi / k_scale_one_dpi; heeded(text)) return text;
  constexpr double k_chosen = 1.01;
  if (system.px_a_unit >= k_chosen && heeded(system.px_a_unit)) return system.px_a_unit;
  return heeded(system.toolkits) ? system.toolkits : 0;
}

std::optional<double> xft_dpi(std::string_view resources) {
  constexpr std::string_view k_name = "Xft.dpi:";
  std::optional<double> found;
  while (!resources.empty()) {
    const std::size_t end = std::min(resources.find('\n'), resources.size());
    const std::string_view line = base::trim(resources.substr(0, end));
    if (line.starts_with(k_name)) {
      const auto value = base::parse_double(base::trim(line.substr(k_name.size())));
      found = value && *value >= k_least_dpi && *value <= k_most_dpi ? value : std::nullopt;
    }
    resources.remove_prefix(std::min(end + 1, resources.size()));
  }
  return found;
}

double toolkit_scale(const char* whole, const char* part) {
  const auto a = number_of(whole);
  const auto b = number_of(part);
  return a || b ? a.value_or(1) * b.value_or(1) : 0;
}

}  // namespace penpose::app
