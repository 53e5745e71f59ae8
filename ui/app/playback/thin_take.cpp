#include "ui/app/playback/thin_take.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/document/time/thinning.h"
#include "core/document/time/timeline.h"

namespace penpose::app {
namespace {

using document::KeyPoses;
using document::Timeline;

/// The take, and the keys before and behind it, which shape its curves.
struct Rows {
  std::vector<double> times_s;
  std::vector<rig::Pose> poses;
  std::vector<std::size_t> fixed;  ///< numbers of those that border on the take
};

std::vector<std::size_t> numbers_of(const document::Document& document, const std::vector<std::string>& names) {
  std::vector<std::size_t> numbers;
  for (const std::string& name : names) {
    if (const auto number = rig::find_parameter(document.model->rig->parameters(), name)) numbers.push_back(*number);
  }
  return numbers;
}

Rows rows_of(const document::Document& document, const KeyPoses& all, const std::vector<std::size_t>& numbers) {
  const Timeline& timeline = *document.timeline;
  Rows rows;
  const auto add = [&](double time_s, rig::Pose pose, bool fixed) {
    if (fixed) rows.fixed.push_back(rows.times_s.size());
    rows.times_s.push_back(time_s);
    rows.poses.push_back(std::move(pose));
  };
  const auto keyed = [&](const document::PoseKey& key) {
    return std::any_of(numbers.begin(), numbers.end(), [&](std::size_t p) { return key.controls.has(p); });
  };
  const document::PoseKey* before = nullptr;
  const document::PoseKey* after = nullptr;
  for (const document::PoseKey& key : timeline.keys) {
    if (!keyed(key)) continue;
    if (key.time_s < all.times_s.front()) before = &key;
    if (key.time_s > all.times_s.back() && after == nullptr) after = &key;
  }
  if (before != nullptr) add(before->time_s, before->pose, true);
  for (std::size_t i = 0; i < all.times_s.size(); ++i) {
    rig::Pose pose = document.pose;
    for (std::size_t c = 0; c < numbers.size(); ++c) pose[numbers[c]] = all.values[i * numbers.size() + c];
    add(all.times_s[i], std::move(pose), i == 0 || i + 1 == all.times_s.size());
  }
  if (after != nullptr) add(after->time_s, after->pose, true);
  return rows;
}

/// How far each control of some may be off, as changes of its value, so that together they move no sample of the model
/// by more than k_take_px; infinite for what moves none. Conservative: what moves one place is taken to add up.
std::vector<double> tolerances(const document::Document& document, const intent::ControlFields& fields,
                               const document::View& view, const std::vector<std::size_t>& controls) {
  const std::vector<double> none(controls.size(), std::numeric_limits<double>::infinity());
  const auto camera = geometry::Camera::make(view.camera, view.viewport);
  if (!camera) return none;
  const auto parameters = document.model->rig->parameters();
  const std::size_t joints_from = document::weight_count(*document.model);
  std::vector<std::vector<double>> ways;  // px a unit of value, one a sample
  std::vector<double> together(fields.places().size(), 0);
  for (const std::size_t p : controls) {
    const rig::Parameter& parameter = parameters[p];
    const double range = p >= joints_from ? 1.0 : parameter.maximum - parameter.minimum;
    auto& way = ways.emplace_back(fields.places().size(), 0.0);
    const intent::ControlField field = fields.field(p);
    for (std::size_t i = 0; i < field.samples.size() && range > 0; ++i) {
      const std::uint32_t s = field.samples[i];
      // As far as it goes in space: it may be seen from anywhere later.
      const double unit = camera->units_per_px(camera->depth(fields.places()[s]));
      const double length = std::sqrt(intent::square_of(field.ways[i])) / range;
      if (!(unit > 0) || length == 0) continue;
      way[s] = length / unit;
      together[s] += 1;
    }
  }
  std::vector<double> out = none;
  for (std::size_t c = 0; c < controls.size(); ++c) {
    for (std::size_t s = 0; s < ways[c].size(); ++s) {
      if (ways[c][s] > 0) out[c] = std::min(out[c], k_take_px / (ways[c][s] * together[s]));
    }
  }
  return out;
}

}  // namespace

KeyPoses thinned(const document::Document& document, const KeyPoses& all, const intent::ControlFields& fields,
                 const document::View& view) {
  const std::vector<std::size_t> numbers = numbers_of(document, all.names);
  if (numbers.size() != all.names.size() || all.times_s.size() < 3) return all;
  const Rows rows = rows_of(document, all, numbers);
  std::vector<double> values;
  for (const rig::Pose& pose : rows.poses) {
    for (const std::size_t p : numbers) values.push_back(pose[p]);
  }
  const std::vector<double> allowed = tolerances(document, fields, view, numbers);
  KeyPoses out{all.names, {}, {}};
  for (const std::size_t moment : document::enough_moments({rows.times_s, values, allowed}, rows.fixed)) {
    const double time_s = rows.times_s[moment];
    if (time_s < all.times_s.front() || time_s > all.times_s.back()) continue;
    out.times_s.push_back(time_s);
    for (const std::size_t p : numbers) out.values.push_back(rows.poses[moment][p]);
  }
  return out;
}

}  // namespace penpose::app
