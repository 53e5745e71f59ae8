#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "tests/judges/hands/hand.h"
#include "tests/support/random.h"

namespace penpose::judges {

/// What is drawn by lot for a rig. Lots about one thing do not depend on those about another, so that adding a thing
/// leaves the others as they were.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : seed_(seed), random_(seed) {}
  /// Those about something: the same every time that they are asked for.
  [[nodiscard]] Dice about(std::string_view what) const { return Dice(seed_of(what, "random", seed_)); }

  double real(double low, double high) { return random_(low, high); }
  bool chance(double share) { return random_(0, 1) < share; }
  /// low..high, both included.
  std::size_t count(std::size_t low, std::size_t high) { return low + random_.index(high - low + 1); }
  std::size_t below(std::size_t end) { return random_.index(end); }
  /// Around 1, as often above as below.
  double about_one(double spread) { return 1 + random_(-spread, spread); }
  template <typename List>
  [[nodiscard]] const auto& one_of(const List& list) {
    return list[random_.index(std::size(list))];
  }

 private:
  std::uint64_t seed_;
  tests::Random random_;
};

/// Ends "_L" or "_R".
[[nodiscard]] inline bool has_side(std::string_view muscle) { return muscle.ends_with("_L") || muscle.ends_with("_R"); }
/// Whether a muscle is there twice; mouth_L, jaw_L and their like are two ways of one.
[[nodiscard]] inline bool is_paired(std::string_view muscle) {
  return has_side(muscle) && !muscle.starts_with("mouth_") && !muscle.starts_with("jaw_");
}
/// A muscle without its side: "smile_L" and "smile_R" are both "smile_".
[[nodiscard]] inline std::string without_side(std::string_view muscle) {
  return std::string(has_side(muscle) ? muscle.substr(0, muscle.size() - 1) : muscle);
}

}  // namespace penpose::judges
