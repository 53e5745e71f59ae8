#pragma once

#include <string>
#include <vector>

#include "tests/judges/rigs/random/dice.h"

namespace penpose::judges {

/// How a maker calls controls: by ARKit's words, plain ones, FACS numbers or mere numbers, and sides in many ways.
class Names {
 public:
  explicit Names(Dice dice);
  /// Of a control that does what `word` says: a muscle, with "_L" or "_R" behind it for a side. Others may have it.
  [[nodiscard]] std::string control(const std::string& word);
  /// Of a joint; no other has it.
  [[nodiscard]] std::string joint(const std::string& word);
  /// The name itself, or with a number behind it where it is taken.
  [[nodiscard]] std::string unique(std::string name);

 private:
  enum class Style : std::uint8_t { words, plain, numbers_of_facs, numbers };
  [[nodiscard]] std::string sided(const std::string& name, const std::string& word) const;

  Style style_;
  std::string before_, before_joint_;
  std::string left_, right_;
  bool side_first_;
  std::size_t numbered_ = 0;
  std::vector<std::string> taken_;
};

}  // namespace penpose::judges
