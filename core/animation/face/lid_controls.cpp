#include "core/animation/face/lid_controls.h"

#include <algorithm>
#include <cmath>

#include "core/animation/solve/seen_points.h"

namespace penpose::animation {
namespace {

constexpr std::size_t k_steps = 16;

/// The lids of one eye on the model, and how wide they stand apart.
class ModelEye {
 public:
  ModelEye(const rig::Rig& rig, std::span<const double> rest, const Transfer& transfer, const EyeCurves& eye,
           const geometry::Camera& camera)
      : one_(rig, curve(transfer, eye.one), camera), other_(rig, curve(transfer, eye.other), camera) {
    const auto a = one_.at(rest);
    const auto b = other_.at(rest);
    backwards_ = geometry::distance(a.front(), b.front()) + geometry::distance(a.back(), b.back()) >
                 geometry::distance(a.front(), b.back()) + geometry::distance(a.back(), b.front());
    const PxPoint line = a.back() - a.front();
    const double length = std::sqrt(line.x * line.x + line.y * line.y);
    if (length > 0) normal_ = {-line.y / length, line.x / length};
    at_rest_ = apart(rest);
    if (at_rest_ < 0) normal_ = normal_ * -1.0;
    at_rest_ = std::abs(at_rest_);
  }

  [[nodiscard]] double at_rest() const { return at_rest_; }
  /// How much narrower than at rest, as a share of that: 1 is closed.
  double closing(std::span<const double> pose) { return at_rest_ > 0 ? 1 - apart(pose) / at_rest_ : 0.0; }

 private:
  static std::vector<posing::CurvePoint> curve(const Transfer& transfer, std::size_t c) {
    std::vector<posing::CurvePoint> points;
    for (std::size_t i = 0; i < transfer.points.size(); ++i) {
      if (transfer.curve[i] == c) points.push_back(transfer.points[i]);
    }
    return points;
  }
  double apart(std::span<const double> pose) {
    const auto a = one_.at(pose);
    const auto b = other_.at(pose);
    const std::size_t n = std::min(a.size(), b.size());
    double sum = 0;
    double count = 0;
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const std::size_t from = i * (a.size() - 1) / (n - 1);
      const std::size_t k = i * (b.size() - 1) / (n - 1);
      const PxPoint d = b[backwards_ ? b.size() - 1 - k : k] - a[from];
      sum += d.x * normal_.x + d.y * normal_.y;
      count += 1;
    }
    return count > 0 ? sum / count : 0.0;
  }

  SeenPoints one_;
  SeenPoints other_;
  bool backwards_ = false;
  PxPoint normal_{0, 1};
  double at_rest_ = 0;
};

/// What one control does when it goes from rest to an end of its range.
struct Push {
  std::size_t parameter = 0;
  double value = 0;
  double way = 0;               ///< of the whole model: sum over the vertices
  std::vector<double> closing;  ///< one an eye
};

std::vector<Push> pushes_of(const rig::Rig& rig, std::span<const double> rest, std::span<const std::size_t> free,
                            std::vector<ModelEye>& eyes) {
  std::vector<geometry::ModelPoint> still(rig.vertex_count());
  std::vector<geometry::ModelPoint> moved(rig.vertex_count());
  rig.evaluate(rest, still);
  std::vector<Push> pushes;
  rig::Pose pose(rest.begin(), rest.end());
  constexpr double k_least = 0.02;
  for (const std::size_t p : free) {
    const rig::Parameter& range = rig.parameters()[p];
    for (const double value : {range.maximum, range.minimum}) {
      if (value == rest[p]) continue;
      pose[p] = value;
      Push push{p, value, 0, {}};
      bool any = false;
      for (ModelEye& eye : eyes) {
        push.closing.push_back(eye.closing(pose));
        any = any || std::abs(push.closing.back()) > k_least;
      }
      if (any) {
        rig.evaluate(pose, moved);
        for (std::size_t v = 0; v < still.size(); ++v) push.way += geometry::distance(still[v], moved[v]);
        pushes.push_back(std::move(push));
      }
    }
    pose[p] = rest[p];
  }
  return pushes;
}

/// The way of a push for what it does to an eye; what closes the other eye as much serves both.
double price(const Push& push, std::size_t eye) {
  double done = std::abs(push.closing[eye]);
  for (std::size_t e = 0; e < push.closing.size(); ++e) {
    if (e != eye && push.closing[e] * push.closing[eye] > 0) {
      done = std::max(done, std::min(std::abs(push.closing[e]), std::abs(push.closing[eye])) + done);
    }
  }
  return push.way / done;
}

LidTravel travel(const rig::Rig&, std::span<const double> rest, ModelEye& eye, const std::vector<const Push*>& pushes,
                 double sign) {
  LidTravel way;
  rig::Pose pose(rest.begin(), rest.end());
  for (const Push* push : pushes) {
    way.parameters.push_back(push->parameter);
    way.full.push_back(push->value);
  }
  way.reached.push_back(0);
  for (std::size_t k = 1; k <= k_steps; ++k) {
    for (const Push* push : pushes) {
      const double from = rest[push->parameter];
      pose[push->parameter] = from + (push->value - from) * static_cast<double>(k) / k_steps;
    }
    way.reached.push_back(std::max(way.reached.back(), sign * eye.closing(pose)));
  }
  return way;
}

LidTravel find_close(const rig::Rig& rig, std::span<const double> rest, std::vector<ModelEye>& eyes, std::size_t eye,
                     const std::vector<Push>& pushes) {
  constexpr double k_alone = 0.7;
  constexpr double k_enough = 0.9;
  constexpr double k_helps = 0.1;
  std::vector<const Push*> chosen;
  std::vector<const Push*> able;
  for (const Push& push : pushes) {
    if (push.closing[eye] > k_helps) able.push_back(&push);
  }
  std::stable_sort(able.begin(), able.end(), [&](const Push* a, const Push* b) {
    const bool alone_a = a->closing[eye] > k_alone;
    const bool alone_b = b->closing[eye] > k_alone;
    if (alone_a != alone_b) return alone_a;
    return price(*a, eye) < price(*b, eye);
  });
  double done = 0;
  for (const Push* push : able) {
    const bool again = std::any_of(chosen.begin(), chosen.end(),
                                   [&](const Push* other) { return other->parameter == push->parameter; });
    if (again) continue;
    chosen.push_back(push);
    done += push->closing[eye];
    if (done > k_enough || chosen.size() == 3 || push->closing[eye] > k_alone) break;
  }
  constexpr double k_least = 0.5;
  if (!(done > k_least)) return {};
  LidTravel way = travel(rig, rest, eyes[eye], chosen, 1);
  // Lids that come together all but a rim count as closed there.
  const double most = way.reached.back();
  if (most < 1) {
    for (double& reached : way.reached) reached /= most;
  }
  return way;
}

LidTravel find_widen(const rig::Rig& rig, std::span<const double> rest, std::vector<ModelEye>& eyes, std::size_t eye,
                     const std::vector<Push>& pushes, const LidTravel& close) {
  constexpr double k_helps = 0.08;
  const Push* best = nullptr;
  for (const Push& push : pushes) {
    // The same control the other way, or one that leaves the other eye alone or widens it too.
    if (!(push.closing[eye] < -k_helps)) continue;
    const bool both_ways =
        std::find(close.parameters.begin(), close.parameters.end(), push.parameter) != close.parameters.end();
    if (best == nullptr || both_ways || price(push, eye) < price(*best, eye)) best = &push;
    if (both_ways) break;
  }
  return best == nullptr ? LidTravel{} : travel(rig, rest, eyes[eye], {best}, -1);
}

/// How far along the way it is to have reached `amount`, 0..1.
double share_of_way(const LidTravel& way, double amount) {
  for (std::size_t k = 1; k < way.reached.size(); ++k) {
    if (way.reached[k] < amount) continue;
    const double step = way.reached[k] - way.reached[k - 1];
    const double part = step > 0 ? (amount - way.reached[k - 1]) / step : 0.0;
    return (static_cast<double>(k - 1) + part) / static_cast<double>(way.reached.size() - 1);
  }
  return 1;
}

std::vector<ModelEye> model_eyes(const rig::Rig& rig, std::span<const double> rest, const Transfer& transfer,
                                 std::span<const EyeCurves> eyes, const geometry::Camera& camera) {
  std::vector<ModelEye> result;
  result.reserve(eyes.size());
  for (const EyeCurves& eye : eyes) result.emplace_back(rig, rest, transfer, eye, camera);
  return result;
}

}  // namespace

std::vector<LidControls> find_lid_controls(const rig::Rig& rig, std::span<const double> rest,
                                           std::span<const std::size_t> free, const Transfer& transfer,
                                           std::span<const EyeCurves> eyes, const geometry::Camera& camera) {
  std::vector<ModelEye> seen = model_eyes(rig, rest, transfer, eyes, camera);
  const std::vector<Push> pushes = pushes_of(rig, rest, free, seen);
  std::vector<LidControls> controls;
  for (std::size_t e = 0; e < eyes.size(); ++e) {
    LidControls& own = controls.emplace_back();
    if (!(seen[e].at_rest() > 0)) continue;
    own.close = find_close(rig, rest, seen, e, pushes);
    if (!own.close.parameters.empty()) own.widen = find_widen(rig, rest, seen, e, pushes, own.close);
  }
  return controls;
}

std::vector<std::size_t> without_lid_controls(const rig::Rig& rig, std::span<const double> rest,
                                              std::span<const std::size_t> free, const Transfer& transfer,
                                              std::span<const EyeCurves> eyes, const geometry::Camera& camera) {
  constexpr double k_lids_alone = 0.6;  // of what the control moves of all tracked points
  std::vector<bool> lid(transfer.points.size(), false);
  for (std::size_t i = 0; i < transfer.points.size(); ++i) {
    lid[i] = std::any_of(eyes.begin(), eyes.end(), [&](const EyeCurves& eye) {
      return transfer.curve[i] == eye.one || transfer.curve[i] == eye.other;
    });
  }
  SeenPoints points(rig, transfer.points, camera);
  const auto still = points.at(rest);
  std::vector<std::size_t> left;
  rig::Pose pose(rest.begin(), rest.end());
  for (const std::size_t p : free) {
    const rig::Parameter& range = rig.parameters()[p];
    pose[p] = range.maximum - rest[p] >= rest[p] - range.minimum ? range.maximum : range.minimum;
    const auto moved = points.at(pose);
    pose[p] = rest[p];
    double lids = 0;
    double all = 0;
    for (std::size_t i = 0; i < still.size(); ++i) {
      const double way = geometry::distance(still[i], moved[i]);
      all += way;
      if (lid[i]) lids += way;
    }
    if (!(lids > k_lids_alone * all)) left.push_back(p);
  }
  return left;
}

void set_lids(const rig::Rig& rig, std::span<const LidControls> controls, std::span<const double> closed,
              std::span<double> pose) {
  std::vector<std::size_t> set;
  std::vector<double> sums;
  std::vector<double> counts;
  const auto give = [&](std::size_t p, double value) {
    const auto at = std::find(set.begin(), set.end(), p);
    const auto i = static_cast<std::size_t>(at - set.begin());
    if (at == set.end()) {
      set.push_back(p);
      sums.push_back(0);
      counts.push_back(0);
    }
    sums[i] += value;
    counts[i] += 1;
  };
  for (std::size_t e = 0; e < controls.size(); ++e) {
    for (const auto* way : {&controls[e].close, &controls[e].widen}) {
      const double amount = way == &controls[e].close ? closed[e] : -closed[e];
      for (std::size_t i = 0; i < way->parameters.size(); ++i) {
        const std::size_t p = way->parameters[i];
        const double rest = rig.parameters()[p].rest;
        const bool both_ways = std::find(controls[e].close.parameters.begin(), controls[e].close.parameters.end(), p) !=
                                   controls[e].close.parameters.end() &&
                               std::find(controls[e].widen.parameters.begin(), controls[e].widen.parameters.end(), p) !=
                                   controls[e].widen.parameters.end();
        if (both_ways && !(amount > 0)) continue;  // its other way says it
        give(p, rest + (way->full[i] - rest) * (amount > 0 ? share_of_way(*way, amount) : 0.0));
      }
    }
  }
  for (std::size_t i = 0; i < set.size(); ++i) {
    const rig::Parameter& range = rig.parameters()[set[i]];
    pose[set[i]] = std::clamp(sums[i] / counts[i], range.minimum, range.maximum);
  }
}

}  // namespace penpose::animation
