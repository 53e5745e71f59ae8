#include "tests/judges/drawing/signs/expression.h"

#include <algorithm>
#include <array>

#include "core/base/numbers.h"

namespace penpose::judges::drawn {
namespace {

constexpr std::array<const char*, k_expression_count> k_names{"rest",      "happy",   "laugh", "sad",  "angry",
                                                              "surprised", "disgust", "fear",  "wink", "smirk",
                                                              "contempt",  "sleepy",  "kiss",  "open"};
constexpr std::array<const char*, k_sign_count> k_sign_names{
    "corner",       "corner_left",   "corner_right", "corner_skew", "gap",  "width",    "brow_in",
    "brow_in_left", "brow_in_right", "brow_out",     "brow_tilt",   "lid",  "lid_left", "lid_right",
    "lid_least",    "lid_skew",      "lid_this",     "lid_other",   "sneer"};

Condition above(Sign sign, double bound) { return {sign, true, bound}; }
Condition below(Sign sign, double bound) { return {sign, false, bound}; }

/// Thresholds are what people see on faces that they name without knowing what was meant.
std::array<SignsOf, k_expression_count> table() {
  using enum Sign;
  std::array<SignsOf, k_expression_count> all;
  const auto row = [&](Expression e) -> SignsOf& { return all[static_cast<std::size_t>(e)]; };
  row(Expression::happy) = {{{above(corner_right, 0.045)}, {above(corner_left, 0.045)}},
                            {below(corner, -0.03), below(brow_in, -0.02), above(lid_skew, 0.5)}};
  row(Expression::laugh) = {
      {{above(corner_right, 0.02)}, {above(corner_left, 0.02)}, {above(gap, 0.10)}, {above(width, -0.05)}},
      {below(corner, -0.03), below(brow_in, -0.02), above(lid_skew, 0.5)}};
  row(Expression::sad) = {{{below(corner, -0.04)}, {above(brow_tilt, 0.008), below(corner, -0.07)}},
                          {above(corner, 0.04), below(brow_tilt, -0.012), above(gap, 0.25), above(lid_skew, 0.5)}};
  row(Expression::angry) = {{{below(brow_in_right, -0.006)}, {below(brow_in_left, -0.006)}},
                            {above(corner, 0.06), above(brow_in, 0.006), above(lid_skew, 0.5)}};
  row(Expression::surprised) = {
      {{above(gap, 0.10)}, {above(brow_out, 0.008), above(brow_in, 0.008), above(lid, 1.12), below(width, -0.08)}},
      {above(corner, 0.10), below(brow_in, -0.01), below(lid_least, 0.5)}};
  row(Expression::disgust) = {{{above(sneer, 0.010)}, {below(brow_in, -0.004), above(sneer, 0.025)}},
                              {above(corner, 0.08), above(brow_in, 0.008), above(lid_skew, 0.5)}};
  row(Expression::fear) = {{{above(brow_tilt, 0.006), above(brow_in, 0.010)},
                            {above(lid, 1.08)},
                            {above(width, 0.03), above(gap, 0.05), below(corner, -0.04)}},
                           {above(corner, 0.06), below(brow_in, -0.008), below(lid_least, 0.5)}};
  row(Expression::wink) = {{{below(lid_this, 0.45)}, {above(lid_other, 0.6)}}, {below(corner, -0.06)}};
  row(Expression::smirk) = {{{above(corner_skew, 0.06)}},
                            {below(corner, -0.06), above(gap, 0.25), below(lid_least, 0.3)}};
  row(Expression::contempt) = {{{above(corner_skew, 0.05)}},
                               {below(corner, -0.08), above(gap, 0.25), below(lid_least, 0.3)}};
  row(Expression::sleepy) = {{{below(lid_right, 0.65)}, {below(lid_left, 0.65)}},
                             {above(corner, 0.08), above(gap, 0.35), below(width, -0.12)}};
  row(Expression::kiss) = {{{below(width, -0.10)}}, {above(corner, 0.10), above(gap, 0.40)}};
  row(Expression::open) = {{{above(gap, 0.06)}, {below(width, 0.02)}}, {above(corner, 0.08), below(lid_least, 0.5)}};
  return all;
}

}  // namespace

const char* expression_name(Expression expression) { return k_names[static_cast<std::size_t>(expression)]; }

bool has_side(Expression expression) {
  return expression == Expression::wink || expression == Expression::smirk || expression == Expression::contempt;
}

std::optional<Expression> expression_named(std::string_view name) {
  const auto found = std::find(k_names.begin(), k_names.end(), name);
  if (found == k_names.end()) return std::nullopt;
  return static_cast<Expression>(found - k_names.begin());
}

std::string Condition::words() const {
  return std::string(k_sign_names[static_cast<std::size_t>(sign)]) + (above ? " > " : " < ") +
         base::format_double(bound);
}

bool holds(const AnyOf& any, const Signs& signs) {
  return std::any_of(any.begin(), any.end(), [&](const Condition& one) { return one.holds(signs); });
}

const SignsOf& signs_of(Expression expression) {
  static const auto k_table = table();
  return k_table[static_cast<std::size_t>(expression)];
}

std::span<const Condition> torn_signs() {
  static constexpr std::array<Condition, 2> k_torn{{{Sign::gap, false, -0.25}, {Sign::lid_least, false, -0.7}}};
  return k_torn;
}

}  // namespace penpose::judges::drawn
