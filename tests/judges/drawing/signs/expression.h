#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/judges/drawing/signs/face_signs.h"

namespace penpose::judges::drawn {

/// What a drawing of a face means.
enum class Expression : unsigned char {
  rest,
  happy,
  laugh,
  sad,
  angry,
  surprised,
  disgust,
  fear,
  wink,
  smirk,
  contempt,
  sleepy,
  kiss,
  open,
};
inline constexpr std::size_t k_expression_count = static_cast<std::size_t>(Expression::open) + 1;

[[nodiscard]] const char* expression_name(Expression expression);
/// Whether it is of one side of the face: a wink, a smirk, contempt.
[[nodiscard]] bool has_side(Expression expression);
[[nodiscard]] std::optional<Expression> expression_named(std::string_view name);

/// A sign above or below a bound.
struct Condition {
  Sign sign;
  bool above = true;
  double bound = 0;

  [[nodiscard]] bool holds(const Signs& signs) const { return above ? signs[sign] > bound : signs[sign] < bound; }
  /// "corner > 0.045".
  [[nodiscard]] std::string words() const;
};
/// One of these.
using AnyOf = std::vector<Condition>;

[[nodiscard]] bool holds(const AnyOf& any, const Signs& signs);

/// What a person must see to name an expression, and what he must not see, as he would name another one.
struct SignsOf {
  std::vector<AnyOf> need;
  std::vector<Condition> never;
};
/// Precondition: not rest.
[[nodiscard]] const SignsOf& signs_of(Expression expression);

/// Lips or lids that run through one another.
[[nodiscard]] std::span<const Condition> torn_signs();

}  // namespace penpose::judges::drawn
