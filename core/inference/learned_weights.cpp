// Written by tests/learn/learn; do not edit.
#include "core/inference/weights.h"

namespace penpose::inference {
namespace {

Weights table() {
  Weights w;
  w.by[Term::evidence] = 1;
  w.by[Term::unit] = 5.525;
  w.by[Term::elsewhere] = 5.834;
  w.by[Term::distant] = 0;
  w.by[Term::apart] = 8.409;
  w.by[Term::faint] = 2.934;
  w.by[Term::fringe] = 0.8104;
  w.by[Term::carried] = 0;
  w.by[Term::axis] = 1.46;
  w.by[Term::part] = 0.2384;
  w.by[Term::crosses] = 7.377;
  w.by[Term::lopsided] = 12.58;
  w.by[Term::against] = 10.2;
  w.by[Term::twice] = 0;
  w.by[Term::helper] = 9.519;
  w.by[Term::limit] = 0;
  w.by[Term::share] = 0;
  w.by[Term::tie] = 1.974;
  w.by[Term::nothing] = 22.74;
  w.by[Term::backwards] = 1.31e-95;
  w.by[Term::partial] = 3.758;
  w.by[Term::left_out] = 7.756;
  w.by[Term::overshot] = 15.39;
  w.by[Term::one_end] = 100;
  w.by[Term::determined] = 0.02663;
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
