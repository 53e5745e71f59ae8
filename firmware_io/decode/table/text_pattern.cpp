#include "firmware_io/decode/table/text_pattern.h"

#include <algorithm>
#include <optional>

#include "core/base/numbers.h"

namespace penpose::decode {
namespace {

constexpr std::size_t k_longest_pattern = 512;
constexpr std::size_t k_longest_subject = 512;
constexpr std::size_t k_most_steps = 4096;
constexpr int k_deepest_group = 16;
constexpr std::uint64_t k_most_repeats = 255;
constexpr std::uint64_t k_no_limit = ~std::uint64_t{0};
constexpr std::int64_t k_most_work = 4'000'000;

using ByteSet = std::bitset<256>;

ByteSet range_set(unsigned first, unsigned last) {
  ByteSet set;
  for (unsigned i = first; i <= last; ++i) set.set(i);
  return set;
}
ByteSet digits() { return range_set('0', '9'); }
ByteSet word_bytes() { return digits() | range_set('a', 'z') | range_set('A', 'Z') | range_set('_', '_'); }
ByteSet blanks() { return range_set('\t', '\r') | range_set(' ', ' '); }

}  // namespace

/// Recursive descent over the pattern. A piece of program is a vector of steps whose targets count from its own start;
/// its end is the step after it.
class PatternCompiler {
 public:
  PatternCompiler(std::string_view pattern, std::vector<ByteSet>& classes) : rest_(pattern), classes_(classes) {}

  using Op = TextPattern::Op;
  using Piece = std::vector<TextPattern::Step>;

  std::optional<Piece> compile() {
    auto piece = alternatives(0);
    if (!rest_.empty()) fail("has a `)` without `(`");
    piece.push_back({});
    if (!problem_.empty()) return std::nullopt;
    return piece;
  }
  [[nodiscard]] const std::string& problem() const { return problem_; }

 private:
  void fail(std::string_view what) {
    if (problem_.empty()) problem_ = what;
    rest_ = {};
  }
  bool take(std::string_view start) {
    if (!rest_.starts_with(start)) return false;
    rest_.remove_prefix(start.size());
    return true;
  }

  static void append(Piece& to, const Piece& piece) {
    const auto shift = static_cast<std::uint16_t>(to.size());
    for (auto step : piece) {
      if (step.op == Op::fork || step.op == Op::jump || step.op == Op::ahead || step.op == Op::not_ahead) {
        step.first = static_cast<std::uint16_t>(step.first + shift);
        step.second = static_cast<std::uint16_t>(step.second + shift);
      }
      to.push_back(step);
    }
  }
  void append_bounded(Piece& to, const Piece& piece) {
    if (to.size() + piece.size() + 2 > k_most_steps) {
      fail("is too large");
    } else {
      append(to, piece);
    }
  }
  static std::uint16_t end_of(const Piece& piece, std::size_t extra = 0) {
    return static_cast<std::uint16_t>(piece.size() + extra);
  }

  Piece alternatives(int depth) {
    if (depth > k_deepest_group) {
      fail("nests groups more than 16 deep");
      return {};
    }
    auto piece = sequence(depth);
    while (take("|")) {
      const auto other = sequence(depth);
      Piece both{{Op::fork, 1, end_of(piece, 2)}};
      append_bounded(both, piece);
      both.push_back({Op::jump, end_of(both, other.size() + 1), 0});
      append_bounded(both, other);
      piece = std::move(both);
    }
    return piece;
  }

  Piece sequence(int depth) {
    Piece piece;
    while (!rest_.empty() && rest_.front() != '|' && rest_.front() != ')') append_bounded(piece, repeated(depth));
    return piece;
  }

  Piece repeated(int depth) {
    auto one = atom(depth);
    std::uint64_t least = 1;
    std::uint64_t most = 1;
    if (take("*")) {
      least = 0;
      most = k_no_limit;
    } else if (take("+")) {
      most = k_no_limit;
    } else if (take("?")) {
      least = 0;
    } else if (!counts(least, most)) {
      return one;
    }
    take("?");
    if (!rest_.empty() && (rest_.front() == '*' || rest_.front() == '+')) fail("has a quantifier after a quantifier");
    return repeat(one, least, most);
  }

  /// `{n}`, `{n,}` or `{n,m}`; a `{` that begins none of these stands for itself.
  bool counts(std::uint64_t& least, std::uint64_t& most) {
    const auto close = rest_.find('}');
    if (!rest_.starts_with('{') || close == std::string_view::npos) return false;
    const auto inner = rest_.substr(1, close - 1);
    const auto comma = inner.find(',');
    const auto low = base::parse_uint(inner.substr(0, comma));
    const auto high = comma == std::string_view::npos ? low : base::parse_uint(inner.substr(comma + 1));
    const bool open_ended = comma != std::string_view::npos && comma + 1 == inner.size();
    if (!low || (!high && !open_ended)) return false;
    least = *low;
    most = open_ended ? k_no_limit : high.value_or(0);
    if (least > k_most_repeats || most < least || (!open_ended && most > k_most_repeats)) fail("repeats too often");
    rest_.remove_prefix(std::min(close + 1, rest_.size()));
    return true;
  }

  Piece repeat(const Piece& one, std::uint64_t least, std::uint64_t most) {
    Piece all;
    for (std::uint64_t i = 0; i < least && problem_.empty(); ++i) append_bounded(all, one);
    if (most == k_no_limit) {
      Piece loop{{Op::fork, 1, end_of(one, 2)}};
      append_bounded(loop, one);
      loop.push_back({Op::jump, 0, 0});
      append_bounded(all, loop);
      return all;
    }
    for (std::uint64_t i = least; i < most && problem_.empty(); ++i) {
      Piece maybe{{Op::fork, 1, end_of(one, 1)}};
      append_bounded(maybe, one);
      append_bounded(all, maybe);
    }
    return all;
  }

  Piece atom(int depth) {
    if (take("(")) return group(depth);
    if (take("[")) return one_of(bracket());
    if (take("^")) return {{Op::at_begin, 0, 0}};
    if (take("$")) return {{Op::at_end, 0, 0}};
    if (take(".")) return one_of(~range_set('\n', '\n'));
    if (take("\\")) return one_of(escape());
    const char letter = rest_.front();
    if (letter == '*' || letter == '+' || letter == '?') {
      fail("has a quantifier that follows nothing");
      return {};
    }
    rest_.remove_prefix(1);
    const auto byte = static_cast<unsigned char>(letter);
    return one_of(range_set(byte, byte));
  }

  Piece group(int depth) {
    const bool ahead = take("?=");
    const bool not_ahead = !ahead && take("?!");
    if (!ahead && !not_ahead && !take("?:") && rest_.starts_with('?')) fail("has a kind of group that is not known");
    auto inner = alternatives(depth + 1);
    if (!take(")")) fail("has a `(` without `)`");
    if (!ahead && !not_ahead) return inner;
    Piece look{{ahead ? Op::ahead : Op::not_ahead, 1, end_of(inner, 2)}};
    append_bounded(look, inner);
    look.push_back({});
    return look;
  }

  Piece one_of(const ByteSet& set) {
    classes_.push_back(set);
    return {{Op::byte_of, static_cast<std::uint16_t>(classes_.size() - 1), 0}};
  }

  ByteSet escape() {
    if (rest_.empty()) {
      fail("ends in a backslash");
      return {};
    }
    const char letter = rest_.front();
    rest_.remove_prefix(1);
    switch (letter) {
      case 'd':
        return digits();
      case 'D':
        return ~digits();
      case 'w':
        return word_bytes();
      case 'W':
        return ~word_bytes();
      case 's':
        return blanks();
      case 'S':
        return ~blanks();
      case 't':
        return range_set('\t', '\t');
      case 'n':
        return range_set('\n', '\n');
      case 'r':
        return range_set('\r', '\r');
      case '0':
        return range_set(0, 0);
      case 'x': {
        const auto byte = base::parse_uint(rest_.substr(0, 2), 16);
        if (rest_.size() < 2 || !byte) {
          fail("has `\\x` without two hexadecimal digits");
          return {};
        }
        rest_.remove_prefix(2);
        return range_set(static_cast<unsigned>(*byte), static_cast<unsigned>(*byte));
      }
      default:
        break;
    }
    const auto byte = static_cast<unsigned char>(letter);
    if (word_bytes().test(byte)) fail("has an escape that is not known");
    return range_set(byte, byte);
  }

  ByteSet bracket() {
    const bool inverted = take("^");
    ByteSet set;
    for (bool first = true; first || !rest_.starts_with(']'); first = false) {
      if (rest_.empty()) {
        fail("has a `[` without `]`");
        return {};
      }
      const ByteSet low = bracket_item();
      if (rest_.size() > 1 && rest_[0] == '-' && rest_[1] != ']') {
        take("-");
        const ByteSet high = rest_.empty() ? ByteSet{} : bracket_item();
        if (low.count() != 1 || high.count() != 1) {
          fail("has a range without ends");
          return {};
        }
        set |= range_set(static_cast<unsigned>(low._Find_first()), static_cast<unsigned>(high._Find_first()));
      } else {
        set |= low;
      }
    }
    take("]");
    return inverted ? ~set : set;
  }
  ByteSet bracket_item() {
    if (take("\\")) return escape();
    const auto byte = static_cast<unsigned char>(rest_.front());
    rest_.remove_prefix(1);
    return range_set(byte, byte);
  }

  std::string_view rest_;
  std::vector<ByteSet>& classes_;
  std::string problem_;
};

base::Result<TextPattern> TextPattern::parse(std::string_view pattern) {
  constexpr const char* k_remedy = "write a regular expression of ECMAScript without back references or look-behind";
  if (pattern.size() > k_longest_pattern) return base::Error{"the pattern is longer than 512 bytes", "", "shorten it"};
  TextPattern result;
  result.pattern_ = pattern;
  PatternCompiler compiler(pattern, result.classes_);
  auto steps = compiler.compile();
  if (!steps) return base::Error{"the pattern " + compiler.problem(), "", k_remedy};
  result.steps_ = std::move(*steps);
  return result;
}

/// Follows all ways through the program at once, byte by byte.
class PatternRun {
 public:
  PatternRun(const TextPattern& pattern, std::string_view text) : pattern_(pattern), text_(text) {}

  /// Whether the program from step `start` fits the text at `position`; `anywhere` lets it begin later too.
  bool fits(std::uint16_t start, std::size_t position, bool anywhere) {
    const std::size_t count = pattern_.steps_.size();
    std::vector<std::uint16_t> now;
    std::vector<std::uint16_t> next;
    std::vector<std::size_t> seen(count, 0);
    std::size_t round = 1;
    if (follow(start, position, now, seen, round)) return true;
    for (std::size_t at = position; at < text_.size() && work_ > 0; ++at) {
      ++round;
      next.clear();
      for (const auto index : now) {
        const auto& step = pattern_.steps_[index];
        if (!pattern_.classes_[step.first].test(static_cast<unsigned char>(text_[at]))) continue;
        if (follow(static_cast<std::uint16_t>(index + 1), at + 1, next, seen, round)) return true;
      }
      if (anywhere && follow(start, at + 1, next, seen, round)) return true;
      now.swap(next);
      if (now.empty() && !anywhere) return false;
    }
    return false;
  }

 private:
  /// Adds the steps that wait for a byte and are reached from `start` without one; true when the end is reached.
  bool follow(std::uint16_t start, std::size_t position, std::vector<std::uint16_t>& waiting,
              std::vector<std::size_t>& seen, std::size_t round) {
    using Op = TextPattern::Op;
    std::vector<std::uint16_t> open{start};
    while (!open.empty() && --work_ > 0) {
      const auto index = open.back();
      open.pop_back();
      if (seen[index] == round) continue;
      seen[index] = round;
      const auto& step = pattern_.steps_[index];
      const auto after = static_cast<std::uint16_t>(index + 1);
      switch (step.op) {
        case Op::match:
          return true;
        case Op::byte_of:
          waiting.push_back(index);
          break;
        case Op::fork:
          open.push_back(step.second);
          open.push_back(step.first);
          break;
        case Op::jump:
          open.push_back(step.first);
          break;
        case Op::at_begin:
          if (position == 0) open.push_back(after);
          break;
        case Op::at_end:
          if (position == text_.size()) open.push_back(after);
          break;
        case Op::ahead:
          if (fits(step.first, position, false)) open.push_back(step.second);
          break;
        case Op::not_ahead:
          if (!fits(step.first, position, false)) open.push_back(step.second);
          break;
      }
    }
    return false;
  }

  const TextPattern& pattern_;
  std::string_view text_;
  std::int64_t work_ = k_most_work;
};

bool TextPattern::found_in(std::string_view text) const {
  return PatternRun(*this, text.substr(0, k_longest_subject)).fits(0, 0, true);
}

}  // namespace penpose::decode
