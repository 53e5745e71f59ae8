#include "core/io/tracks/values/value_names.h"

#include <algorithm>
#include <set>

#include "core/io/tracks/arkit/arkit_names.h"
#include "core/rig/control_names.h"

namespace penpose::io {
namespace {

std::set<std::string, std::less<>> folded_set(const auto& names) {
  std::set<std::string, std::less<>> folded;
  for (const char* name : names) folded.insert(rig::folded_name(name));
  return folded;
}

bool is_turn(std::string_view name) {
  static const auto turns = folded_set(k_arkit_turns);
  return turns.contains(rig::folded_name(name));
}

}  // namespace

bool is_arkit_shape(std::string_view name) {
  static const auto shapes = folded_set(k_arkit_shapes);
  return shapes.contains(rig::folded_name(name));
}

std::vector<std::string> plain_names(const std::vector<std::string_view>& names) {
  const auto is_known = [](std::string_view name) { return is_arkit_shape(name) || is_turn(name); };
  std::vector<std::string_view> unknown;
  for (const std::string_view name : names) {
    if (!is_known(name)) unknown.push_back(name);
  }
  const auto prefixes = unknown.empty() ? std::vector<std::string>() : rig::shared_prefixes(unknown);
  // A prefix that more than half of the names share ends as an object's name does: mouthSmile and mouthFrown share
  // none.
  std::string common;
  for (const std::string& prefix : prefixes) {
    const bool object =
        prefix.ends_with('.') || prefix.ends_with(':') || prefix.ends_with('|') || prefix.ends_with("__");
    const auto count =
        std::count_if(names.begin(), names.end(), [&](std::string_view n) { return n.starts_with(prefix); });
    if (object && 2 * static_cast<std::size_t>(count) > names.size() && names.size() > 1) common = prefix;
    if (!common.empty()) break;
  }
  std::vector<std::string> plain;
  for (const std::string_view name : names) {
    std::string_view own = name;
    for (const std::string& prefix : prefixes) {
      if (is_known(name) || !name.starts_with(prefix)) continue;
      if (!is_known(name.substr(prefix.size())) && prefix != common) continue;
      own = name.substr(prefix.size());
      break;
    }
    plain.emplace_back(own);
  }
  return plain;
}

}  // namespace penpose::io
