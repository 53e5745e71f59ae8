#pragma once

#include <span>

#include "core/inference/terms.h"

namespace penpose::inference {

/// The table of weights: the weight of each term, and the scales that the terms are measured with. `tests/learn` writes
/// it.
struct Weights {
  Terms by;
  /// The scale of the evidence's logarithm: the squares of doubt that the hand alone leaves of a curve.
  double reach = 7.0;
  /// A line asks for something if it is off by more squares of doubt than this.
  double asks_from = 18.0;
  /// `carried` grows where a joint moves more than this many times what is near the lines (squared).
  double carried_from = 8.0;
  /// Replaces the weight of `share` once the controls are chosen, so that their values follow the lines.
  double settled_share = 0.2;
  /// `crosses` grows where a control pushes surfaces deeper into each other than this share of the size of what shapes
  /// move.
  double crosses_from = 0.03;
  /// Two units whose fields have a larger cosine than this do the same, so only one of them may move.
  double same = 0.9;
  /// Samples within this share of a curve's extent are near it.
  double near = 0.18;
  /// Samples beyond this share of a curve's extent are far from it.
  double far = 0.6;
  /// Curves that are nearer to each other than this share of the smaller one's extent form a group.
  double together = 0.15;
  /// A line poses a limb if it spans this share of what the joints carry.
  double spans = 0.6;
  /// The solver tries joints last that carry more than this many times what is near the curves (squared).
  double carries_more = 8.0;
  /// If only such joints can move a line by this share of its way, and no shape does anything on what they carry, the
  /// line poses them, whatever it spans.
  double follows = 0.1;
  /// A joint carries what shapes do if this share of it happens on what the joint carries.
  double borne = 0.5;
  /// The solver gives up a reading that leaves more than this share of the squares of every line.
  double gives_up = 0.85;
  /// The solver matches this many readings of each round on their own, if they are above the best by less than
  /// `window`.
  double rivals = 8.0;
  double window = 8.0;
  /// The window offers readings that have at least this probability.
  double offered = 0.01;
  /// Two readings look alike if they differ by less than this share of what they move.
  double alike = 0.3;
  /// A choice makes the reading that it took the best one by this much energy.
  double taught_margin = 1.0;
  /// The ends of a stroke stray along it by this share of its length, root mean square.
  double slide = 0.015;
};

/// The name of a scale and its place in the table.
struct Scale {
  const char* name;
  double Weights::*value;
};
[[nodiscard]] std::span<const Scale> scales();

/// Returns the table.
[[nodiscard]] const Weights& learned_weights();

}  // namespace penpose::inference
