#include "core/phonetics/phones.h"

#include <algorithm>
#include <map>
#include <utility>

#include "core/base/text/letters.h"

namespace penpose::speech {
namespace {

constexpr std::size_t k_most_words = 20000;

/// The longest that fits comes first.
constexpr std::pair<std::string_view, std::string_view> k_spellings[]{
    {"tch", "CH"}, {"igh", "AY"}, {"ch", "CH"}, {"sh", "SH"}, {"th", "TH"}, {"ph", "F"},  {"wh", "W"},  {"ck", "K"},
    {"ng", "NG"},  {"qu", "K W"}, {"oo", "UW"}, {"ou", "AW"}, {"ow", "OW"}, {"oy", "OY"}, {"oi", "OY"}, {"ee", "IY"},
    {"ea", "IY"},  {"ai", "EY"},  {"ay", "EY"}, {"au", "AO"}, {"aw", "AO"}, {"er", "ER"}, {"bb", "B"},  {"pp", "P"},
    {"mm", "M"},   {"ff", "F"},   {"ll", "L"},  {"ss", "S"},  {"tt", "T"},  {"a", "AE"},  {"b", "B"},   {"c", "K"},
    {"d", "D"},    {"e", "EH"},   {"f", "F"},   {"g", "G"},   {"h", "HH"},  {"i", "IH"},  {"j", "JH"},  {"k", "K"},
    {"l", "L"},    {"m", "M"},    {"n", "N"},   {"o", "AA"},  {"p", "P"},   {"q", "K"},   {"r", "R"},   {"s", "S"},
    {"t", "T"},    {"u", "AH"},   {"v", "V"},   {"w", "W"},   {"x", "K S"}, {"y", "IY"},  {"z", "Z"},
};

void append_phonemes(std::vector<std::string>& out, std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of(" \t\r"), text.size());
    std::string_view one = text.substr(0, end);
    while (!one.empty() && one.back() >= '0' && one.back() <= '9') one.remove_suffix(1);
    if (!one.empty() && one.size() <= 2) out.emplace_back(one);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

}  // namespace

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words(1);
  for (const char c : text) {
    const char letter = base::lower(c);
    const bool is_letter = letter >= 'a' && letter <= 'z';
    if (is_letter || (c == '\'' && !words.back().empty())) {
      words.back() += letter;
    } else if (!words.back().empty()) {
      if (words.size() == k_most_words) return words;
      words.emplace_back();
    }
  }
  if (words.back().empty()) words.pop_back();
  return words;
}

std::vector<std::string> spelt(std::string_view word) {
  std::vector<std::string> out;
  while (!word.empty()) {
    const auto* found = std::find_if(std::begin(k_spellings), std::end(k_spellings),
                                     [&](const auto& one) { return word.starts_with(one.first); });
    if (found == std::end(k_spellings)) {
      word.remove_prefix(1);
      continue;
    }
    append_phonemes(out, found->second);
    word.remove_prefix(found->first.size());
  }
  return out;
}

std::vector<SaidWord> said_words(std::string_view text, base::Bytes dictionary) {
  return said_list(words_of(text), dictionary);
}

std::vector<SaidWord> said_list(const std::vector<std::string>& words, base::Bytes dictionary) {
  std::map<std::string, std::vector<std::string>, std::less<>> said;
  for (const std::string& word : words) said.emplace(word, std::vector<std::string>());
  std::string_view lines = base::as_text(dictionary);
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    const std::string_view line = lines.substr(0, end);
    lines.remove_prefix(std::min(end + 1, lines.size()));
    const std::size_t gap = line.find_first_of(" \t");
    if (gap == std::string_view::npos) continue;
    const auto found = said.find(line.substr(0, gap));
    if (found != said.end() && found->second.empty()) append_phonemes(found->second, line.substr(gap + 1));
  }
  std::vector<SaidWord> out;
  for (const std::string& word : words) {
    const auto& known = said.find(word)->second;
    out.push_back({word, known.empty() ? spelt(word) : known});
  }
  return out;
}

std::vector<std::string> phonemes_of(std::string_view text, base::Bytes dictionary) {
  std::vector<std::string> out;
  for (const SaidWord& one : said_words(text, dictionary))
    out.insert(out.end(), one.phonemes.begin(), one.phonemes.end());
  return out;
}

std::vector<Phone> with_stops(const std::vector<Phone>& said, const std::vector<Phone>& heard) {
  const auto meet = [](const Phone& a, const Phone& b) { return a.from_s < b.to_s && a.to_s > b.from_s; };
  std::vector<Phone> out = said;
  for (Phone stop : heard) {
    if (stop.name != "P" || stop.to_s - stop.from_s < k_least_stop_s) continue;
    const bool known = std::any_of(out.begin(), out.end(), [&](const Phone& one) {
      return meet(one, stop) && (one.name == "P" || one.name == "B" || one.name == "M");
    });
    if (known) continue;
    std::vector<Phone> before;
    std::vector<Phone> after;
    for (const Phone& one : out) {
      Phone left = one;
      left.to_s = std::min(left.to_s, stop.from_s);
      Phone right = one;
      right.from_s = std::max(right.from_s, stop.to_s);
      const bool begins = left.from_s < left.to_s;
      if (begins) before.push_back(left);
      if (!begins && meet(one, stop) && stop.word.empty()) stop.word = one.word;
      if (begins || meet(one, stop)) right.word.clear();
      if (right.from_s < right.to_s) after.push_back(right);
    }
    before.push_back(stop);
    before.insert(before.end(), after.begin(), after.end());
    out = std::move(before);
  }
  return out;
}

std::vector<HeardWord> words_heard(const std::vector<Phone>& phones) {
  std::vector<HeardWord> words;
  bool goes_on = false;
  for (const Phone& phone : phones) {
    if (!phone.word.empty()) words.push_back({phone.word, phone.from_s, phone.to_s});
    goes_on = !phone.word.empty() || (goes_on && !phone.name.empty());
    if (goes_on) words.back().to_s = phone.to_s;
  }
  return words;
}

}  // namespace penpose::speech
