// Written by tests/learn/learn; do not edit.
#include "core/inference/weights.h"

namespace penpose::inference {
namespace {

Weights table() {
  Weights w;
  w.by[Term::evidence] = 1;
  w.by[Term::unit] = 1.189;
  w.by[Term::elsewhere] = 0.91;
  w.by[Term::distant] = 1.786;
  w.by[Term::around] = 0;
  w.by[Term::mirrored] = 22.29;
  w.by[Term::turned] = 22.87;
  w.by[Term::scattered] = 8.386;
  w.by[Term::lone] = 1.14;
  w.by[Term::faint] = 1.431;
  w.by[Term::fringe] = 0;
  w.by[Term::carried] = 9.521;
  w.by[Term::axis] = 0.8638;
  w.by[Term::part] = 0.3854;
  w.by[Term::crosses] = 4.148;
  w.by[Term::lopsided] = 8.005;
  w.by[Term::against] = 1.605;
  w.by[Term::opposed] = 0;
  w.by[Term::twice] = 0;
  w.by[Term::helper] = 20.89;
  w.by[Term::limit] = 0;
  w.by[Term::share] = 0.6238;
  w.by[Term::tie] = 5.575;
  w.by[Term::nothing] = 2.867;
  w.by[Term::backwards] = 0;
  w.by[Term::partial] = 11.71;
  w.by[Term::left_out] = 1.443;
  w.by[Term::overshot] = 17.37;
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
