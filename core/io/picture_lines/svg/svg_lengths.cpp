#include "core/io/picture_lines/svg/internal/svg_lengths.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/io/picture_lines/svg/internal/number_scanner.h"

namespace penpose::io {
namespace {

constexpr std::array<std::pair<std::string_view, double>, 10> k_units{{{"", 1.0},
                                                                       {"px", 1.0},
                                                                       {"pt", 96.0 / 72},
                                                                       {"pc", 16.0},
                                                                       {"mm", 96.0 / 25.4},
                                                                       {"cm", 96.0 / 2.54},
                                                                       {"in", 96.0},
                                                                       {"em", 16.0},
                                                                       {"rem", 16.0},
                                                                       {"ex", 8.0}}};

}  // namespace

std::optional<double> parse_length(std::string_view text, double whole) {
  NumberScanner scanner(text);
  scanner.skip_blanks();
  const auto number = scanner.number();
  if (!number) return std::nullopt;
  const bool percent = scanner.take('%');
  const std::string_view unit = scanner.take_letters();
  scanner.skip_blanks();
  if (!scanner.at_end()) return std::nullopt;
  if (percent) return *number / 100 * whole;
  const auto known = std::find_if(k_units.begin(), k_units.end(), [&](const auto& one) { return one.first == unit; });
  if (known == k_units.end()) return std::nullopt;
  return *number * known->second;
}

std::optional<ViewBox> parse_view_box(std::string_view text) {
  NumberScanner scanner(text);
  std::array<double, 4> n{};
  scanner.skip_blanks();
  for (double& one : n) {
    const auto number = scanner.number();
    if (!number) return std::nullopt;
    one = *number;
    scanner.skip_separator();
  }
  if (!scanner.at_end() || !(n[2] > 0 && n[3] > 0)) return std::nullopt;
  return ViewBox{n[0], n[1], {n[2], n[3]}};
}

Affine fitted(const ViewBox& box, Viewport into, std::string_view preserve) {
  double x = into.width / box.size.width;
  double y = into.height / box.size.height;
  const auto says = [&](std::string_view word) { return preserve.find(word) != std::string_view::npos; };
  if (!says("none")) x = y = says("slice") ? std::max(x, y) : std::min(x, y);
  const auto share = [&](std::string_view least, std::string_view most) {
    return says(least) ? 0.0 : says(most) ? 1.0 : 0.5;
  };
  const double left = (into.width - box.size.width * x) * share("xMin", "xMax");
  const double top = (into.height - box.size.height * y) * share("YMin", "YMax");
  return translation(left, top) * scaling(x, y) * translation(-box.x, -box.y);
}

}  // namespace penpose::io
