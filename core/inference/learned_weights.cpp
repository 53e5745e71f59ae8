// Written by tests/learn/learn; do not edit.
#include "core/inference/weights.h"

namespace penpose::inference {
namespace {

Weights table() {
  Weights w;
  w.by[Term::evidence] = 1;
  w.by[Term::unit] = 2.199;
  w.by[Term::elsewhere] = 0.1674;
  w.by[Term::distant] = 0.8524;
  w.by[Term::mirrored] = 27.33;
  w.by[Term::turned] = 21.52;
  w.by[Term::scattered] = 14.62;
  w.by[Term::lone] = 1.014;
  w.by[Term::faint] = 0.3527;
  w.by[Term::fringe] = 1.979;
  w.by[Term::carried] = 8.794;
  w.by[Term::axis] = 0.6663;
  w.by[Term::part] = 0.4281;
  w.by[Term::crosses] = 3.131;
  w.by[Term::lopsided] = 21.07;
  w.by[Term::against] = 1.943;
  w.by[Term::twice] = 0;
  w.by[Term::helper] = 18.64;
  w.by[Term::limit] = 0;
  w.by[Term::share] = 0;
  w.by[Term::tie] = 9.322;
  w.by[Term::nothing] = 2.038;
  w.by[Term::backwards] = 0;
  w.by[Term::partial] = 8.979;
  w.by[Term::left_out] = 1.23;
  w.by[Term::overshot] = 17.71;
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
