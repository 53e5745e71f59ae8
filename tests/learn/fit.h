#pragma once

#include <string>
#include <vector>

#include "core/inference/weights.h"

namespace penpose::learn {

/// A reading that was found of a case: its terms, and whether an artist would call it right.
struct Candidate {
  inference::Terms terms;
  bool right = false;
  std::string note = {};  ///< what moved, for people
};

/// All readings of one case. Several can be right.
struct LearnCase {
  std::string rig;
  std::string name;
  std::vector<Candidate> candidates;
  double weight = 1;
};

/// What a set of weights makes of cases.
struct Score {
  double loss = 0;     ///< mean of -log of the probability of the right readings
  double right = 0;    ///< share of cases whose likeliest reading is right
  std::size_t of = 0;  ///< cases with a right reading
};
[[nodiscard]] Score score(const std::vector<LearnCase>& cases, const inference::Terms& by);

/// Which weights are learned, and how strongly each is held near 0: one width a term, in units of the weight; 0: it
/// stays as it is.
using Widths = inference::Terms;

/// Maximum conditional likelihood (Taskar, Guestrin and Koller 2004), with a share of labels that may be wrong:
/// minimises the sum over cases of
///   -log [ 0.98 p + 0.02 ],   p = sum over right readings exp(-E) / sum over all readings exp(-E),   E = by . terms
/// plus half the squares of weights over widths. No weight is negative. Newton steps from `by`, each on a convex bound
/// (Yuille and Rangarajan, "The concave-convex procedure", 2003); it is not convex where several are right, so the
/// start matters.
[[nodiscard]] inference::Terms fit(const std::vector<LearnCase>& cases, inference::Terms by, const Widths& widths);

}  // namespace penpose::learn
