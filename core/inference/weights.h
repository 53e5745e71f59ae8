#pragma once

#include <span>

#include "core/inference/terms.h"

namespace penpose::inference {

/// What tells one reading from another: the weight of each term, and the scales that terms are made with.
/// There are two tables: the one in use was set by hand on seven rigs; the one that `tests/learn` writes is a shadow of
/// it until it is nowhere worse.
struct Weights {
  Terms by;
  /// Scale of the evidence's logarithm: how many squares of doubt a curve has when the hand alone is left.
  double reach = 7.0;
  /// Squares of doubt from which on a line asks for something.
  double asks_from = 18.0;
  /// Joints carry this many times what is near the lines (squared) as a rule.
  double carried_from = 8.0;
  /// A range has more to give up to this share of it.
  double limit_from = 0.8;
  /// Weight of the squares of shares once it is known which controls move: values follow the lines.
  double settled_share = 0.2;
  /// Share of the size of what shapes move from which on lips are driven through each other.
  double crosses_from = 0.03;
  /// Units whose fields are alike by this cosine do the same: one of them at most.
  double same = 0.9;
  /// Near a curve is what lies within this share of its extent.
  double near = 0.18;
  /// Far from a curve is what lies beyond this share of its extent.
  double far = 0.6;
  /// Curves nearer to each other than this share of the smaller one's extent are met or missed together.
  double together = 0.15;
  /// A line speaks for joints whose own part of the model it spans by this share.
  double spans = 0.6;
  /// Joints that carry this many times what is near the drawn curves (squared) are thought of last.
  double carries_more = 8.0;
  /// Where nothing but joints that carry more than was drawn could take a line this share of its way, those are meant
  /// whatever the line spans; 0: never.
  double follows = 0.1;
  /// A reading that leaves more than this share of the squares of every line is none.
  double gives_up = 0.85;
  /// Readings of a round that are matched on their own, and how far above the best.
  double rivals = 3.0;
  double window = 6.0;
  /// Readings are offered that are as likely as this, or likelier.
  double offered = 6e-6;
  /// Readings look alike that differ by less than this share of what they move.
  double alike = 0.3;
  /// A reading that was taken in place of another is the best one from then on, by this much.
  double taught_margin = 1.0;
  /// Strokes begin and end within this share of their length of where they were meant to, root mean square.
  double slide = 0.015;
};

/// A scale of the table, for those who list or change it.
struct Scale {
  const char* name;
  double Weights::*value;
};
[[nodiscard]] std::span<const Scale> scales();

/// The table in use.
[[nodiscard]] const Weights& hand_set_weights();
/// The table that was learned: `penpose pose --preset map`.
[[nodiscard]] const Weights& learned_weights();

}  // namespace penpose::inference
