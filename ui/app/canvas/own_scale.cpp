#include "ui/app/canvas/own_scale.h"

#include <algorithm>
#include <cmath>

#include "core/base/numbers.h"
#include "core/base/text/letters.h"

namespace penpose::app {
namespace {

constexpr double k_least = 0.5, k_most = 4;
constexpr double k_least_dpi = 24, k_most_dpi = 768;

bool heeded(double scale) { return scale >= k_least && scale <= k_most; }

std::optional<double> number_of(const char* text) {
  return text == nullptr ? std::nullopt : base::parse_double(base::trim(text));
}

}  // namespace

double own_scale(const SystemScale& system) {
  if (const double text = system.text_dpi / k_scale_one_dpi; heeded(text)) return text;
  constexpr double k_chosen = 1.01;
  if (system.px_a_unit >= k_chosen && heeded(system.px_a_unit)) return system.px_a_unit;
  if (heeded(system.toolkits)) return system.toolkits;
  // Servers say 96 or, as Xvfb does, 100 unless they are told otherwise, give or take a millimetre.
  constexpr double k_rounding_dpi = 6;
  const double server = system.server_dpi / k_scale_one_dpi;
  return heeded(server) && std::abs(system.server_dpi - k_scale_one_dpi) > k_rounding_dpi ? server : 0;
}

double dpi_of(int px, int millimetres) {
  constexpr double k_mm_per_inch = 25.4;
  return px > 0 && millimetres > 0 ? px * k_mm_per_inch / millimetres : 0;
}

int opened_px(int usual, double scale, int all) {
  // In quarters: displays of 90 or 100 dpi are ordinary ones.
  return std::min(all, static_cast<int>(std::lround(usual * (heeded(scale) ? std::round(4 * scale) / 4 : 1))));
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
