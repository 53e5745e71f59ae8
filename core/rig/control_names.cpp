#include "core/rig/control_names.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "core/rig/names/face_names.h"
#include "core/rig/names/name_letters.h"

namespace penpose::rig {
namespace {

constexpr std::size_t k_longest_prefix = 96;

bool is_letter(char c) { return is_small(c) || is_capital(c) || is_other_script(c); }

/// Whether a name may begin at `at`, after a prefix.
bool begins_at(std::string_view name, std::size_t at) {
  const char before = name[at - 1];
  const char first = name[at];
  if (!is_letter(first)) return false;
  if (!is_letter(before) && !is_digit(before)) return true;
  return is_capital(first) && (is_small(before) || is_digit(before));
}

/// Whether what ends there is an object's name by the way of writing alone.
bool ends_object(std::string_view prefix) {
  return prefix.ends_with('.') || prefix.ends_with(':') || prefix.ends_with('|') || prefix.ends_with("__");
}

enum class Match : std::uint8_t { none, exact, side };

/// How a folded name answers to a folded name that is asked for.
Match match(std::string_view own, std::string_view wanted) {
  if (own == wanted) return Match::exact;
  const bool sided =
      own.size() == wanted.size() + 1 && own.starts_with(wanted) && (own.back() == 'l' || own.back() == 'r');
  return sided ? Match::side : Match::none;
}

/// The meaning of a name, with or without a prefix that it shares with others.
std::optional<FaceName> meaning_of(std::string_view name, std::span<const std::string> prefixes) {
  if (auto own = face_name(name)) return own;
  for (const std::string& prefix : prefixes) {
    if (!name.starts_with(prefix)) continue;
    if (auto own = face_name(name.substr(prefix.size()))) return own;
  }
  return std::nullopt;
}

/// The controls whose name means what a name means.
std::vector<std::size_t> controls_meaning(std::span<const Parameter> parameters, std::string_view name,
                                          std::span<const std::string> prefixes) {
  const auto wanted = face_name(name);
  if (!wanted) return {};
  constexpr std::array k_sides{Side::none, Side::left, Side::right};
  std::array<std::vector<std::size_t>, 3> found;  // one a side
  std::array<std::size_t, 3> rank{};
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const auto own = meaning_of(parameters[i].name, prefixes);
    if (!own || own->meaning != wanted->meaning) continue;
    const auto side = static_cast<std::size_t>(std::find(k_sides.begin(), k_sides.end(), own->side) - k_sides.begin());
    if (!found[side].empty() && own->rank > rank[side]) continue;
    if (!found[side].empty() && own->rank < rank[side]) found[side].clear();
    rank[side] = own->rank;
    found[side].push_back(i);
  }
  const auto& [both, left, right] = found;
  if (wanted->side == Side::left) return left.empty() ? both : left;
  if (wanted->side == Side::right) return right.empty() ? both : right;
  if (!both.empty()) return both;
  std::vector<std::size_t> sides = left;
  sides.insert(sides.end(), right.begin(), right.end());
  std::stable_sort(sides.begin(), sides.end());
  return sides;
}

}  // namespace

std::string folded_name(std::string_view name) {
  std::string folded;
  for (const char c : name) {
    if (is_capital(c)) folded += static_cast<char>(c - 'A' + 'a');
    if (is_small(c) || is_digit(c) || is_other_script(c)) folded += c;
  }
  for (const std::string_view side : {"left", "right"}) {
    if (folded.size() > side.size() && folded.ends_with(side)) folded.erase(folded.size() - side.size() + 1);
  }
  return folded;
}

std::vector<std::string> shared_prefixes(std::span<const std::string_view> names) {
  std::map<std::string_view, std::size_t> counts;
  for (const std::string_view name : names) {
    const std::size_t most = std::min(name.size(), k_longest_prefix);
    for (std::size_t i = 1; i < most; ++i) {
      if (begins_at(name, i)) ++counts[name.substr(0, i)];
    }
  }
  std::vector<std::string> prefixes;
  for (const auto& [prefix, count] : counts) {
    if (count >= 2 || ends_object(prefix)) prefixes.emplace_back(prefix);
  }
  std::stable_sort(prefixes.begin(), prefixes.end(),
                   [](const std::string& a, const std::string& b) { return a.size() > b.size(); });
  return prefixes;
}

std::vector<std::size_t> controls_named(std::span<const Parameter> parameters, std::string_view name) {
  const std::string wanted = folded_name(name);
  std::vector<std::size_t> exact;
  std::vector<std::size_t> sides;
  if (wanted.empty()) return exact;
  std::vector<std::size_t> longer;  // those that a prefix may hide
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string own = folded_name(parameters[i].name);
    const Match found = match(own, wanted);
    if (found == Match::exact) exact.push_back(i);
    if (found == Match::side) sides.push_back(i);
    const bool ends = own.ends_with(wanted) || own.ends_with(wanted + "l") || own.ends_with(wanted + "r");
    if (found == Match::none && ends) longer.push_back(i);
  }
  if (!exact.empty()) return exact;
  if (!sides.empty()) return sides;
  if (longer.empty() && !face_name(name)) return sides;
  std::vector<std::string_view> names;
  for (const Parameter& parameter : parameters) names.emplace_back(parameter.name);
  const auto prefixes = shared_prefixes(names);
  for (const std::size_t i : longer) {
    const std::string_view own = names[i];
    for (const std::string& prefix : prefixes) {
      if (!own.starts_with(prefix)) continue;
      const Match found = match(folded_name(own.substr(prefix.size())), wanted);
      if (found == Match::exact) exact.push_back(i);
      if (found == Match::side) sides.push_back(i);
      if (found != Match::none) break;
    }
  }
  if (!exact.empty()) return exact;
  return sides.empty() ? controls_meaning(parameters, name, prefixes) : sides;
}

}  // namespace penpose::rig
