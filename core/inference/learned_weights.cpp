// Written by tests/learn/learn; do not edit.
#include "core/inference/weights.h"

namespace penpose::inference {
namespace {

Weights table() {
  Weights w;
  w.by[Term::evidence] = 1;
  w.by[Term::unit] = 2.272;
  w.by[Term::elsewhere] = 1.24;
  w.by[Term::distant] = 0.2967;
  w.by[Term::mirrored] = 33.46;
  w.by[Term::turned] = 14.5;
  w.by[Term::scattered] = 0;
  w.by[Term::lone] = 1.339;
  w.by[Term::faint] = 0.7243;
  w.by[Term::fringe] = 16.02;
  w.by[Term::carried] = 12.65;
  w.by[Term::axis] = 0.3896;
  w.by[Term::part] = 0.6312;
  w.by[Term::crosses] = 2.741;
  w.by[Term::lopsided] = 7.833;
  w.by[Term::against] = 0.6468;
  w.by[Term::twice] = 3.878;
  w.by[Term::helper] = 18.79;
  w.by[Term::limit] = 0.03006;
  w.by[Term::share] = 0;
  w.by[Term::tie] = 10.18;
  w.by[Term::nothing] = 3.572;
  w.by[Term::backwards] = 0;
  w.by[Term::partial] = 7.45;
  w.by[Term::left_out] = 1.553;
  w.by[Term::overshot] = 18.08;
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
