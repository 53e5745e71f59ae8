#include "core/document/time/timeline_editing.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace penpose::document {
namespace {

bool within(const KeySegment& segment, const rig::Parameter& range) {
  const auto [least, most] = extremes(segment);
  return least >= range.minimum && most <= range.maximum;
}

/// The greatest share of the slopes of free ends with which the segment stays in its control's range.
double share_within(const KeySegment& segment, bool from_free, bool to_free, const rig::Parameter& range) {
  const auto scaled = [&](double share) {
    KeySegment one = segment;
    if (from_free) one.slope_from *= share;
    if (to_free) one.slope_to *= share;
    return one;
  };
  if (within(segment, range)) return 1;
  constexpr int k_halvings = 30;
  double share = 0;
  double step = 0.5;
  for (int i = 0; i < k_halvings; ++i, step *= 0.5) {
    if (within(scaled(share + step), range)) share += step;
  }
  return share;
}

/// Of a key that takes the place of a segment's part.
KeyKind free_as(const KeySegment& segment) { return segment.overshoots ? KeyKind::overshoot : KeyKind::free; }

/// All keys of one control after another.
void settle_control(Timeline& timeline, std::size_t parameter, const rig::Parameter& range,
                    std::vector<rig::Pose>& poses, std::vector<std::vector<ControlKey>>& controls) {
  std::optional<std::size_t> before;
  const auto fill = [&](std::size_t from, std::size_t to, auto value) {
    for (std::size_t k = from; k < to; ++k) poses[k][parameter] = value(timeline.keys[k].time_s);
  };
  const auto held = [&](std::size_t at) { return [&, at](double) { return timeline.keys[at].pose[parameter]; }; };
  for (std::size_t k = 0; k < timeline.keys.size(); ++k) {
    if (!timeline.keys[k].controls.has(parameter)) continue;
    if (!before) {
      fill(0, k, held(k));
    } else {
      KeySegment segment = segment_of(timeline, parameter, *before, k);
      const bool from_free = has_slopes(segment.kind);
      const bool curved = segment.kind == KeyKind::smooth || from_free;
      const bool to_free = curved && has_slopes(timeline.keys[k].controls[parameter].kind);
      if ((from_free || to_free) && !segment.overshoots) {
        const double share = share_within(segment, from_free, to_free, range);
        if (from_free) controls[*before][parameter].out = segment.slope_from *= share;
        if (to_free) controls[k][parameter].in = segment.slope_to *= share;
      }
      fill(*before + 1, k, [&](double time_s) {
        const double value = value_at(segment, time_s);
        return segment.overshoots ? value : std::clamp(value, range.minimum, range.maximum);
      });
    }
    before = k;
  }
  if (before) fill(*before + 1, timeline.keys.size(), held(*before));
}

}  // namespace

std::optional<std::size_t> key_at(const Timeline& timeline, double time_s) {
  const std::size_t place = first_from(timeline, time_s);
  if (place == timeline.keys.size() || timeline.keys[place].time_s != time_s) return std::nullopt;
  return place;
}

Timeline trimmed(const Timeline& timeline, std::span<const rig::Parameter> parameters, double from_s, double to_s) {
  TimelineEditing keys(timeline, parameters, rig::Pose(parameters.size()));
  for (std::size_t p = 0; p < parameters.size(); ++p) {
    keys.cut(p, from_s);
    keys.cut(p, to_s);
  }
  Timeline whole = std::move(keys).finish();
  Timeline part;
  for (PoseKey& key : whole.keys) {
    if (key.time_s < from_s || key.time_s > to_s) continue;
    key.time_s -= from_s;
    part.keys.push_back(std::move(key));
  }
  return settled(std::move(part), parameters);
}

Timeline settled(Timeline timeline, std::span<const rig::Parameter> parameters) {
  std::erase_if(timeline.keys, [](const PoseKey& key) { return key.controls.empty(); });
  const bool usual =
      std::all_of(timeline.keys.begin(), timeline.keys.end(), [](const PoseKey& key) { return key.controls.usual(); });
  if (usual) return timeline;
  std::vector<rig::Pose> poses;
  std::vector<std::vector<ControlKey>> controls;
  for (const PoseKey& key : timeline.keys) {
    poses.emplace_back(key.pose);
    controls.push_back(key.controls.list(parameters.size()));
  }
  for (std::size_t i = 0; i < parameters.size(); ++i) settle_control(timeline, i, parameters[i], poses, controls);
  for (std::size_t k = 0; k < timeline.keys.size(); ++k) {
    PoseKey& key = timeline.keys[k];
    if (poses[k] != static_cast<const rig::Pose&>(key.pose)) key.pose = std::move(poses[k]);
    ControlKeys list(std::move(controls[k]));
    if (!(list == key.controls)) key.controls = std::move(list);
  }
  return timeline;
}

TimelineEditing::TimelineEditing(const Timeline& timeline, std::span<const rig::Parameter> parameters,
                                 rig::Pose unkeyed)
    : before_(timeline), parameters_(parameters), unkeyed_(std::move(unkeyed)) {}

TimelineEditing::Moment& TimelineEditing::open(double time_s) {
  const auto known = changed_.find(time_s);
  if (known != changed_.end()) return known->second;
  Moment moment;
  if (const auto place = key_at(before_, time_s)) {
    const PoseKey& key = before_.keys[*place];
    moment = {key.pose, key.name, key.controls.list(parameters_.size())};
  } else {
    moment = {sample(before_, time_s, unkeyed_), {}, {}};
    moment.controls.assign(parameters_.size(), {KeyKind::none, 0, 0});
  }
  return changed_.emplace(time_s, std::move(moment)).first->second;
}

void TimelineEditing::set(double time_s, std::size_t parameter, double value, const ControlKey& key) {
  Moment& moment = open(time_s);
  const rig::Parameter& range = parameters_[parameter];
  moment.pose[parameter] = key.kind == KeyKind::overshoot ? value : std::clamp(value, range.minimum, range.maximum);
  moment.controls[parameter] = key;
}

void TimelineEditing::erase(double time_s, std::size_t parameter) {
  open(time_s).controls[parameter] = {KeyKind::none, 0, 0};
}

void TimelineEditing::open_span(std::size_t parameter, double from_s, double to_s) {
  /// The segment of the control that a moment cuts, by the places of its keys.
  struct Cut {
    std::size_t before, after;
    KeySegment segment;
  };
  const auto cut_at = [&](double time_s) -> std::optional<Cut> {
    const std::size_t place = first_from(before_, time_s);
    const auto before = place > 0 ? key_before(before_, parameter, place - 1) : std::nullopt;
    const auto after = key_after(before_, parameter, place);
    if (!before || !after) return std::nullopt;
    return Cut{*before, *after, document::segment_of(before_, parameter, *before, *after)};
  };
  const auto slope_at_cut = [&](const std::optional<Cut>& cut, double time_s) {
    return cut ? document::slope_at(cut->segment, time_s) : 0.0;
  };
  const auto value = [&](double time_s) {
    const auto sampled = sample(before_, parameter, time_s);
    return sampled ? *sampled : unkeyed_[parameter];
  };
  const auto curved = [](KeyKind kind) { return kind != KeyKind::linear && kind != KeyKind::stepped; };
  const auto first = key_at(before_, from_s);
  const auto last = key_at(before_, to_s);
  ControlKey from{KeyKind::free, 0, 0};
  ControlKey to{KeyKind::free, 0, 0};
  if (first && before_.keys[*first].controls.has(parameter)) {
    const ControlKey key = with_slopes(before_, *first, parameter);
    from.in = key.in;
    if (key.kind == KeyKind::overshoot) from.kind = key.kind;
  } else if (const auto cut = cut_at(from_s)) {
    from.in = slope_at_cut(cut, from_s);
    from.kind = free_as(cut->segment);
    if (curved(cut->segment.kind)) {
      const double in = with_slopes(before_, cut->before, parameter).in;
      set(cut->segment.from_s, parameter, cut->segment.from, {free_as(cut->segment), in, cut->segment.slope_from});
    }
  }
  if (last && before_.keys[*last].controls.has(parameter)) {
    to = with_slopes(before_, *last, parameter);
    if (to.kind == KeyKind::smooth) to.kind = KeyKind::free;
  } else if (const auto cut = cut_at(to_s)) {
    to.out = slope_at_cut(cut, to_s);
    to.kind = curved(cut->segment.kind) ? free_as(cut->segment) : cut->segment.kind;
    const ControlKey end = with_slopes(before_, cut->after, parameter);
    if (curved(cut->segment.kind) && end.kind == KeyKind::smooth)
      set(cut->segment.to_s, parameter, cut->segment.to, {free_as(cut->segment), cut->segment.slope_to, end.out});
  }
  const double from_value = value(from_s);
  const double to_value = value(to_s);
  for (const PoseKey& key : before_.keys) {
    if (key.time_s > from_s && key.time_s < to_s && key.controls.has(parameter)) erase(key.time_s, parameter);
  }
  set(from_s, parameter, from_value, from);
  set(to_s, parameter, to_value, to);
}

void TimelineEditing::cut(std::size_t parameter, double time_s) {
  const std::size_t place = first_from(before_, time_s);
  if (const auto there = key_at(before_, time_s); there && before_.keys[*there].controls.has(parameter)) return;
  const auto before = place > 0 ? key_before(before_, parameter, place - 1) : std::nullopt;
  const auto after = key_after(before_, parameter, place);
  if (!before) return;
  const ControlKey known = before_.keys[*before].controls[parameter];
  if (!after) {
    set(time_s, parameter, before_.keys[*before].pose[parameter], known);
    return;
  }
  const KeySegment segment = document::segment_of(before_, parameter, *before, *after);
  const double value = value_at(segment, time_s);
  if (segment.kind == KeyKind::linear || segment.kind == KeyKind::stepped) {
    set(time_s, parameter, value, known);
    return;
  }
  const double slope = document::slope_at(segment, time_s);
  const ControlKey from = with_slopes(before_, *before, parameter);
  const KeyKind kind = free_as(segment);
  set(segment.from_s, parameter, segment.from, {kind, from.in, document::slope_at(segment, segment.from_s)});
  set(time_s, parameter, value, {kind, slope, slope});
  // Only free keys end a curve with a slope of their own; one that becomes free needs another at the end of its own
  // curve.
  for (auto at = after; at; at = key_after(before_, parameter, *at + 1)) {
    const PoseKey& key = before_.keys[*at];
    const ControlKey slopes = with_slopes(before_, *at, parameter);
    if (slopes.kind == KeyKind::stepped) break;
    const KeyKind as = slopes.kind == KeyKind::overshoot ? slopes.kind : KeyKind::free;
    set(key.time_s, parameter, key.pose[parameter], {as, slopes.in, slopes.out});
    if (slopes.kind == KeyKind::smooth || has_slopes(slopes.kind)) break;
  }
}

void TimelineEditing::bend(double time_s, std::size_t parameter, double value, double slope, bool before, bool after) {
  ControlKey key = open(time_s).controls[parameter];
  if (key.kind == KeyKind::none || (after && key.kind != KeyKind::overshoot)) key.kind = KeyKind::free;
  if (before) key.in = slope;
  if (after) key.out = slope;
  set(time_s, parameter, value, key);
}

void TimelineEditing::name(double time_s, std::string name) { open(time_s).name = std::move(name); }

Timeline TimelineEditing::finish() && {
  Timeline timeline;
  timeline.keys.reserve(before_.keys.size() + changed_.size());
  auto key = before_.keys.begin();
  for (auto& [time_s, moment] : changed_) {
    for (; key != before_.keys.end() && key->time_s < time_s; ++key) timeline.keys.push_back(*key);
    if (key != before_.keys.end() && key->time_s == time_s) ++key;
    timeline.keys.push_back({time_s, std::move(moment.pose), std::move(moment.name), std::move(moment.controls)});
  }
  timeline.keys.insert(timeline.keys.end(), key, before_.keys.end());
  return settled(std::move(timeline), parameters_);
}

}  // namespace penpose::document
