#pragma once

#include <functional>
#include <span>

namespace penpose::posing {

/// Puts parameters back that the search changed without need (paper 3.1; method, section 2, "Clean-up"). For each i of
/// 0..after.size(), the energy with x_i back at `before` tells whether it mattered; resets are accepted one at a time
/// in order of least change, each re-checked with those before it, while the energy stays below `limit`. `energy` is E
/// at a point; `after` is changed in place. Returns the number of parameters put back.
std::size_t clean_up(const std::function<double(std::span<const double>)>& energy, std::span<const double> before,
                     double limit, std::span<double> after);

}  // namespace penpose::posing
