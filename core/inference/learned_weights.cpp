// Written by tests/learn/learn for edition 8; do not edit.
// Rigs: those of tests/judges/rigs/seen and random rigs of the seeds 1 to 32.
// rigs left out      loss 0.332, likeliest reading right in 87.9 % of 8485 cases,
// learned            loss 0.298, likeliest reading right in 89.0 % of 8485 cases.
#include "core/inference/weights.h"

namespace penpose::inference {
namespace {

Weights learned_table() {
  Weights w;
  w.by[Term::evidence] = 1;
  w.by[Term::unit] = 2.884;
  w.by[Term::elsewhere] = 0.7018;
  w.by[Term::distant] = 1.422;
  w.by[Term::mirrored] = 26.98;
  w.by[Term::turned] = 22.64;
  w.by[Term::scattered] = 8.941;
  w.by[Term::lone] = 1.095;
  w.by[Term::faint] = 1.332;
  w.by[Term::fringe] = 0.1706;
  w.by[Term::carried] = 11.27;
  w.by[Term::axis] = 1.006;
  w.by[Term::part] = 0.7444;
  w.by[Term::crosses] = 14.07;
  w.by[Term::lopsided] = 6.986;
  w.by[Term::against] = 2.434;
  w.by[Term::twice] = 1.282;
  w.by[Term::helper] = 18.09;
  w.by[Term::limit] = 0;
  w.by[Term::share] = 0.4583;
  w.by[Term::tie] = 6.885;
  w.by[Term::nothing] = 4.611;
  w.by[Term::backwards] = 4;
  w.by[Term::partial] = 11;
  w.by[Term::left_out] = 16.01;
  w.by[Term::overshot] = 17.21;
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
