#include "firmware_io/decode/sample/bit_field.h"

#include <algorithm>
#include <optional>
#include <string>

#include "core/base/numbers.h"

namespace penpose::decode {
namespace {

constexpr std::size_t k_longest_field_report = 4096;
constexpr int k_widest = 32;
constexpr std::size_t k_most_words = 64;
constexpr const char* k_test_remedy = "write tests as 1.5, !1.5, 0=02/10, 0!=02, 1&fc=c0 or length>=12";
constexpr const char* k_number_remedy = "write bits lowest first, as in `2 3` or `9.1 3 2`";

std::vector<std::string_view> split(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < text.size();) {
    const auto begin = text.find_first_not_of(' ', at);
    if (begin == std::string_view::npos) break;
    const auto end = std::min(text.find(' ', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    at = end;
  }
  return words;
}

std::optional<std::uint64_t> decimal(std::string_view text, std::uint64_t most) {
  const auto value = base::parse_uint(text);
  if (!value || *value > most) return std::nullopt;
  return value;
}

std::optional<std::uint8_t> hexadecimal(std::string_view text) {
  if (text.empty() || text.size() > 2) return std::nullopt;
  const auto value = base::parse_uint(text, 16);
  if (!value) return std::nullopt;
  return static_cast<std::uint8_t>(*value);
}

base::Error not_a_test(std::string_view text) {
  return {std::string("`").append(text).append("` is no test of a report byte"), "", k_test_remedy};
}
base::Error not_a_number(std::string_view text) {
  return {std::string("`").append(text).append("` is no run of bits"), "", k_number_remedy};
}

struct BitRange {
  std::uint16_t byte = 0;
  std::uint8_t low = 0;
  std::uint8_t high = 7;
};

/// `N`, `N.b` or `N.b-c`.
std::optional<BitRange> parse_range(std::string_view text) {
  BitRange range;
  const auto dot = text.find('.');
  const auto byte = decimal(text.substr(0, dot), k_longest_field_report - 1);
  if (!byte) return std::nullopt;
  range.byte = static_cast<std::uint16_t>(*byte);
  if (dot == std::string_view::npos) return range;
  const auto bits = text.substr(dot + 1);
  const auto dash = bits.find('-');
  const auto low = decimal(bits.substr(0, dash), 7);
  const auto high = dash == std::string_view::npos ? low : decimal(bits.substr(dash + 1), 7);
  if (!low || !high || *low > *high) return std::nullopt;
  range.low = static_cast<std::uint8_t>(*low);
  range.high = static_cast<std::uint8_t>(*high);
  return range;
}

std::uint8_t mask_of(const BitRange& range) {
  return static_cast<std::uint8_t>((0xffU >> (7 - range.high)) & (0xffU << range.low));
}

}  // namespace

base::Result<BitTest::Part> BitTest::parse_part(std::string_view text) {
  Part part;
  const auto equals = text.find('=');
  if (equals == std::string_view::npos) {
    part.wanted = !text.starts_with('!');
    const auto range = parse_range(part.wanted ? text : text.substr(1));
    if (!range || range->low != range->high) return not_a_test(text);
    part.byte = range->byte;
    part.mask = mask_of(*range);
    part.values = part.mask * 0x01010101U;
    return part;
  }
  auto left = text.substr(0, equals);
  if (left.ends_with('!')) {
    part.wanted = false;
    left.remove_suffix(1);
  }
  const auto ampersand = left.find('&');
  const auto byte = decimal(left.substr(0, ampersand), k_longest_field_report - 1);
  if (!byte) return not_a_test(text);
  part.byte = static_cast<std::uint16_t>(*byte);
  if (ampersand != std::string_view::npos) {
    const auto mask = hexadecimal(left.substr(ampersand + 1));
    if (!mask) return not_a_test(text);
    part.mask = *mask;
  }
  int count = 0;
  for (auto rest = text.substr(equals + 1);;) {
    const auto slash = rest.find('/');
    const auto value = hexadecimal(rest.substr(0, slash));
    if (!value || count == 4) return not_a_test(text);
    const int at = 8 * count++;
    // This one and all behind it.
    part.values = (part.values & ~(~0U << at)) | ((*value * 0x01010101U) << at);
    if (slash == std::string_view::npos) return part;
    rest.remove_prefix(slash + 1);
  }
}

base::Result<BitTest> BitTest::parse(std::string_view text) {
  BitTest test;
  const auto words = split(text);
  if (words.size() > k_most_words) return base::Error{"a test of more than 64 parts", "", k_test_remedy};
  for (const auto word : words) {
    if (constexpr std::string_view k_length = "length>="; word.starts_with(k_length)) {
      const auto length = decimal(word.substr(k_length.size()), k_longest_field_report);
      if (!length) return not_a_test(word);
      test.shortest_ = std::max<std::size_t>(test.shortest_, *length);
      test.stated_length_ = std::max<std::size_t>(test.stated_length_, *length);
      continue;
    }
    const auto part = parse_part(word);
    if (!part) return part.error();
    test.parts_.push_back(*part);
    test.shortest_ = std::max<std::size_t>(test.shortest_, part->byte + std::size_t{1});
  }
  return test;
}

base::Status BitNumber::add_run(std::string_view word, int& position) {
  const auto room = [&](int bits) { return position + bits <= k_widest; };
  const base::Error too_wide{"a number of more than 32 bits", "", k_number_remedy};
  if (word.starts_with('_')) {
    const auto gap = decimal(word.substr(1), k_widest);
    if (!gap) return not_a_number(word);
    if (!room(static_cast<int>(*gap))) return too_wide;
    position += static_cast<int>(*gap);
    return base::Done{};
  }
  if (word.find('=') != std::string_view::npos) {
    auto test = BitTest::parse(word);
    if (!test) return test.error();
    if (!room(1)) return too_wide;
    reach_ = std::max(reach_, test->reach());
    flags_.push_back({std::move(test).value(), static_cast<std::uint8_t>(position)});
    ++position;
    return base::Done{};
  }
  const bool inverted = word.starts_with('!');
  const auto range = parse_range(inverted ? word.substr(1) : word);
  if (!range) return not_a_number(word);
  const int bits = range->high - range->low + 1;
  if (!room(bits)) return too_wide;
  Run run;
  run.byte = range->byte;
  run.mask = mask_of(*range);
  run.flip = inverted ? run.mask : std::uint8_t{0};
  run.down = range->low;
  run.up = static_cast<std::uint8_t>(position);
  runs_.push_back(run);
  reach_ = std::max<std::size_t>(reach_, run.byte + std::size_t{1});
  position += bits;
  return base::Done{};
}

void BitNumber::find_shape() {
  if (!flags_.empty() || runs_.empty()) return;
  const auto whole = [](const Run& run) { return run.mask == 0xff && run.flip == 0; };
  if (runs_.size() == 1) {
    shape_ = Shape::one_run;
  } else if (runs_.size() == 2 && whole(runs_[0]) && whole(runs_[1]) && runs_[1].byte == runs_[0].byte + 1 &&
             runs_[0].up == 0 && runs_[1].up == 8) {
    shape_ = Shape::two_bytes;
  } else {
    return;
  }
  first_ = runs_[0];
}

base::Result<BitNumber> BitNumber::parse(std::string_view text) {
  BitNumber number;
  const auto words = split(text);
  if (words.size() > k_most_words) return base::Error{"a number of more than 64 runs", "", k_number_remedy};
  std::size_t at = 0;
  const auto is = [&](std::string_view word) { return at < words.size() && words[at] == word; };
  int position = 0;
  for (; at < words.size() && !is("signed") && !is("negated") && !is("plus") && !is("minus") && !is("if"); ++at) {
    if (words[at] == "|") {
      position = 0;
      continue;
    }
    if (const auto added = number.add_run(words[at], position); !added) return added.error();
    number.width_ = std::max(number.width_, position);
  }
  if (number.width_ == 0) return not_a_number(text);
  if (is("signed")) {
    number.sign_bit_ = std::uint64_t{1} << (number.width_ - 1);
    ++at;
  }
  if (is("negated")) {
    number.negated_ = true;
    ++at;
  }
  if (is("plus") || is("minus")) {
    const auto amount = at + 1 < words.size() ? decimal(words[at + 1], 1'000'000'000) : std::nullopt;
    if (!amount) return not_a_number(text);
    number.offset_ = is("plus") ? static_cast<std::int64_t>(*amount) : -static_cast<std::int64_t>(*amount);
    at += 2;
  }
  if (is("if") && at + 1 < words.size()) {
    const auto begin = static_cast<std::size_t>(words[at + 1].data() - text.data());
    auto gate = BitTest::parse(text.substr(begin));
    if (!gate) return gate.error();
    number.gate_ = std::move(gate).value();
    number.gated_ = true;
    number.reach_ = number.gate_.stated_length() >= number.reach_ ? 0 : std::max(number.reach_, number.gate_.reach());
    at = words.size();
  }
  if (at != words.size()) return not_a_number(text);
  number.find_shape();
  return number;
}

}  // namespace penpose::decode
