#include "core/portrait/face_view.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/curve/polyline.h"
#include "core/portrait/absent_features.h"
#include "core/portrait/companions.h"
#include "core/portrait/proportions.h"
#include "core/portrait/sheet_warp.h"

namespace penpose::portrait {
namespace {

/// Points a curve is kept with.
constexpr std::size_t k_samples = 25;
/// Controls that move no point of a curve by this are left out, px of the face.
constexpr double k_least_way = 0.5;
/// Parts of curves that lines may be.
constexpr std::array<std::array<double, 2>, 6> k_parts = {
    {{0.0, 1.0}, {0.0, 0.5}, {0.5, 1.0}, {0.0, 0.7}, {0.3, 1.0}, {0.25, 0.75}}};
/// Joints are left out that move the curve they move least by this share of what they move most.
constexpr double k_carries = 0.15;

using Line = std::vector<PxPoint>;

/// The value at a share of a line with evenly spaced parameters.
PxPoint at_share(const Line& line, double share) {
  const double x = share * static_cast<double>(line.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(x), line.size() - 2);
  const double f = x - static_cast<double>(i);
  return line[i] * (1.0 - f) + line[i + 1] * f;
}

Trace cut(const Line& line, double from, double to) {
  Trace out{};
  for (std::size_t i = 0; i < k_points; ++i) {
    const PxPoint p = at_share(line, from + (to - from) * static_cast<double>(i) / static_cast<double>(k_points - 1));
    out[2 * i] = p.x;
    out[2 * i + 1] = p.y;
  }
  return out;
}

/// All curves bound at once.
struct Bound {
  std::vector<std::uint32_t> vertices;
  std::unique_ptr<rig::BoundVertices> rig;
  std::vector<geometry::ModelPoint> places;
};

geometry::ModelPoint point_of(const posing::CurvePoint& point, std::span<const geometry::ModelPoint> places) {
  return places[0] * point.weight[0] + places[1] * point.weight[1] + places[2] * point.weight[2];
}

/// Each curve in the picture, its own points.
std::optional<std::vector<Line>> picture(Bound& bound, std::span<const FeatureCurve> curves, const rig::Pose& pose,
                                         const geometry::Camera& camera) {
  bound.rig->evaluate(pose, bound.places);
  std::vector<Line> lines;
  std::size_t at = 0;
  for (const FeatureCurve& curve : curves) {
    Line line;
    for (const posing::CurvePoint& point : curve.points) {
      const auto px = camera.project(point_of(point, {bound.places.data() + at, 3}));
      if (!px || !std::isfinite(px->x) || !std::isfinite(px->y)) return std::nullopt;
      line.push_back(*px);
      at += 3;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

/// Samples of all curves, at the shares of length that they have at rest.
std::vector<Line> sampled(const std::vector<Line>& lines, const std::vector<std::vector<double>>& lengths) {
  std::vector<Line> out;
  for (std::size_t c = 0; c < lines.size(); ++c) {
    Line line;
    for (std::size_t i = 0; i < k_samples; ++i) {
      const auto place = curve::place_at(lengths[c], static_cast<double>(i) / static_cast<double>(k_samples - 1));
      line.push_back(lines[c][place.segment] * (1.0 - place.fraction) + lines[c][place.segment + 1] * place.fraction);
    }
    out.push_back(std::move(line));
  }
  return out;
}

struct Frame {
  PxPoint middle{0, 0};
  double scale = 1;
};

Frame frame_of(const std::vector<Line>& lines) {
  PxPoint low{1e300, 1e300}, high{-1e300, -1e300};
  for (const Line& line : lines) {
    for (const PxPoint& p : line) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
  }
  const double dx = high.x - low.x, dy = high.y - low.y;
  return {(low + high) * 0.5, k_face_px / std::sqrt(dx * dx + dy * dy)};
}

double longest_way(const std::vector<Line>& ways) {
  double most = 0;
  for (const Line& line : ways) {
    for (const PxPoint& p : line) most = std::max(most, p.x * p.x + p.y * p.y);
  }
  return std::sqrt(most);
}

/// Whether a control moves all curves alike, as a neck does.
bool carries_all(const std::vector<Line>& ways) {
  double least = 1e300, most = 0;
  for (const Line& line : ways) {
    double sum = 0;
    for (const PxPoint& p : line) sum += p.x * p.x + p.y * p.y;
    const double way = std::sqrt(sum / static_cast<double>(line.size()));
    least = std::min(least, way);
    most = std::max(most, way);
  }
  return least > k_carries * most;
}

/// Leaves the weakest controls out, beyond what is asked; the order stays.
void keep_strongest(std::vector<Control>& controls, std::vector<std::vector<Line>>& ways) {
  if (controls.size() <= k_most_controls) return;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t j = 0; j < ways.size(); ++j) order.emplace_back(-longest_way(ways[j]), j);
  std::stable_sort(order.begin(), order.end());
  std::vector<bool> kept(controls.size(), false);
  for (std::size_t i = 0; i < k_most_controls; ++i) kept[order[i].second] = true;
  std::size_t to = 0;
  for (std::size_t j = 0; j < controls.size(); ++j) {
    if (!kept[j]) continue;
    controls[to] = controls[j];
    ways[to] = std::move(ways[j]);
    ++to;
  }
  controls.resize(to);
  ways.resize(to);
}

/// The covariance of the middle of a trace's points.
std::array<double, 3> of_middle(const Spread& spread) {
  std::array<double, 3> sum{};
  for (std::size_t i = 0; i < k_numbers; ++i) {
    for (std::size_t k = 0; k <= i; ++k)
      sum[i % 2 + k % 2] += (i == k ? 1.0 : i % 2 == k % 2 ? 2.0 : 1.0) * spread[i * k_numbers + k];
  }
  for (double& v : sum) v *= 1.0 / static_cast<double>(k_points * k_points);
  return sum;
}

}  // namespace

std::size_t FaceView::stretches_per_curve() { return k_parts.size(); }

double usual_share(const Unit& unit) {
  constexpr double k_usual = 0.35, k_usual_alone = 0.21;
  return unit.one_side ? k_usual_alone : k_usual;
}

void add_way(const Trace& way, double factor, Spread& spread) {
  for (std::size_t i = 0; i < k_numbers; ++i) {
    const double scaled = factor * factor * way[i];
    if (scaled == 0.0) continue;
    for (std::size_t k = 0; k <= i; ++k) spread[i * k_numbers + k] += scaled * way[k];
  }
}

void FaceView::measure_spreads() {
  spreads_.assign(stretches_.size(), Spread{});
  middle_spreads_.clear();
  for (std::size_t s = 0; s < stretches_.size(); ++s) {
    for (const Unit& unit : units_) {
      Trace way{};
      for (std::size_t m = 0; m < unit.count; ++m) {
        for (std::size_t i = 0; i < k_numbers; ++i) way[i] += stretches_[s].ways[unit.members[m]][i];
      }
      add_way(way, usual_share(unit), spreads_[s]);
    }
    middle_spreads_.push_back(of_middle(spreads_[s]));
  }
}

Trace trace_of(std::span<const PxPoint> line) {
  Trace out{};
  const auto points = curve::resample<PxPoint>(line, k_points);
  for (std::size_t i = 0; i < k_points && points; ++i) {
    out[2 * i] = (*points)[i].x;
    out[2 * i + 1] = (*points)[i].y;
  }
  return out;
}

std::vector<std::vector<PxPoint>> FaceView::proportion_lines(std::size_t curve) const {
  std::vector<Line> out;
  for (const auto& way : all_proportions_) out.push_back(way[curve]);
  return out;
}

FaceView FaceView::drawn_as(const std::vector<Line>& lines, bool at_rest) const {
  std::vector<PxPoint> points, there;
  for (std::size_t c = 0; c < curve_count_; ++c) {
    for (std::size_t i = 0; i < k_samples; i += 4) {
      points.push_back(lines_[c][i]);
      there.push_back(lines[c][i]);
    }
  }
  const SheetWarp warp(points, there);
  FaceView other = *this;
  for (std::size_t c = 0; c < curve_count_; ++c) {
    const auto d = warp.derivative(lines_[c][k_samples / 2]);
    for (auto& way : other.ways_) {
      for (PxPoint& p : way[c]) p = {d[0] * p.x + d[1] * p.y, d[2] * p.x + d[3] * p.y};
    }
  }
  if (at_rest) other.lines_ = lines;
  for (Stretch& one : other.stretches_) one = other.stretch(one.curve, one.from, one.to);
  other.measure_spreads();
  return other;
}

Stretch FaceView::stretch(std::size_t curve, double from, double to) const {
  Stretch out{curve, from, to, cut(lines_[curve], from, to), {}, {}, lengths_[curve] * (to - from)};
  for (const auto& way : ways_) out.ways.push_back(cut(way[curve], from, to));
  for (const auto& way : all_proportions_) out.proportions.push_back(cut(way[curve], from, to));
  return out;
}

base::Result<FaceView> FaceView::make(const rig::Rig& rig, const intent::WholeModel& whole,
                                      std::span<const FeatureCurve> curves, const rig::Pose& start,
                                      std::span<const std::size_t> free, const geometry::Camera& camera) {
  if (curves.empty())
    return base::Error{"the model has no feature curves", "", "name them in a file and pass it by --curves"};
  if (curves.size() > k_most_curves) {
    return base::Error{std::to_string(curves.size()) + " curves are more than the 60 of a face", "",
                       "name the features of the face alone"};
  }
  Bound bound;
  for (const FeatureCurve& curve : curves) {
    for (const posing::CurvePoint& point : curve.points) {
      for (const std::uint32_t v : point.vertex) {
        if (v >= rig.vertex_count()) {
          return base::Error{"the model has no vertex " + std::to_string(v), "curve " + curve.name,
                             "name vertices of this model"};
        }
        bound.vertices.push_back(v);
      }
    }
  }
  bound.rig = rig.bind(bound.vertices);
  bound.places.resize(bound.vertices.size());
  auto rest = picture(bound, curves, start, camera);
  if (!rest) return base::Error{"the feature curves lie behind the camera", "", "choose another view"};
  FaceView view;
  const Frame frame = frame_of(*rest);
  if (!std::isfinite(frame.scale)) return base::Error{"the feature curves have no extent", "", "choose another view"};
  view.middle_ = frame.middle;
  view.scale_ = frame.scale;
  const auto framed = [&](std::vector<Line> lines) {
    for (Line& line : lines) {
      for (PxPoint& p : line) p = view.on_face(p);
    }
    return lines;
  };
  rest = framed(std::move(*rest));
  std::vector<std::vector<double>> lengths;
  std::vector<Part>& parts = view.parts_;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    lengths.push_back(curve::cumulative_length<PxPoint>((*rest)[c]));
    if (lengths.back().size() < 2 || !(lengths.back().back() > 1e-6)) {
      return base::Error{"the curve has no length in this view", "curve " + curves[c].name,
                         "leave it out or choose another view"};
    }
    parts.push_back(part_named(curves[c].name));
  }
  view.lines_ = sampled(*rest, lengths);
  const std::vector<Line>& lines = view.lines_;

  auto& ways = view.ways_;
  rig::Pose pose = start;
  for (const std::size_t p : free) {
    if (!bound.rig->moves(p)) continue;
    const rig::Parameter& parameter = rig.parameters()[p];
    const double range = parameter.maximum - parameter.minimum;
    if (!(range > 0.0)) continue;
    Control control{p, (parameter.minimum - start[p]) / range, (parameter.maximum - start[p]) / range};
    const double reach = control.high >= -control.low ? control.high : control.low;
    const bool turns = whole.joint[p] != intent::k_no_partner;
    const double step = turns ? reach * 0.1 : reach;  // of an arc, its beginning
    pose[p] = start[p] + step * range;
    const auto moved = picture(bound, curves, pose, camera);
    pose[p] = start[p];
    if (!moved || step == 0.0) continue;
    std::vector<Line> way = sampled(framed(*moved), lengths);
    for (std::size_t c = 0; c < way.size(); ++c) {
      for (std::size_t i = 0; i < way[c].size(); ++i) way[c][i] = (way[c][i] - lines[c][i]) * (1.0 / step);
    }
    if (longest_way(way) < k_least_way || (turns && carries_all(way))) continue;
    view.controls_.push_back(control);
    ways.push_back(std::move(way));
  }
  keep_strongest(view.controls_, ways);
  std::vector<std::size_t> number(rig.parameters().size(), intent::k_no_partner);
  for (std::size_t j = 0; j < view.controls_.size(); ++j) number[view.controls_[j].parameter] = j;
  for (std::size_t j = 0; j < view.controls_.size(); ++j) {
    const std::size_t partner = whole.partner[view.controls_[j].parameter];
    const std::size_t other = partner == intent::k_no_partner ? partner : number[partner];
    const bool paired = other != intent::k_no_partner;
    if (paired && j < other) view.units_.push_back({{j, other}, 2, false});
    view.units_.push_back({{j, j}, 1, paired});
  }
  for (std::size_t c = 0; c < curves.size(); ++c) view.meant_.push_back(c);
  for (AbsentFeature& absent : absent_features(lines, parts)) {
    parts.push_back(absent.part);
    view.meant_.push_back(absent.meant);
    lengths.push_back(curve::cumulative_length<PxPoint>(absent.points));
    for (auto& way : ways) way.emplace_back(absent.points.size());
    view.lines_.push_back(std::move(absent.points));
  }
  view.curve_count_ = view.lines_.size();
  view.parting_ = parting_of(lines, parts);
  view.companions_ = companions_of(lines, parts);
  for (Proportion& one : proportions_of(lines, parts)) {
    view.all_proportions_.push_back(std::move(one.ways));
  }
  for (const auto& length : lengths) view.lengths_.push_back(length.back());
  for (std::size_t c = 0; c < view.curve_count_; ++c) {
    for (const auto& [from, to] : k_parts) view.stretches_.push_back(view.stretch(c, from, to));
    constexpr double k_steady = 8.0, k_unknown = 40.0;
    const double least = view.meant_[c] == c ? k_steady : k_unknown;
    double sum = least * least;
    const Stretch& whole_curve = view.curve(c);
    for (const Unit& unit : view.units_) {
      for (std::size_t i = 0; i < k_numbers; ++i) {
        double way = 0;
        for (std::size_t m = 0; m < unit.count; ++m) way += whole_curve.ways[unit.members[m]][i];
        way *= usual_share(unit);
        sum += way * way / static_cast<double>(k_points);
      }
    }
    view.unrest_.push_back(std::sqrt(sum));
  }
  view.measure_spreads();
  // What drawings leave out together, for the first guess of where the face is.
  const auto group = [&](std::initializer_list<Part> without) {
    std::vector<std::size_t> taken;
    for (std::size_t c = 0; c < view.curve_count_; ++c) {
      if (std::find(without.begin(), without.end(), parts[c]) == without.end()) taken.push_back(c);
    }
    if (!taken.empty() && std::find(view.groups_.begin(), view.groups_.end(), taken) == view.groups_.end())
      view.groups_.push_back(std::move(taken));
  };
  group({Part::crown});
  group({Part::crown, Part::jaw});
  group({Part::crown, Part::jaw, Part::brow});
  group({Part::crown, Part::brow});
  group({});
  return view;
}

}  // namespace penpose::portrait
