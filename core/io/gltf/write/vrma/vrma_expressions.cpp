#include "core/io/gltf/write/vrma/vrma_expressions.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/numbers.h"
#include "core/document/expressions.h"
#include "core/document/time/animation_sampling.h"

namespace penpose::io {
namespace {

using document::Channel;
using document::ChannelTarget;
using document::Interpolation;

/// Numbers that the weights of expressions may be found from, all keys together.
constexpr std::size_t k_most_numbers = 36'000'000;
/// A weight below this is none.
constexpr double k_no_weight = 1e-4;

/// One control of expressions' weights: an expression, or a control that is in none.
struct Column {
  std::string name;
  std::vector<std::pair<std::size_t, double>> values;
  bool control = false;  ///< of that name, and no expression
  double square = 0;     ///< sum of the squares of the values
  std::vector<float> weights;
};

std::vector<Column> columns_of(const document::Model& model) {
  const std::size_t weights = document::weight_count(model);
  std::vector<Column> columns;
  std::vector<bool> covered(weights, false);
  for (const document::Expression& one : model.expressions) {
    Column column{one.name, one.values, false, 0, {}};
    std::erase_if(column.values, [&](const auto& value) { return value.first >= weights; });
    // Where eyes look is the gaze.
    const std::string_view preset = document::preset_of(one.name);
    if (column.values.empty() || preset.starts_with("look")) continue;
    for (const auto& value : column.values) covered[value.first] = true;
    columns.push_back(std::move(column));
  }
  // Those of few targets come first: a blink of one eye before that of both.
  std::stable_sort(columns.begin(), columns.end(),
                   [](const Column& a, const Column& b) { return a.values.size() < b.values.size(); });
  for (std::size_t i = 0; i < weights; ++i) {
    if (!covered[i]) columns.push_back({model.rig->parameters()[i].name, {{i, 1.0}}, true, 0, {}});
  }
  for (Column& column : columns) {
    for (const auto& value : column.values) column.square += value.second * value.second;
  }
  std::erase_if(columns, [](const Column& column) { return !(column.square > 1e-12); });
  return columns;
}

/// The weights within 0..1 whose sum of targets is nearest to what is left of it, by coordinate descent from 0.
void fit(std::vector<Column>& columns, std::vector<double>& left) {
  constexpr int k_rounds = 24;
  std::vector<double> weights(columns.size(), 0.0);
  for (int round = 0; round < k_rounds; ++round) {
    double moved = 0;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      double product = 0;
      for (const auto& [target, value] : columns[c].values) product += value * left[target];
      const double next = std::clamp(weights[c] + product / columns[c].square, 0.0, 1.0);
      const double step = next - weights[c];
      if (step == 0) continue;
      for (const auto& [target, value] : columns[c].values) left[target] -= step * value;
      weights[c] = next;
      moved = std::max(moved, std::abs(step));
    }
    if (moved < 1e-7) break;
  }
  for (std::size_t c = 0; c < columns.size(); ++c) columns[c].weights.push_back(static_cast<float>(weights[c]));
}

void write_column(const Column& column, const std::vector<double>& times, Interpolation interpolation,
                  VrmaBuilder& file) {
  const bool shown = std::any_of(column.weights.begin(), column.weights.end(),
                                 [](float weight) { return static_cast<double>(weight) > k_no_weight; });
  if (!shown) return;
  std::string name(document::preset_of(column.name));
  // Controls keep their names, by which they are found again.
  if (column.control && name != column.name) name.clear();
  const char* group = name.empty() ? "custom" : "preset";
  if (name.empty()) name = column.name;
  json::Json& members = file.own["expressions"][group];
  if (members.contains(name)) {
    file.notes.push_back("expression " + column.name + " is left out: another is \"" + name + "\" in VRM");
    return;
  }
  const std::size_t node = file.add_node(name, {0, 0, 0}, std::nullopt);
  members[name] = {{"node", node}};
  std::vector<float> values;
  for (const float weight : column.weights) values.insert(values.end(), {weight, 0.0F, 0.0F});
  file.add_keys(times, interpolation, values, "VEC3", node, "translation");
}

void note_worst(const document::Model& model, const std::vector<double>& worst, VrmaBuilder& file) {
  std::size_t count = 0;
  std::size_t most = 0;
  for (std::size_t i = 0; i < worst.size(); ++i) {
    count += worst[i] > 0.01 ? 1 : 0;
    if (worst[i] > worst[most]) most = i;
  }
  if (count == 0) return;
  file.notes.push_back("the weights of " + std::to_string(count) +
                       " controls are no sum of expressions; the farthest off is " +
                       model.rig->parameters()[most].name + ", by " + base::format_fixed(worst[most], 2));
}

}  // namespace

base::Status write_vrma_expressions(const document::Model& model, const document::Animation* animation,
                                    VrmaBuilder& file) {
  const std::size_t width = document::weight_count(model);
  if (width == 0) return base::Done{};
  std::vector<const Channel*> moved;
  for (std::size_t c = 0; animation != nullptr && c < animation->channels.size(); ++c) {
    const Channel& channel = animation->channels[c];
    if (channel.target == ChannelTarget::weights && !channel.times_s.empty()) moved.push_back(&channel);
  }
  if (moved.size() > 1) moved.resize(1);
  const std::vector<double> times = moved.empty() ? std::vector<double>{0.0} : key_times(moved);
  std::vector<Column> all = columns_of(model);
  std::size_t cost = width;
  for (const Column& column : all) cost += column.values.size();
  if (times.size() > k_most_numbers / cost) {
    return base::Error{"the animation has more keys than a VRM animation can be made of", "",
                       "make it shorter, or its frame rate lower"};
  }
  std::vector<double> worst(width, 0.0);
  for (const double time : times) {
    std::vector<double> left;
    if (!moved.empty()) left = document::sample_channel(*moved.front(), width, time);
    if (left.size() != width) left.assign(model.pose.begin(), model.pose.begin() + static_cast<std::ptrdiff_t>(width));
    fit(all, left);
    for (std::size_t i = 0; i < width; ++i) worst[i] = std::max(worst[i], std::abs(left[i]));
  }
  note_worst(model, worst, file);
  const bool steps = !moved.empty() && moved.front()->interpolation == Interpolation::step;
  for (const Column& column : all)
    write_column(column, times, steps ? Interpolation::step : Interpolation::linear, file);
  return base::Done{};
}

}  // namespace penpose::io
