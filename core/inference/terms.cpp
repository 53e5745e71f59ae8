#include "core/inference/terms.h"

namespace penpose::inference {

const char* name_of(Term term) {
  constexpr std::array<const char*, k_term_count> k_names{
      "evidence", "unit",    "elsewhere", "distant", "mirrored", "turned",   "scattered", "lone",   "faint",
      "bears",    "carried", "axis",      "part",    "crosses",  "lopsided", "against",   "helper", "share",
      "tie",      "nothing", "backwards", "partial", "left_out", "overshot", "one_end",   "taught", "leaning"};
  return k_names[static_cast<std::size_t>(term)];
}

}  // namespace penpose::inference
