#include "core/rig/names/face_names.h"

#include <algorithm>
#include <array>
#include <map>

#include "core/rig/names/name_letters.h"

namespace penpose::rig {

std::string_view embedded_face_names();

namespace {

constexpr std::array<std::string_view, 5> k_left{"left", "l", "lf", "lft", "左"};
constexpr std::array<std::string_view, 5> k_right{"right", "r", "rt", "rgt", "右"};
/// Words that programs write before and behind a name.
constexpr std::array<std::string_view, 17> k_around{"ctrl", "expressions", "facs",  "bs",     "jnt",        "ectrl",
                                                    "vrc",  "blend",       "shape", "shapes", "blendshape", "v2",
                                                    "ft",   "div2",        "cbs",   "exp",    "morph"};

Side side_of(std::string_view word) {
  if (std::find(k_left.begin(), k_left.end(), word) != k_left.end()) return Side::left;
  if (std::find(k_right.begin(), k_right.end(), word) != k_right.end()) return Side::right;
  return Side::none;
}

/// Takes a side out of a word of another script: まばたき左 is two words.
void push_word(std::vector<std::string>& words, std::string word) {
  for (const std::string_view side : {k_left.back(), k_right.back()}) {
    if (word.size() > side.size() && word.ends_with(side)) {
      words.push_back(word.substr(0, word.size() - side.size()));
      words.emplace_back(side);
      return;
    }
    if (word.size() > side.size() && word.starts_with(side)) {
      words.emplace_back(side);
      words.push_back(word.substr(side.size()));
      return;
    }
  }
  words.push_back(std::move(word));
}

/// The words of a name in small letters: Eye_Blink_L, eyeBlinkL and "eye blink l" are three. Letters of other scripts
/// stay together. A full stop at the end stays, as the table tells "mouth cue E" from "mouth cue E.".
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  std::string word;
  const auto end_word = [&] {
    if (!word.empty()) push_word(words, std::move(word));
    word.clear();
  };
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (!is_small(c) && !is_capital(c) && !is_digit(c) && !is_other_script(c)) {
      if (c == '.' && i + 1 == name.size()) word += c;
      end_word();
      continue;
    }
    const char before = i > 0 ? name[i - 1] : ' ';
    const bool next_small = i + 1 < name.size() && is_small(name[i + 1]);
    const bool begins = is_capital(c) && (is_small(before) || is_digit(before) || (is_capital(before) && next_small));
    if (begins || is_other_script(c) != is_other_script(before)) end_word();
    word += is_capital(c) ? static_cast<char>(c - 'A' + 'a') : c;
  }
  end_word();
  return words;
}

/// "A14", "14", "bs3": a number that counts the shapes of a file.
bool is_numbered(std::string_view word) {
  if (word.empty() || !is_digit(word.back()) || word.size() > 4) return false;
  return std::count_if(word.begin(), word.end(), [](char c) { return !is_digit(c); }) <= 1;
}

std::string joined(std::span<const std::string> words, std::size_t without) {
  std::string key;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i != without) key += words[i];
  }
  return key;
}

struct Table {
  std::vector<FaceMeaning> meanings;
  std::map<std::string, FaceName, std::less<>> names;  ///< by their words joined
};

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> pieces;
  while (true) {
    const std::size_t end = std::min(text.find(at), text.size());
    pieces.push_back(text.substr(0, end));
    if (end == text.size()) return pieces;
    text.remove_prefix(end + 1);
  }
}

void add_names(Table& table, std::size_t meaning) {
  const auto& names = table.meanings[meaning].names;
  for (std::size_t rank = 0; rank < names.size(); ++rank) {
    std::string_view name = names[rank];
    Side side = Side::none;
    if (const std::size_t at = name.find('>'); at != std::string_view::npos) {
      side = name.substr(at + 1) == "L" ? Side::left : Side::right;
      name = name.substr(0, at);
    }
    const std::string key = joined(words_of(name), std::string_view::npos);
    table.names.emplace(key, FaceName{meaning, side, rank});
  }
}

Table read_table() {
  Table table;
  for (const std::string_view line : split(embedded_face_names(), '\n')) {
    if (line.empty() || line.front() == '#') continue;
    const auto columns = split(line, '\t');
    const auto given = [&](std::size_t i) { return columns[i] == "-" ? std::string_view() : columns[i]; };
    FaceMeaning one{std::string(columns[0]), std::string(given(1)), {}, columns[3]};
    for (const std::string_view name : split(given(2), ' ')) {
      if (!name.empty()) one.names.push_back(name);
    }
    table.meanings.push_back(std::move(one));
    add_names(table, table.meanings.size() - 1);
  }
  return table;
}

const Table& table() {
  static const Table read = read_table();
  return read;
}

std::optional<FaceName> named(const std::string& key, Side side) {
  const auto found = table().names.find(key);
  if (found == table().names.end()) return std::nullopt;
  FaceName one = found->second;
  if (one.side != Side::none && side != Side::none && one.side != side) return std::nullopt;
  if (one.side == Side::none) one.side = side;
  return one;
}

/// The words as they stand, then without a side: the last word that may be one, the first, then those between.
std::optional<FaceName> name_of(std::span<const std::string> words) {
  if (words.empty()) return std::nullopt;
  const std::string whole = joined(words, std::string_view::npos);
  if (const auto found = named(whole, Side::none)) return found;
  std::vector<std::size_t> order;
  for (std::size_t i = words.size(); i-- > 0;) order.push_back(i);
  if (order.size() > 2) std::swap(order[1], order.back());
  for (const std::size_t i : order) {
    const Side side = side_of(words[i]);
    if (side == Side::none) continue;
    if (const auto found = named(joined(words, i), side)) return found;
  }
  for (const auto& [end, side] : {std::pair<std::string_view, Side>{"left", Side::left}, {"right", Side::right}}) {
    if (!whole.ends_with(end)) continue;
    if (const auto found = named(whole.substr(0, whole.size() - end.size()), side)) return found;
  }
  return std::nullopt;
}

}  // namespace

std::span<const FaceMeaning> face_meanings() { return table().meanings; }

std::optional<FaceName> face_name(std::string_view name) {
  std::vector<std::string> words = words_of(name);
  if (const auto found = name_of(words)) return found;
  std::erase_if(words, [](const std::string& word) {
    return std::find(k_around.begin(), k_around.end(), word) != k_around.end();
  });
  if (words.size() > 1 && is_numbered(words.front())) words.erase(words.begin());
  return name_of(words);
}

}  // namespace penpose::rig
