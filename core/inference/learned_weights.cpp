// Written by tests/learn/learn; do not edit.
#include "core/inference/weights.h"

namespace penpose::inference {
namespace {

Weights table() {
  Weights w;
  w.by[Term::evidence] = 1;
  w.by[Term::unit] = 1.445;
  w.by[Term::elsewhere] = 1.424;
  w.by[Term::distant] = 0.2728;
  w.by[Term::around] = 0;
  w.by[Term::mirrored] = 19.36;
  w.by[Term::turned] = 20.78;
  w.by[Term::scattered] = 5.028;
  w.by[Term::lone] = 1.265;
  w.by[Term::faint] = 0.5792;
  w.by[Term::fringe] = 0.04268;
  w.by[Term::carried] = 15.62;
  w.by[Term::axis] = 0.5633;
  w.by[Term::part] = 0.2504;
  w.by[Term::crosses] = 1.915;
  w.by[Term::lopsided] = 5.282;
  w.by[Term::against] = 2.341;
  w.by[Term::opposed] = 0.2435;
  w.by[Term::twice] = 0;
  w.by[Term::helper] = 19.5;
  w.by[Term::limit] = 0.4577;
  w.by[Term::share] = 0;
  w.by[Term::tie] = 9.479;
  w.by[Term::nothing] = 1.552;
  w.by[Term::backwards] = 0;
  w.by[Term::partial] = 7.904;
  w.by[Term::left_out] = 0.1098;
  w.by[Term::overshot] = 17.12;
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
