#include "core/rig/control_names.h"

#include <algorithm>
#include <map>

namespace penpose::rig {
namespace {

constexpr std::size_t k_longest_prefix = 96;

bool is_small(char c) { return c >= 'a' && c <= 'z'; }
bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_other_script(char c) { return static_cast<unsigned char>(c) >= 0x80; }
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
  if (!sides.empty() || longer.empty()) return sides;
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
  return exact.empty() ? sides : exact;
}

}  // namespace penpose::rig
