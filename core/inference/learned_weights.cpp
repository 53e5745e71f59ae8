// Written by tests/learn/learn for edition 8; do not edit.
// Rigs: those of tests/judges/rigs/seen and random rigs of the seeds 1 to 32.
// rigs left out      loss 0.309, likeliest reading right in 88.8 % of 8430 cases,
// learned            loss 0.273, likeliest reading right in 90.0 % of 8430 cases.
#include "core/inference/weights.h"

namespace penpose::inference {
namespace {

Weights learned_table() {
  Weights w;
  w.by[Term::evidence] = 1;
  w.by[Term::unit] = 2.969;
  w.by[Term::elsewhere] = 0.6403;
  w.by[Term::distant] = 1.608;
  w.by[Term::mirrored] = 21.68;
  w.by[Term::turned] = 22.87;
  w.by[Term::scattered] = 8.948;
  w.by[Term::lone] = 1.05;
  w.by[Term::faint] = 1.281;
  w.by[Term::fringe] = 0;
  w.by[Term::carried] = 9.46;
  w.by[Term::axis] = 0.889;
  w.by[Term::part] = 0.5012;
  w.by[Term::crosses] = 5.005;
  w.by[Term::lopsided] = 9.261;
  w.by[Term::against] = 3.357;
  w.by[Term::twice] = 0;
  w.by[Term::helper] = 18.02;
  w.by[Term::limit] = 0;
  w.by[Term::share] = 0.483;
  w.by[Term::tie] = 2.992;
  w.by[Term::nothing] = 4.771;
  w.by[Term::backwards] = 0;
  w.by[Term::partial] = 7.343;
  w.by[Term::left_out] = 2.685;
  w.by[Term::overshot] = 17.59;
  w.by[Term::one_end] = 100;
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
  w.far = 0.6;
  w.together = 0.15;
  w.spans = 0.6;
  w.carries_more = 8;
  w.follows = 0;
  w.gives_up = 1e+06;
  w.rivals = 8;
  w.window = 8;
  w.offered = 0.01;
  w.alike = 0.3;
  w.taught_margin = 1;
  w.slide = 0.015;
  return w;
}

}  // namespace

const Weights& learned_weights() {
  static const Weights weights = learned_table();
  return weights;
}

}  // namespace penpose::inference
