// Written by tests/learn/learn; do not edit.
#include "core/inference/weights.h"

namespace penpose::inference {
namespace {

Weights table() {
  Weights w;
  w.by[Term::evidence] = 1;
  w.by[Term::unit] = 1.298;
  w.by[Term::elsewhere] = 0.8583;
  w.by[Term::distant] = 1.725;
  w.by[Term::mirrored] = 22.33;
  w.by[Term::turned] = 23.06;
  w.by[Term::scattered] = 8.589;
  w.by[Term::lone] = 1.197;
  w.by[Term::faint] = 1.424;
  w.by[Term::carried] = 9.61;
  w.by[Term::axis] = 0.8537;
  w.by[Term::part] = 0.3971;
  w.by[Term::crosses] = 4.049;
  w.by[Term::lopsided] = 8.29;
  w.by[Term::against] = 1.933;
  w.by[Term::helper] = 20.55;
  w.by[Term::share] = 0.6317;
  w.by[Term::tie] = 5.806;
  w.by[Term::nothing] = 3.133;
  w.by[Term::partial] = 12.78;
  w.by[Term::left_out] = 2.57;
  w.by[Term::overshot] = 17.42;
  w.by[Term::one_end] = 100;
  w.by[Term::taught] = 1;
  w.by[Term::leaning] = 1;
  w.reach = 7;
  w.asks_from = 18;
  w.carried_from = 8;
  w.settled_share = 0.2;
  w.crosses_from = 0.03;
  w.same = 0.9;
  w.near = 0.18;
  w.far = 0.6;
  w.together = 0.15;
  w.spans = 0.6;
  w.carries_more = 8;
  w.offered = 0.01;
  w.alike = 0.3;
  w.taught_margin = 1;
  w.slide = 0.015;
  return w;
}

}  // namespace

const Weights& learned_weights() {
  static const Weights weights = table();
  return weights;
}

}  // namespace penpose::inference
