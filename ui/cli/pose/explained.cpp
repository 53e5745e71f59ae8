#include "ui/cli/pose/explained.h"

#include <algorithm>
#include <vector>

#include "core/base/numbers.h"
#include "core/base/text/shown_text.h"

namespace penpose::cli {
namespace {

using inference::Term;

/// Readings that are shown, and controls of each that are named.
constexpr std::size_t k_shown = 6;
constexpr std::size_t k_named = 6;

std::string padded(std::string text, std::size_t width) {
  return std::string(text.size() < width ? width - text.size() : 0, ' ') + text;
}

/// What a reading moves, the most first.
std::vector<std::pair<double, std::string>> moved_by(const rig::Pose& pose, const rig::Rig& rig) {
  std::vector<std::pair<double, std::string>> moved;
  for (std::size_t i = 0; i < pose.size(); ++i) {
    const rig::Parameter& parameter = rig.parameters()[i];
    if (pose[i] == parameter.rest) continue;
    const double share = (pose[i] - parameter.rest) / (parameter.maximum - parameter.minimum);
    moved.emplace_back(share, base::shown_name(parameter.name) + " " + base::format_fixed(pose[i], 2));
  }
  std::stable_sort(moved.begin(), moved.end(),
                   [](const auto& a, const auto& b) { return std::abs(a.first) > std::abs(b.first); });
  return moved;
}

}  // namespace

std::string explained_table(std::span<const intent::ExplainedReading> readings, const rig::Rig& rig,
                            const inference::Weights& table) {
  readings = readings.first(std::min(k_shown, readings.size()));
  if (readings.empty()) return "    no line on a face: nothing to explain\n";
  const inference::Terms& weights = table.by;
  constexpr std::size_t k_name = 16, k_column = 10;
  std::string text = "    " + padded("", k_name);
  for (std::size_t i = 0; i < readings.size(); ++i) text += padded("reading " + std::to_string(i + 1), k_column);
  text += "    weight\n";
  for (std::size_t k = 0; k < inference::k_term_count; ++k) {
    const auto term = static_cast<Term>(k);
    const auto is_zero = [&](const auto& one) { return one.terms[term] * weights[term] == 0.0; };
    if (std::all_of(readings.begin(), readings.end(), is_zero)) continue;
    text += "    " + padded(inference::name_of(term), k_name);
    for (const auto& one : readings) text += padded(base::format_fixed(one.terms[term] * weights[term], 2), k_column);
    text += padded(base::format_fixed(weights[term], 2), k_column) + "\n";
  }
  text += "    " + padded("energy", k_name);
  for (const auto& one : readings) text += padded(base::format_fixed(one.energy, 2), k_column);
  text += "\n    " + padded("probability", k_name);
  for (const auto& one : readings) text += padded(base::format_fixed(100.0 * one.probability, 1) + " %", k_column);
  text += "\n";
  for (std::size_t i = 0; i < readings.size(); ++i) {
    text += "    reading " + std::to_string(i + 1) + ":";
    const auto moved = moved_by(readings[i].pose, rig);
    for (std::size_t k = 0; k < std::min(k_named, moved.size()); ++k) text += (k > 0 ? ", " : " ") + moved[k].second;
    if (moved.size() > k_named) text += " and " + std::to_string(moved.size() - k_named) + " more";
    text += moved.empty() ? " nothing moves\n" : "\n";
  }
  return text;
}

json::Json explained_json(std::span<const intent::ExplainedReading> readings, const rig::Rig& rig,
                          const inference::Weights& table) {
  const inference::Terms& weights = table.by;
  json::Json out = json::Json::array();
  for (const intent::ExplainedReading& one : readings) {
    json::Json parameters = json::Json::object();
    for (std::size_t i = 0; i < one.pose.size(); ++i) {
      if (one.pose[i] != rig.parameters()[i].rest) parameters[rig.parameters()[i].name] = one.pose[i];
    }
    json::Json terms = json::Json::object();
    for (std::size_t k = 0; k < inference::k_term_count; ++k) {
      const auto term = static_cast<Term>(k);
      json::Json pair = json::Json::array();
      pair.push_back(one.terms[term]);
      pair.push_back(weights[term]);
      terms[inference::name_of(term)] = std::move(pair);
    }
    out.push_back({{"energy", one.energy},
                   {"probability", one.probability},
                   {"parameters", std::move(parameters)},
                   {"terms", std::move(terms)}});
  }
  return out;
}

}  // namespace penpose::cli
