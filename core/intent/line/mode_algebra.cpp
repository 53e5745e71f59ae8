#include "core/intent/line/mode_algebra.h"

#include <cmath>

namespace penpose::intent {

ModeMatrix factor_of(ModeMatrix m) {
  for (std::size_t i = 0; i < k_modes; ++i) m[i][i] += 1.0;
  for (std::size_t i = 0; i < k_modes; ++i) {
    for (std::size_t c = 0; c <= i; ++c) {
      double sum = m[i][c];
      for (std::size_t k = 0; k < c; ++k) sum -= m[i][k] * m[c][k];
      m[i][c] = i == c ? std::sqrt(sum) : sum / m[c][c];
    }
  }
  return m;
}

void solve_forward(const ModeMatrix& l, double* b) {
  for (std::size_t i = 0; i < k_modes; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= l[i][k] * b[k];
    b[i] /= l[i][i];
  }
}

Modes solve_modes(const ModeMatrix& m, Modes b) {
  const ModeMatrix l = factor_of(m);
  solve_forward(l, b.data());
  for (std::size_t i = k_modes; i-- > 0;) {
    for (std::size_t k = i + 1; k < k_modes; ++k) b[i] -= l[k][i] * b[k];
    b[i] /= l[i][i];
  }
  return b;
}

}  // namespace penpose::intent
