#include "core/io/gltf/write/dense_keys.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/document/time/animation_sampling.h"

namespace penpose::io {
namespace {

using Row = std::vector<double>;

/// Numbers of a spline, keys times targets, that a file has beside its straight lines.
constexpr std::size_t k_most_straightened = 50'000;

/// A key of a file: the weights of all targets; slopes a second where the channel is a cubic spline.
struct Key {
  float time_s = 0;
  Row in;
  Row value;
  Row out;
};

/// Cubic Hermite at share t of a span: value and slope a second.
struct Hermite {
  double value;
  double slope;
};
Hermite hermite(double a, double out, double b, double in, double span_s, double t) {
  const double t2 = t * t;
  const double t3 = t2 * t;
  const double value =
      (2 * t3 - 3 * t2 + 1) * a + span_s * (t3 - 2 * t2 + t) * out + (3 * t2 - 2 * t3) * b + span_s * (t3 - t2) * in;
  const double slope = (6 * t2 - 6 * t) * (a - b) / span_s + (3 * t2 - 4 * t + 1) * out + (3 * t2 - 2 * t) * in;
  return {value, slope};
}

/// The usual rate for which all keys lie on whole frames; 0: there is none.
double rate_of_keys(std::span<const double> times_s) {
  constexpr double k_off_frame = 1e-3;
  constexpr std::array<double, 11> k_rates{
      24, 25, 30, 12, 15, 50, 60, 120, 24000 / 1001.0, 30000 / 1001.0, 60000 / 1001.0};
  const auto found = std::find_if(k_rates.begin(), k_rates.end(), [&](double rate) {
    return std::all_of(times_s.begin(), times_s.end(), [&](double time_s) {
      return std::abs(time_s * rate - std::round(time_s * rate)) <= k_off_frame;
    });
  });
  return found == k_rates.end() ? 0 : *found;
}

class Densifier {
 public:
  Densifier(const document::Channel& channel, const GlbTargets& targets, double tolerance)
      : channel_(channel),
        targets_(targets),
        tolerance_(tolerance),
        own_(targets.own_count()),
        cubic_(channel.interpolation == document::Interpolation::cubic_spline),
        straight_(cubic_ && channel.times_s.size() * targets.all().size() <= k_most_straightened),
        fps_(straight_ && targets.all().size() == own_ ? rate_of_keys(channel.times_s) : 0),
        first_(straight_ ? 0 : own_) {
    const auto all = targets.all();
    for (std::size_t k = first_; k < all.size(); ++k) {
      double most = 0;
      for (const glm::vec3& delta : all[k]->deltas)
        most = std::max(most, geometry::length(geometry::ModelVector(delta)));
      reach_.push_back(most);
      if (!all[k]->vertices.empty()) moved_.resize(std::max<std::size_t>(moved_.size(), all[k]->vertices.back() + 1U));
    }
  }

  DenseKeys run() {
    DenseKeys keys;
    keys.straightened = straight_;
    for (std::size_t k = 0; k < channel_.times_s.size(); ++k) {
      auto time = static_cast<float>(channel_.times_s[k]);
      // Moments that are too close for floats must still ascend (glTF 2.0, section 3.11).
      if (k > 0 && !(time > keys.times_s.back()))
        time = std::nextafter(keys.times_s.back(), std::numeric_limits<float>::infinity());
      Key key = own_key(k, time);
      if (straight_) {
        keys.spline.times_s.push_back(time);
        for (const Row* row : {&key.in, &key.value, &key.out}) keys.spline.rows.push_back(*row);
      }
      if (k > 0 && targets_.all().size() > first_ && channel_.interpolation != document::Interpolation::step) {
        constexpr int k_halvings = 7;
        before_ = k - 1;
        fill(last_, key, k_halvings, keys);
      }
      push(key, keys);
      last_ = std::move(key);
    }
    keys.error = error_;
    return keys;
  }

 private:
  [[nodiscard]] std::span<const double> run_of(std::size_t key, std::size_t row) const {
    return std::span(channel_.values).subspan((key * (cubic_ ? 3 : 1) + row) * own_, own_);
  }

  /// A key of the channel itself.
  [[nodiscard]] Key own_key(std::size_t k, float time_s) const {
    if (!cubic_) return {time_s, {}, targets_.weights(run_of(k, 0)), {}};
    const auto value = run_of(k, 1);
    return {time_s, targets_.tangents(run_of(k, 0), value), targets_.weights(value),
            targets_.tangents(run_of(k, 2), value)};
  }

  /// What the key would be at a time between `before_` and the next.
  [[nodiscard]] Key key_at(double time_s) const {
    const double from = channel_.times_s[before_];
    const double span_s = channel_.times_s[before_ + 1] - from;
    const double t = std::clamp((time_s - from) / span_s, 0.0, 1.0);
    Row value(own_);
    Row slope(own_);
    for (std::size_t i = 0; i < own_; ++i) {
      if (cubic_) {
        const auto at = hermite(run_of(before_, 1)[i], run_of(before_, 2)[i], run_of(before_ + 1, 1)[i],
                                run_of(before_ + 1, 0)[i], span_s, t);
        value[i] = at.value;
        slope[i] = at.slope;
      } else {
        value[i] = run_of(before_, 0)[i] + (run_of(before_ + 1, 0)[i] - run_of(before_, 0)[i]) * t;
      }
    }
    Key key{static_cast<float>(time_s), {}, targets_.weights(value), {}};
    if (cubic_) key.in = key.out = targets_.tangents(slope, value);
    return key;
  }

  /// Farthest that a vertex is off between two keys of the file.
  double error_between(const Key& a, const Key& b) {
    constexpr int k_samples = 7;
    const double from = static_cast<double>(a.time_s);
    const double span_s = static_cast<double>(b.time_s) - from;
    double most = 0;
    Row off(reach_.size());
    for (int s = 1; s <= k_samples; ++s) {
      const double t = static_cast<double>(s) / (k_samples + 1);
      const Row wanted = key_at(from + span_s * t).value;
      double bound = 0;
      for (std::size_t k = 0; k < off.size(); ++k) {
        const std::size_t i = first_ + k;
        const double shown = cubic_ && !straight_ ? hermite(a.value[i], a.out[i], b.value[i], b.in[i], span_s, t).value
                                                  : a.value[i] + (b.value[i] - a.value[i]) * t;
        off[k] = wanted[i] - shown;
        bound += std::abs(off[k]) * reach_[k];
      }
      // The bound is enough to know that all is well.
      most = std::max(most, bound > 0.5 * tolerance_ ? farthest(off) : bound);
    }
    return most;
  }

  double farthest(const Row& off) {
    std::fill(moved_.begin(), moved_.end(), geometry::ModelVector(0));
    for (std::size_t k = 0; k < off.size(); ++k) {
      if (off[k] == 0) continue;
      const rig::BlendShape& target = *targets_.all()[first_ + k];
      for (std::size_t i = 0; i < target.vertices.size(); ++i) {
        moved_[target.vertices[i]] += geometry::ModelVector(target.deltas[i]) * off[k];
      }
    }
    double most = 0;
    for (const auto& v : moved_) most = std::max(most, v.x * v.x + v.y * v.y + v.z * v.z);
    return std::sqrt(most);
  }

  /// Half-way between two keys: on a whole frame where the channel's keys are.
  [[nodiscard]] float middle_of(float from_s, float to_s) const {
    const float middle = from_s + (to_s - from_s) / 2;
    return fps_ > 0 ? static_cast<float>(std::round(static_cast<double>(middle) * fps_) / fps_) : middle;
  }

  void fill(const Key& a, const Key& b, int halvings, DenseKeys& keys) {
    const double error = error_between(a, b);
    const float middle = middle_of(a.time_s, b.time_s);
    if (error <= tolerance_ || halvings == 0 || !(middle > a.time_s && middle < b.time_s)) {
      error_ = std::max(error_, error);
      return;
    }
    const Key key = key_at(static_cast<double>(middle));
    fill(a, key, halvings - 1, keys);
    keys.added.push_back(keys.times_s.size());
    push(key, keys);
    fill(key, b, halvings - 1, keys);
  }

  void push(const Key& key, DenseKeys& keys) const {
    keys.times_s.push_back(key.time_s);
    if (cubic_ && !straight_) keys.rows.push_back(key.in);
    keys.rows.push_back(key.value);
    if (cubic_ && !straight_) keys.rows.push_back(key.out);
  }

  const document::Channel& channel_;
  const GlbTargets& targets_;
  double tolerance_;
  std::size_t own_;
  bool cubic_;
  bool straight_;
  double fps_;         ///< all keys lie on whole frames of that rate; 0: they do not, or are not straightened
  std::size_t first_;  ///< of the targets that are looked at between keys: all of them, or those that are not its own
  std::vector<double> reach_;                 ///< one a target that is looked at: how far it moves a vertex
  std::vector<geometry::ModelVector> moved_;  ///< scratch, one a vertex
  std::size_t before_ = 0;
  Key last_;
  double error_ = 0;
};

}  // namespace

DenseKeys dense_keys(const document::Channel& channel, const GlbTargets& targets, double tolerance) {
  return Densifier(channel, targets, tolerance).run();
}

}  // namespace penpose::io
