#include "ui/app/input/side_pairs.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace penpose::app {
namespace {

/// A stroke of one side moves the other by less than this share.
constexpr double k_one_sided = 0.35;
/// Shares of a range that are no movement.
constexpr double k_moved_pair = 1e-6;

double range_of(const rig::Parameter& parameter) { return std::max(1e-12, parameter.maximum - parameter.minimum); }

/// The word of a side at the beginning of what differs between two names.
std::size_t side_word(std::string_view text) {
  for (const std::string_view word : {"left", "right", "Left", "Right", "LEFT", "RIGHT"}) {
    if (text.starts_with(word)) return word.size();
  }
  return text.empty() ? 0 : 1;
}

}  // namespace

std::vector<std::size_t> two_sided(std::vector<std::size_t> pairs, std::span<const std::size_t> partner) {
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (i >= partner.size() || partner[i] != pairs[i]) pairs[i] = k_no_pair;
  }
  return pairs;
}

std::string common_name(const std::string& first, const std::string& second) {
  const auto differs = std::mismatch(first.begin(), first.end(), second.begin(), second.end());
  const auto at = static_cast<std::size_t>(differs.first - first.begin());
  std::string head = first.substr(0, at);
  const std::string_view rest = std::string_view(first).substr(at);
  std::string tail(rest.substr(side_word(rest)));
  const auto separates = [](char c) { return c == '_' || c == '.' || c == '-' || c == ' '; };
  while (!head.empty() && separates(head.back()) && (tail.empty() || separates(tail.front()))) head.pop_back();
  while (head.empty() && !tail.empty() && separates(tail.front())) tail.erase(tail.begin());
  const std::string common = head + tail;
  return common.empty() ? first : common;
}

bool is_left(const std::string& name, const std::string& other) {
  const auto differs = std::mismatch(name.begin(), name.end(), other.begin(), other.end());
  return differs.first != name.end() && (*differs.first == 'l' || *differs.first == 'L');
}

rig::Pose copied_over(std::span<const rig::Parameter> parameters, std::span<const std::size_t> pairs,
                      const rig::Pose& pose, std::size_t count, bool from_left) {
  rig::Pose out = pose;
  for (std::size_t i = 0; i < std::min(count, pose.size()); ++i) {
    if (pairs[i] == k_no_pair || is_left(parameters[i].name, parameters[pairs[i]].name) == from_left) continue;
    out[i] = poses::fitted(parameters[i], pose[pairs[i]]);
  }
  return out;
}

std::optional<rig::Pose> on_both_sides(std::span<const rig::Parameter> parameters, std::span<const std::size_t> pairs,
                                       const rig::Pose& before, const rig::Pose& now, std::size_t count) {
  double left = 0;
  double right = 0;
  count = std::min({count, before.size(), now.size(), pairs.size()});
  for (std::size_t i = 0; i < count; ++i) {
    if (pairs[i] == k_no_pair) continue;
    const double by = std::abs(now[i] - before[i]) / range_of(parameters[i]);
    (is_left(parameters[i].name, parameters[pairs[i]].name) ? left : right) += by;
  }
  if (std::max(left, right) < k_moved_pair || std::min(left, right) > k_one_sided * std::max(left, right)) {
    return std::nullopt;
  }
  rig::Pose out = now;
  bool differs = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (pairs[i] == k_no_pair || is_left(parameters[i].name, parameters[pairs[i]].name) == (left > right)) continue;
    const std::size_t from = pairs[i];
    // Only what was drawn: the rest of a face need not be symmetric.
    if (std::abs(now[from] - before[from]) < k_moved_pair * range_of(parameters[from])) continue;
    out[i] = poses::fitted(parameters[i], now[from]);
    differs = differs || out[i] != now[i];
  }
  if (!differs) return std::nullopt;
  return out;
}

document::SetParameters values_between(std::span<const rig::Parameter> parameters, const rig::Pose& from,
                                       const rig::Pose& to) {
  document::SetParameters command;
  for (std::size_t i = 0; i < std::min({parameters.size(), from.size(), to.size()}); ++i) {
    if (from[i] != to[i]) command.values.push_back({parameters[i].name, to[i]});
  }
  return command;
}

}  // namespace penpose::app
