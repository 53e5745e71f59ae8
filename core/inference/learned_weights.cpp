// Written by tests/learn/learn; do not edit.
#include "core/inference/weights.h"

namespace penpose::inference {
namespace {

Weights table() {
  Weights w;
  w.by[Term::evidence] = 1;
  w.by[Term::unit] = 5.528;
  w.by[Term::elsewhere] = 5.848;
  w.by[Term::apart] = 8.274;
  w.by[Term::faint] = 2.947;
  w.by[Term::fringe] = 0.7914;
  w.by[Term::carried] = 0;
  w.by[Term::axis] = 1.496;
  w.by[Term::part] = 0.2257;
  w.by[Term::crosses] = 7.388;
  w.by[Term::lopsided] = 12.56;
  w.by[Term::against] = 10.24;
  w.by[Term::twice] = 0;
  w.by[Term::helper] = 9.536;
  w.by[Term::limit] = 0;
  w.by[Term::share] = 0;
  w.by[Term::tie] = 2.058;
  w.by[Term::nothing] = 22.74;
  w.by[Term::backwards] = 1.869e-78;
  w.by[Term::partial] = 3.754;
  w.by[Term::left_out] = 7.757;
  w.by[Term::overshot] = 15.4;
  w.by[Term::one_end] = 100;
  w.by[Term::determined] = 0.02004;
  w.by[Term::astray] = 0;
  w.by[Term::taught] = 1;
  w.by[Term::leaning] = 1;
  w.reach = 7;
  w.asks_from = 18;
  w.carried_from = 8;
  w.limit_from = 0.8;
  w.settled_share = 0.2;
  w.crosses_from = 0.03;
  w.same = 0.9;
  w.near = 0.18;
  w.together = 0.15;
  w.spans = 0.6;
  w.carries_more = 8;
  w.offered = 0.01;
  w.slide = 0.015;
  return w;
}

}  // namespace

const Weights& learned_weights() {
  static const Weights weights = table();
  return weights;
}

}  // namespace penpose::inference
