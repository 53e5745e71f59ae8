#pragma once

#include <optional>
#include <string>
#include <vector>

namespace penpose::judges {

/// How one case went. What a measure does not look at stays without a value.
struct Outcome {
  std::string name;  ///< of the case
  std::string hand;  ///< by which it was drawn; empty: none
  double right = 0;  ///< how many of `of` were right: 1 of 1 for a gesture, labels of lines for a drawing
  double nothing = 0;
  double of = 0;
  std::optional<double> offered;  ///< where it is wrong: 1 if a right reading is offered beside it, else 0
  std::optional<double> error;  ///< per cent: of the whole face's movement, of the figure's height, gap to the optimum
  std::optional<double> stray;  ///< per cent of the size: the largest movement of what should not move
  std::optional<double> still;  ///< per cent of the size: the largest movement where nothing should move
  std::optional<double> left;   ///< per cent of the size: mean distance between the drawn lines and the posed curves
  std::optional<double> controls, true_controls;  ///< how many moved, and how many should
  double ms = 0;                                  ///< of the solve; not compared
  std::string note;                               ///< what moved, for people
};

/// The outcomes of a measure on a rig.
struct Judged {
  std::string measure;  ///< intent, gesture, body, exact, ...
  std::string rig;
  std::string group;  ///< seen, held_out, shared
  std::vector<Outcome> outcomes;
};

}  // namespace penpose::judges
