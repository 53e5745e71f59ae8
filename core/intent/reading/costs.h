#pragma once

namespace penpose::intent {

/// What tells one reading of a line on a face from another. The energy counts like a negative logarithm of likelihood:
/// one look at a curve (k_looks of them) that is met twice as well gains about log 2 / 2. All were set together on
/// seven rigs of different makers (docs/posing.md, "Any rig"); the bench that moves them is checks of gestures and
/// known poses.
struct FaceCosts {
  /// Scale of the logarithm: how many squares of doubt a curve has when the hand alone is left (k_looks).
  double reach = 7.0;
  /// Each unit that moves.
  double unit = 4.3;
  /// What moves nothing though the line asks for ten times `asks_from` squares of doubt; grows with their logarithm.
  double nothing = 6.0;
  double asks_from = 18.0;
  /// Times log(1 + what a unit moves elsewhere over what it moves near the drawn curves, both squared).
  double elsewhere = 2.5;
  /// Times log(usual way of its field / largest way of the drawn curves): a line over the fringe of a field does not
  /// mean it.
  double fringe = 3.0;
  /// Of joints the same beyond `carried_from`: a head that turns carries hair, ears and the other half.
  double carried = 8.0;
  double carried_from = 8.0;
  /// Times half of 1 - c, c the cosine of what a unit does to the curves with its mirror image, and the square of the
  /// same of what the lines ask for: what is asked for on both sides is not meant for one.
  double lopsided = 4.0;
  /// Each part beyond the first of a control that is the sum of others.
  double part = 10.0;
  /// Each axis about which a joint turns.
  double axis = 2.0;
  /// At the end of a range, growing from `limit_from` of it.
  double limit = 4.0;
  double limit_from = 0.8;
  /// Times the square of a control's share of its range, while controls are chosen, and once they are: of two that do
  /// the same, the one that has more to give is meant.
  double share = 7.0;
  double settled_share = 0.2;
  /// Times how much a unit moves what another one of the reading moves already, in whatever direction (0 to 1).
  double helper = 7.0;
  /// Times the cosine of two units' fields beyond a tenth against each other; and beyond three tenths alike.
  double against = 12.0;
  double twice = 6.0;
  /// A control that drives lips through each other, from `crosses_from` of the size of what shapes move, to all of it
  /// at twice that: it corrects another one, and is not meant alone.
  double crosses = 14.0;
  double crosses_from = 0.03;
  /// Units whose fields are alike by this cosine do the same: one of them at most.
  double same = 0.9;
  /// Times the square of the difference between the sides of a pair.
  double tie = 10.0;
  /// Near a curve is what lies within this share of its extent.
  double near = 0.18;
  /// Curves nearer to each other than this share of the smaller one's extent are met or missed together.
  double together = 0.15;
  /// A line speaks for joints whose own part of the model it spans by this share.
  double spans = 0.6;
  /// Joints that carry this many times what is near the drawn curves (squared) are thought of last.
  double carries_more = 8.0;
  /// A reading that the artist once took in place of the best one, by an exchange of the same controls, is taken again
  /// where it is above the best by no more than this: as much as readings differ that are still offered.
  double taken = 12.0;
  /// Strokes begin and end within this share of their length of where they were meant to, root mean square.
  double slide = 0.015;
};

}  // namespace penpose::intent
