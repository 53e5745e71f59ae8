#pragma once

#include <optional>
#include <span>
#include <vector>

namespace penpose::io {

/// Whether a list of times or numbers that should grow can be gone by, and which of them are out of order.
struct Growing {
  std::vector<bool> in_order;  ///< one a value: among the most that grow one after the other; the first of equal ones
  std::size_t known = 0;       ///< values that are there
  std::size_t astray = 0;      ///< of those, how many are not in order
  /// Of 5 values more than 3 are there and in order; else the list was never meant to grow, or begins again.
  [[nodiscard]] bool trusted() const { return 5 * (known - astray) > 3 * in_order.size(); }
};

[[nodiscard]] Growing find_growing(std::span<const std::optional<double>> values);

/// The usual step from one value to the next: of those that grow the mean of the ones about the middle one, whether or
/// not all grow; 0 where none does.
[[nodiscard]] double usual_step(std::span<const std::optional<double>> values);

/// The first value that lies further from the one before (of those in order) than anybody's recording does: by more
/// than `least`, and by more than 10 times what all values would span at their usual step. None in values that are not
/// trusted or have no usual step.
[[nodiscard]] std::optional<std::size_t> find_leap(std::span<const std::optional<double>> values,
                                                   const Growing& growing, double least);

/// Times of which those in order are kept, the others lie evenly between them, and go on at the rate of the whole
/// before and after. `places`: where each belongs, growing. Precondition: two in order.
[[nodiscard]] std::vector<double> placed_between(std::span<const std::optional<double>> times, const Growing& growing,
                                                 std::span<const double> places);

}  // namespace penpose::io
