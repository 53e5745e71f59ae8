#include "core/io/picture_lines/svg/internal/affine.h"

#include <array>
#include <cstddef>
#include <span>

#include "core/base/math.h"
#include "core/io/picture_lines/svg/internal/number_scanner.h"

namespace penpose::io {
namespace {

std::optional<Affine> rotated(std::span<const double> n) {
  const double angle = base::radians(n[0]);
  const double cosine = base::cos(angle);
  const double sine = base::sin(angle);
  const Affine turn{cosine, sine, -sine, cosine, 0, 0};
  if (n.size() == 1) return turn;
  if (n.size() != 3) return std::nullopt;
  return translation(n[1], n[2]) * turn * translation(-n[1], -n[2]);
}

/// One of the functions of a list, of at least one number.
std::optional<Affine> transform_of(std::string_view name, std::span<const double> n) {
  if (name == "matrix" && n.size() == 6) return Affine{n[0], n[1], n[2], n[3], n[4], n[5]};
  if (name == "translate" && n.size() <= 2) return translation(n[0], n.size() > 1 ? n[1] : 0);
  if (name == "scale" && n.size() <= 2) return scaling(n[0], n.size() > 1 ? n[1] : n[0]);
  if (name == "rotate") return rotated(n);
  if (name == "skewX" && n.size() == 1) return Affine{1, 0, base::tan(base::radians(n[0])), 1, 0, 0};
  if (name == "skewY" && n.size() == 1) return Affine{1, base::tan(base::radians(n[0])), 0, 1, 0, 0};
  return std::nullopt;
}

}  // namespace

Affine operator*(const Affine& outer, const Affine& inner) {
  return {outer.a * inner.a + outer.c * inner.b,           outer.b * inner.a + outer.d * inner.b,
          outer.a * inner.c + outer.c * inner.d,           outer.b * inner.c + outer.d * inner.d,
          outer.a * inner.e + outer.c * inner.f + outer.e, outer.b * inner.e + outer.d * inner.f + outer.f};
}

std::optional<Affine> parse_transform(std::string_view text) {
  NumberScanner scanner(text);
  Affine all;
  for (scanner.skip_separator(); !scanner.at_end(); scanner.skip_separator()) {
    const std::string_view name = scanner.take_letters();
    scanner.skip_blanks();
    if (name == "none" && scanner.at_end()) return all;
    if (!scanner.take('(')) return std::nullopt;
    std::array<double, 6> numbers{};
    std::size_t count = 0;
    for (scanner.skip_blanks(); !scanner.take(')'); scanner.skip_separator()) {
      const auto number = scanner.number();
      if (!number || count == numbers.size()) return std::nullopt;
      numbers[count++] = *number;
    }
    const auto one = count > 0 ? transform_of(name, {numbers.data(), count}) : std::nullopt;
    if (!one) return std::nullopt;
    all = all * *one;
  }
  return all;
}

}  // namespace penpose::io
