#include "tests/judges/measures/gesture_judge.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"
#include "core/base/numbers.h"
#include "tests/judges/cases/picture.h"
#include "tests/judges/measures/bounded.h"
#include "tests/judges/rigs/control_words.h"

namespace penpose::judges {
namespace {

/// Per cent of the size that nobody sees.
constexpr double k_still = 0.2;
/// Radians by which a joint is turned to see what it does.
constexpr double k_small_turn = 0.1;

double dot(const std::vector<ModelVector>& a, const std::vector<ModelVector>& b) {
  double sum = 0;
  for (std::size_t v = 0; v < a.size(); ++v) sum += a[v].x * b[v].x + a[v].y * b[v].y + a[v].z * b[v].z;
  return sum;
}
double norm(const std::vector<ModelVector>& a) { return std::sqrt(dot(a, a)); }

std::vector<double> shares_along(const std::vector<PxPoint>& line) {
  std::vector<double> along{0};
  for (std::size_t i = 1; i < line.size(); ++i)
    along.push_back(along.back() + geometry::distance(line[i - 1], line[i]));
  for (double& a : along) a /= along.back();
  return along;
}

/// From each point of a curve to where it was drawn: the same share of the length, the nearer way round.
std::vector<PxPoint> drawn_ways(const std::vector<PxPoint>& curve, std::vector<PxPoint> drawn) {
  const auto ends = [&](const PxPoint& first, const PxPoint& last) {
    return geometry::distance(first, curve.front()) + geometry::distance(last, curve.back());
  };
  if (ends(drawn.front(), drawn.back()) > ends(drawn.back(), drawn.front())) std::reverse(drawn.begin(), drawn.end());
  const auto of_curve = shares_along(curve);
  const auto of_drawn = shares_along(drawn);
  std::vector<PxPoint> ways;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    std::size_t k = 1;
    while (k + 1 < drawn.size() && of_drawn[k] < of_curve[i]) ++k;
    const double piece = of_drawn[k] - of_drawn[k - 1];
    const double t = piece > 0 ? std::clamp((of_curve[i] - of_drawn[k - 1]) / piece, 0.0, 1.0) : 0.0;
    ways.push_back(drawn[k - 1] + (drawn[k] - drawn[k - 1]) * t - curve[i]);
  }
  return ways;
}

}  // namespace

GestureJudge::GestureJudge(const WholeFace& face) : face_(face), rest_(rig::rest_pose(*face.model().rig)) {}

const std::vector<ModelVector>& GestureJudge::field(std::size_t parameter) {
  auto& known = fields_[parameter];
  if (known.empty()) {
    const rig::Parameter& p = face_.model().rig->parameters()[parameter];
    rig::Pose pose = rest_;
    pose[parameter] = is_angle(p.name) ? p.rest + k_small_turn : p.maximum;
    known = face_.moved(pose);
  }
  return known;
}

const std::vector<ModelVector>* GestureJudge::shape_field(const std::string& control) {
  const auto i = rig::find_parameter(face_.model().rig->parameters(), control);
  return i ? &field(*i) : nullptr;
}

bool GestureJudge::is_like(const std::string& control, const Names& group) {
  if (has(group, control)) return true;
  const auto* mine = shape_field(control);
  const double n = mine ? norm(*mine) : 0;
  if (n == 0) return false;
  return std::any_of(group.begin(), group.end(), [&](const std::string& other) {
    const auto* its = shape_field(other);
    return its && dot(*mine, *its) > 0.99 * n * norm(*its);
  });
}

GestureJudge::Names GestureJudge::allowed(const Gesture& gesture) const {
  Names names = gesture.accepted;
  for (const Names& group : gesture.needed) names.insert(names.end(), group.begin(), group.end());
  return names;
}

GestureJudge::Asked GestureJudge::asked_of(const Gesture& gesture, const std::vector<ModelVector>& found) const {
  const Picture picture(gesture.asked.view_yaw_degrees, face_.size());
  Asked asked;
  for (const io::CaseReference& reference : gesture.asked.references) {
    std::vector<PxPoint> drawn;
    for (const ModelPoint& p : reference.target) drawn.push_back(picture.flat(p));
    asked.ways.push_back(drawn_ways(picture.flat(face_.rest(), reference.vertices), std::move(drawn)));
    for (const PxPoint& way : asked.ways.back()) asked.asked += geometry::dot(way, way);
    for (const PxPoint& way : picture.flat(found, reference.vertices)) asked.went += geometry::dot(way, way);
  }
  return asked;
}

std::vector<GestureJudge::Moved> GestureJudge::moved_by(const rig::Pose& pose) {
  const auto parameters = face_.model().rig->parameters();
  std::vector<Moved> all;
  for (std::size_t i = 0; i < pose.size(); ++i) {
    const double value = pose[i] - rest_[i];
    if (std::abs(value) <= 1e-6) continue;
    if (!is_angle(parameters[i].name)) {
      all.push_back({parameters[i].name, std::abs(value) / (parameters[i].maximum - rest_[i]) * norm(field(i)), 0});
      continue;
    }
    // The angles of a joint are one control; they follow each other.
    const std::string joint = control_of(parameters[i].name);
    std::vector<ModelVector> sum(face_.rest().size(), ModelVector{0});
    double squares = 0;
    for (; i < pose.size() && is_angle(parameters[i].name) && control_of(parameters[i].name) == joint; ++i) {
      const double angle = pose[i] - rest_[i];
      if (angle == 0) continue;
      squares += angle * angle;
      const auto& small = field(i);
      for (std::size_t v = 0; v < sum.size(); ++v) sum[v] += small[v] * (angle / k_small_turn);
    }
    --i;
    all.push_back({joint, norm(sum), base::degrees(std::sqrt(squares))});
  }
  return all;
}

bool GestureJudge::looks_meant(const Gesture& gesture, const Asked& asked, const std::vector<ModelVector>& found) {
  const Picture picture(gesture.asked.view_yaw_degrees, face_.size());
  std::vector<const std::vector<ModelVector>*> shapes;
  Names seen;
  for (const std::string& name : allowed(gesture)) {
    if (has(seen, name)) continue;
    seen.push_back(name);
    const auto* shape = shape_field(name);
    if (shape && norm(*shape) > 0) shapes.push_back(shape);
  }
  if (shapes.empty()) return false;
  std::vector<std::vector<double>> columns(shapes.size());
  std::vector<double> b;
  for (std::size_t r = 0; r < asked.ways.size(); ++r) {
    const auto& vertices = gesture.asked.references[r].vertices;
    const double share = 1 / std::sqrt(static_cast<double>(vertices.size()));
    for (const PxPoint& way : asked.ways[r]) b.insert(b.end(), {way.x * share, way.y * share});
    for (std::size_t c = 0; c < shapes.size(); ++c) {
      for (const PxPoint& way : picture.flat(*shapes[c], vertices))
        columns[c].insert(columns[c].end(), {way.x * share, way.y * share});
    }
  }
  double most = 0;
  for (const auto& column : columns) {
    double square = 0;
    for (const double a : column) square += a * a;
    most = std::max(most, square);
  }
  if (most == 0) return false;
  const auto x = bounded_least_squares(columns, b, 0.03 * std::sqrt(most));
  std::vector<ModelVector> meant(found.size(), ModelVector{0});
  for (std::size_t c = 0; c < shapes.size(); ++c) {
    for (std::size_t v = 0; v < meant.size(); ++v) meant[v] += (*shapes[c])[v] * x[c];
  }
  std::vector<ModelVector> off = found;
  for (std::size_t v = 0; v < off.size(); ++v) off[v] -= meant[v];
  return norm(off) <= 0.45 * norm(meant);
}

double GestureJudge::stray(const Gesture& gesture, const std::vector<ModelVector>& found) {
  std::vector<bool> free(found.size(), false);
  const auto parameters = face_.model().rig->parameters();
  const Names names = allowed(gesture);
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (!has(names, control_of(parameters[i].name))) continue;
    const auto& way = field(i);
    double most = 0;
    for (const ModelVector& d : way) most = std::max(most, geometry::length(d));
    for (std::size_t v = 0; v < way.size(); ++v) {
      if (most > 0 && geometry::length(way[v]) > 0.02 * most) free[v] = true;
    }
  }
  for (const io::CaseReference& reference : gesture.asked.references) {
    for (const std::uint32_t v : reference.vertices) free[v] = true;
  }
  double most = 0;
  for (std::size_t v = 0; v < found.size(); ++v) {
    if (!free[v]) most = std::max(most, geometry::length(found[v]));
  }
  return 100 * most / face_.size();
}

void GestureJudge::judge(const Gesture& gesture, const rig::Pose& pose, Outcome& outcome) {
  const auto found = face_.moved(pose);
  const Asked asked = asked_of(gesture, found);
  const auto moved = moved_by(pose);
  outcome.of = 1;
  outcome.stray = stray(gesture, found);
  double most = 0;
  double all = 0;
  double needed = 0;
  double other = 0;
  bool other_joint = false;
  std::vector<bool> met(gesture.needed.size(), false);
  for (const Moved& one : moved) most = std::max(most, one.way);
  for (const Moved& one : moved) {
    all += one.way;
    bool ok = is_like(one.control, gesture.accepted);
    bool is_needed = false;
    for (std::size_t g = 0; g < gesture.needed.size(); ++g) {
      if (!is_like(one.control, gesture.needed[g])) continue;
      is_needed = true;
      met[g] = met[g] || one.way >= 0.1 * most;
    }
    ok = ok || is_needed;
    needed += is_needed ? one.way : 0;
    other += ok ? 0 : one.way;
    other_joint = other_joint || (one.degrees > 0.5 && !ok);
    outcome.note += (outcome.note.empty() ? "" : " ") + one.control + (ok ? "" : "!") + ":" +
                    base::format_fixed(most > 0 ? one.way / most : 0, 2);
  }
  if (asked.asked > 0 && asked.went < 0.15 * 0.15 * asked.asked) {
    outcome.nothing = 1;
    outcome.right = gesture.still_is_right && *outcome.stray <= k_still ? 1 : 0;
    return;
  }
  const bool all_met = std::find(met.begin(), met.end(), false) == met.end();
  const bool named = all_met && needed >= 0.5 * all && other <= 0.2 * all && !other_joint;
  outcome.right = named || looks_meant(gesture, asked, found) ? 1 : 0;
}

}  // namespace penpose::judges
