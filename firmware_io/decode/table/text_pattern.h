#pragma once

#include <bitset>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace penpose::decode {

/// A regular expression for device strings, matched in bounded time whatever the pattern: no backtracking, no recursion
/// over the text. Supports the common subset of ECMAScript and .NET patterns: alternation, groups (capturing or `(?:`),
/// `(?=` and `(?!`, classes, `\d \w \s` and their opposites, `\xHH`, `. ^ $`, and the quantifiers `* + ? {n} {n,}
/// {n,m}`, lazy or not. Back references and look-behind are refused. docs/measured.md says why it is not PCRE2.
class TextPattern {
 public:
  /// At most 512 bytes. The error says what is wrong with the pattern.
  [[nodiscard]] static base::Result<TextPattern> parse(std::string_view pattern);

  /// Whether some part of the text matches; at most 512 bytes are searched.
  [[nodiscard]] bool found_in(std::string_view text) const;
  [[nodiscard]] const std::string& text() const { return pattern_; }

 private:
  friend class PatternCompiler;
  friend class PatternRun;

  enum class Op : std::uint8_t { byte_of, fork, jump, at_begin, at_end, ahead, not_ahead, match };
  struct Step {
    Op op = Op::match;
    std::uint16_t first = 0;   ///< byte_of: class; fork, jump, ahead: next step
    std::uint16_t second = 0;  ///< fork: other step; ahead: step after the look-ahead
  };

  std::string pattern_;
  std::vector<Step> steps_;
  std::vector<std::bitset<256>> classes_;
};

}  // namespace penpose::decode
