#include "core/prior/shrinkage.h"

#include <algorithm>

namespace penpose::prior {

double oracle_shrinkage(std::size_t n, std::size_t p, double trace, double trace_of_square) {
  const auto samples = static_cast<double>(n);
  const auto numbers = static_cast<double>(p);
  const double uneven = trace_of_square - trace * trace / numbers;
  const double below = (samples + 1 - 2 / numbers) * uneven;
  const double above = (1 - 2 / numbers) * trace_of_square + trace * trace;
  if (!(below > 0)) return 1;
  return std::clamp(above / below, 0.0, 1.0);
}

}  // namespace penpose::prior
