// Written by tests/learn/learn; do not edit.
#include "core/inference/weights.h"

namespace penpose::inference {
namespace {

Weights table() {
  Weights w;
  w.by[Term::evidence] = 1;
  w.by[Term::unit] = 1.642;
  w.by[Term::elsewhere] = 2.1;
  w.by[Term::distant] = 1.997;
  w.by[Term::mirrored] = 36.19;
  w.by[Term::apart] = 32.96;
  w.by[Term::faint] = 1.564;
  w.by[Term::fringe] = 1.626;
  w.by[Term::carried] = 7.443;
  w.by[Term::axis] = 0.7285;
  w.by[Term::part] = 0.5755;
  w.by[Term::crosses] = 5.134;
  w.by[Term::lopsided] = 6.996;
  w.by[Term::against] = 0;
  w.by[Term::twice] = 4.374;
  w.by[Term::helper] = 19.62;
  w.by[Term::limit] = 0.01358;
  w.by[Term::share] = 0.04759;
  w.by[Term::tie] = 10.06;
  w.by[Term::nothing] = 3.426;
  w.by[Term::backwards] = 0;
  w.by[Term::partial] = 7.864;
  w.by[Term::left_out] = 4.803;
  w.by[Term::overshot] = 18.71;
  w.by[Term::one_end] = 100;
  w.by[Term::determined] = 0;
  w.by[Term::taught] = 7.01e-18;
  w.by[Term::astray] = 0;
  w.by[Term::leaning] = 1;
  w.reach = 7;
  w.asks_from = 18;
  w.carried_from = 8;
  w.limit_from = 0.8;
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
