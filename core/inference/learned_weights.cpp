// Written by tests/learn/learn for edition 11; do not edit.
// Rigs: those of tests/judges/rigs/seen and random rigs of the seeds 1 to 32.
// rigs left out      loss 0.362, likeliest reading right in 87.4 % of 8392 cases,
// learned            loss 0.326, likeliest reading right in 88.8 % of 8392 cases.
#include "core/inference/weights.h"

namespace penpose::inference {
namespace {

Weights learned_table() {
  Weights w;
  w.by[Term::evidence] = 1;
  w.by[Term::unit] = 2.711;
  w.by[Term::elsewhere] = 0.6359;
  w.by[Term::distant] = 1.177;
  w.by[Term::mirrored] = 26.27;
  w.by[Term::turned] = 26.8;
  w.by[Term::scattered] = 9.481;
  w.by[Term::lone] = 1.107;
  w.by[Term::faint] = 1.521;
  w.by[Term::bears] = 9.373;
  w.by[Term::carried] = 47.39;
  w.by[Term::axis] = 0.5189;
  w.by[Term::part] = 0.7427;
  w.by[Term::crosses] = 6.47;
  w.by[Term::lopsided] = 6.033;
  w.by[Term::against] = 4.733;
  w.by[Term::helper] = 17.61;
  w.by[Term::share] = 0.144;
  w.by[Term::tie] = 2.698;
  w.by[Term::nothing] = 3.919;
  w.by[Term::backwards] = 4;
  w.by[Term::partial] = 5.212;
  w.by[Term::left_out] = 5.735;
  w.by[Term::overshot] = 17.52;
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
  w.follows = 0.1;
  w.borne = 0.5;
  w.gives_up = 0.85;
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
