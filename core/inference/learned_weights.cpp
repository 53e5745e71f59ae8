// Written by tests/learn/learn for edition 8; do not edit.
// Rigs: those of tests/judges/rigs/seen and random rigs of the seeds 1 to 32.
// rigs left out      loss 0.298, likeliest reading right in 89.2 % of 8428 cases,
// learned            loss 0.268, likeliest reading right in 90.2 % of 8428 cases.
#include "core/inference/weights.h"

namespace penpose::inference {
namespace {

Weights table() {
  Weights w;
  w.by[Term::evidence] = 1;
  w.by[Term::unit] = 1.242;
  w.by[Term::elsewhere] = 0.8564;
  w.by[Term::distant] = 1.688;
  w.by[Term::mirrored] = 22.37;
  w.by[Term::turned] = 23.11;
  w.by[Term::scattered] = 8.644;
  w.by[Term::lone] = 1.183;
  w.by[Term::faint] = 1.424;
  w.by[Term::carried] = 9.375;
  w.by[Term::axis] = 0.8915;
  w.by[Term::part] = 0.3902;
  w.by[Term::crosses] = 5.037;
  w.by[Term::lopsided] = 8.533;
  w.by[Term::against] = 1.764;
  w.by[Term::helper] = 20.79;
  w.by[Term::share] = 0.6086;
  w.by[Term::tie] = 4.809;
  w.by[Term::nothing] = 3.042;
  w.by[Term::partial] = 12.94;
  w.by[Term::left_out] = 2.77;
  w.by[Term::overshot] = 17.44;
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
