#include "core/inference/weights.h"

namespace penpose::inference {
namespace {

Weights hand_set_table() {
  Weights w;
  w.by[Term::evidence] = 1.0;
  w.by[Term::unit] = 4.3;
  w.by[Term::elsewhere] = 2.5;
  w.by[Term::fringe] = 3.0;
  w.by[Term::carried] = 8.0;
  w.by[Term::axis] = 2.0;
  w.by[Term::part] = 10.0;
  w.by[Term::crosses] = 14.0;
  w.by[Term::lopsided] = 4.0;
  w.by[Term::against] = 12.0;
  w.by[Term::twice] = 6.0;
  w.by[Term::helper] = 7.0;
  w.by[Term::limit] = 4.0;
  w.by[Term::share] = 7.0;
  w.by[Term::tie] = 10.0;
  w.by[Term::nothing] = 6.0;
  w.by[Term::backwards] = 4.0;
  w.by[Term::partial] = 8.0;
  w.by[Term::left_out] = 14.0;
  w.by[Term::overshot] = 8.0;
  w.by[Term::one_end] = 100.0;
  w.by[Term::taught] = 1.0;
  w.by[Term::leaning] = 1.0;
  return w;
}

}  // namespace

const Weights& hand_set_weights() {
  static const Weights weights = hand_set_table();
  return weights;
}

}  // namespace penpose::inference
