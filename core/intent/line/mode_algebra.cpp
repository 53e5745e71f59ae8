#include "core/intent/line/mode_algebra.h"

#include "core/algebra/cholesky.h"

namespace penpose::intent {

ModeMatrix factor_of(ModeMatrix m) {
  for (std::size_t i = 0; i < k_modes; ++i) m[i][i] += 1.0;
  // Cannot fail: no pivot of I + m is below 1.
  static_cast<void>(algebra::factor(m[0].data(), k_modes));
  return m;
}

void solve_forward(const ModeMatrix& l, double* b) { algebra::solve_forward(l[0].data(), k_modes, b); }

Modes solve_modes(const ModeMatrix& m, Modes b) {
  algebra::solve_factored(factor_of(m)[0].data(), k_modes, b.data());
  return b;
}

}  // namespace penpose::intent
