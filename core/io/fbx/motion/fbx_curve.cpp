#include "core/io/fbx/motion/fbx_curve.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

namespace penpose::io {
namespace {

constexpr std::size_t k_most_keys = 1'000'000;

// Flags of a key (KeyAttrFlags).
constexpr std::int64_t k_constant = 0x2, k_cubic = 0x8, k_next = 0x100, k_by_three = 0x200, k_by_user = 0x400;
constexpr std::int64_t k_flat_near = 0x1000, k_even_time = 0x2000, k_no_overshoot = 0x4000;
constexpr std::int64_t k_weighted = 0x1000000, k_weighted_next = 0x2000000;
/// Automatic slopes are flat where a neighbour is as near as this.
constexpr double k_near_value = 0.003;

/// Four numbers a key: slopes, and two lengths in one number's bits. Text files have whole numbers for the bits.
class Attributes {
 public:
  explicit Attributes(const FbxRecord& record) {
    const FbxRecord* list = record.find("KeyAttrDataFloat");
    if (list == nullptr || list->values.empty()) return;
    if (const auto* wholes = std::get_if<std::vector<std::int64_t>>(&list->values[0])) {
      for (const std::int64_t one : *wholes) bits_.push_back(static_cast<std::uint32_t>(one));
    } else if (const auto* numbers = std::get_if<std::vector<double>>(&list->values[0])) {
      for (const double one : *numbers) bits_.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(one)));
    }
  }
  [[nodiscard]] float number(std::size_t i) const {
    const float value = i < bits_.size() ? std::bit_cast<float>(bits_[i]) : 0.0F;
    return std::isfinite(value) ? value : 0.0F;
  }
  /// The low or the high half, in ten thousandths.
  [[nodiscard]] float half(std::size_t i, bool high) const {
    const std::uint32_t bits = i < bits_.size() ? bits_[i] : 0U;
    return static_cast<float>(high ? bits >> 16U : bits & 0xffffU) * 0.0001F;
  }

 private:
  std::vector<std::uint32_t> bits_;
};

struct Neighbour {
  double time_s = 0, value = 0, weight = 1. / 3;
};

/// The slope that programs give a key by themselves, as far as files of Maya and MotionBuilder show it (ufbx, whose
/// documentation says how it was measured).
double automatic_slope(const std::optional<Neighbour>& before, const Neighbour& key,
                       const std::optional<Neighbour>& after, double bias, std::int64_t flags) {
  if (!before && !after) return 0.0;
  double nearest = 1e300;
  for (const auto& one : {before, after}) {
    if (one) nearest = std::min(nearest, std::abs(one->value - key.value));
  }
  if ((flags & k_flat_near) != 0 && nearest <= k_near_value) return 0.0;
  const bool even = (flags & k_even_time) != 0;
  const double strength = std::abs(bias) / 100.0;
  const double beyond = std::max(0.0, strength - 5.0);
  if (!before || !after) {
    if ((flags & k_no_overshoot) != 0) return 0.0;
    const Neighbour& other = before ? *before : *after;
    const double slope = (key.value - other.value) / (key.time_s - other.time_s);
    return even ? slope : slope + beyond * beyond * (bias > 0.0 ? 40.0 : -40.0);
  }
  double slope = (after->value - before->value) / (after->time_s - before->time_s);
  if (!even) {
    const double left = (key.value - before->value) / (key.time_s - before->time_s);
    const double right = (after->value - key.value) / (after->time_s - key.time_s);
    const double share = (key.time_s - before->time_s) / (after->time_s - before->time_s);
    slope = 0.5 * slope + 0.5 * (left * (1.0 - share) + right * share);
    if (strength > 0.0001) {
      const double target = bias > 0.0 ? right : left;
      const double away = std::abs(target - slope) > 1e-5 ? target - slope : bias;
      slope = slope * (1.0 - strength) + target * strength + beyond * beyond * (away > 0.0 ? 40.0 : -40.0);
    }
  }
  if ((flags & k_no_overshoot) != 0) {
    const double sign = slope >= 0.0 ? 1.0 : -1.0;
    const auto limit = [&](double rise, double run) {
      return run > 0.0 && sign * rise > 0.0 ? sign * rise / run : 0.0;
    };
    slope = sign * std::min({sign * slope, limit(key.value - before->value, key.weight * (key.time_s - before->time_s)),
                             limit(after->value - key.value, after->weight * (after->time_s - key.time_s))});
  }
  return slope;
}

}  // namespace

FbxCurve::Beyond FbxCurve::beyond_of(const FbxRecord& record, const char* name) {
  const FbxRecord* list = record.find(name);
  const FbxRecord* type = list == nullptr ? nullptr : list->find("Type");
  if (type == nullptr) return {};
  const std::string_view word = type->text(0);
  const char form = word.empty() ? static_cast<char>(type->whole(0) & 0x7f) : word[0];
  if (std::string_view("KRAM").find(form) == std::string_view::npos) return {};
  const FbxRecord* times = list->find("Repetition");
  return {form, times == nullptr ? -1 : times->whole(0)};
}

FbxCurve::FbxCurve(const FbxObject& object) {
  const FbxRecord& record = *object.record;
  const std::vector<std::int64_t> ticks = record.wholes("KeyTime");
  const std::vector<double> values = record.numbers("KeyValueFloat");
  if (ticks.size() != values.size() || ticks.size() > k_most_keys) return;
  for (std::size_t i = 0; i < ticks.size(); ++i) {
    if ((i > 0 && ticks[i] <= ticks[i - 1]) || !std::isfinite(values[i])) {
      keys_.clear();
      return;
    }
    keys_.push_back({static_cast<double>(ticks[i]) / k_fbx_ticks, values[i]});
  }
  take_slopes(record);
  before_ = beyond_of(record, "Pre-Extrapolation");
  after_ = beyond_of(record, "Post-Extrapolation");
}

void FbxCurve::take_slopes(const FbxRecord& record) {
  const std::vector<std::int64_t> flags = record.wholes("KeyAttrFlags");
  const std::vector<std::int64_t> counts = record.wholes("KeyAttrRefCount");
  const Attributes attributes(record);
  std::size_t i = 0;
  for (std::size_t a = 0; a < flags.size(); ++a) {
    for (std::int64_t k = 0; k < (a < counts.size() ? counts[a] : 1) && i < keys_.size(); ++k, ++i) {
      Key& key = keys_[i];
      Key* last = i > 0 ? &keys_[i - 1] : nullptr;
      if ((flags[a] & k_constant) != 0) {
        key.form = (flags[a] & k_next) != 0 ? Form::step_to_next : Form::step;
      } else if ((flags[a] & k_cubic) != 0) {
        key.form = Form::spline;
        key.leaves = attributes.number(4 * a);
        key.arrives = attributes.number(4 * a + 1);
        if ((flags[a] & k_weighted) != 0) key.leaves_weight = attributes.half(4 * a + 2, false);
        if ((flags[a] & k_weighted_next) != 0) key.arrives_weight = attributes.half(4 * a + 2, true);
      }
      if (key.form != Form::spline || (flags[a] & k_by_user) != 0) continue;
      std::optional<Neighbour> before;
      std::optional<Neighbour> after;
      if (last != nullptr) before = {last->time_s, last->value};
      if (i + 1 < keys_.size()) after = {keys_[i + 1].time_s, keys_[i + 1].value, double{key.leaves_weight}};
      const double arrives = last != nullptr ? static_cast<double>(last->arrives) : 0.0;
      const Neighbour self{key.time_s, key.value, last != nullptr ? static_cast<double>(last->arrives_weight) : 1. / 3};
      double in = 0;
      double out = 0;
      if ((flags[a] & k_by_three) != 0) {
        // Tension, continuity and bias, by Kochanek and Bartels.
        const double tension = double{attributes.number(4 * a)};
        const double continuity = double{attributes.number(4 * a + 1)};
        const double bias = double{attributes.number(4 * a + 2)};
        const double left = before ? (key.value - before->value) / (key.time_s - before->time_s) : 0.0;
        const double right = after ? (after->value - key.value) / (after->time_s - key.time_s) : 0.0;
        const double share = (before && after ? 0.5 : 1.0) * (1.0 - tension);
        in = share * ((1 + bias) * (1 - continuity) * left + (1 - bias) * (1 + continuity) * right);
        out = share * ((1 + bias) * (1 + continuity) * left + (1 - bias) * (1 - continuity) * right);
        key.arrives = 0.F;
      } else {
        const double bias_out = double{key.leaves};
        const double bias_in = before && after && std::abs(arrives + bias_out) <= 1e-4 ? bias_out : -arrives;
        in = automatic_slope(before, self, after, bias_in, flags[a]);
        out = automatic_slope(before, self, after, before && !after ? bias_in : bias_out, flags[a]);
      }
      if (last != nullptr && last->form == Form::spline) last->arrives = static_cast<float>(in);
      key.leaves = static_cast<float>(out);
    }
  }
}

void FbxCurve::add_times(std::vector<double>& times) const {
  for (const Key& key : keys_) times.push_back(key.time_s);
}

void FbxCurve::add_jumps(std::vector<double>& times) const {
  for (std::size_t i = 1; i < keys_.size(); ++i) {
    const Form form = keys_[i - 1].form;
    if ((form == Form::step || form == Form::step_to_next) && keys_[i].value != keys_[i - 1].value)
      times.push_back(form == Form::step ? keys_[i].time_s : keys_[i - 1].time_s);
  }
}

bool FbxCurve::steps() const {
  return std::all_of(keys_.begin(), keys_.end(), [](const Key& key) { return key.form == Form::step; });
}

bool FbxCurve::leaves(double value) const {
  const double room = 1e-9 * std::max(1.0, std::abs(value));
  return goes_on() || std::any_of(keys_.begin(), keys_.end(), [&](const Key& key) {
           return std::abs(key.value - value) > room ||
                  (key.form == Form::spline && (key.leaves != 0.F || key.arrives != 0.F));
         });
}

double FbxCurve::least() const {
  return std::min_element(keys_.begin(), keys_.end(), [](const Key& a, const Key& b) { return a.value < b.value; })
      ->value;
}

double FbxCurve::greatest() const {
  return std::max_element(keys_.begin(), keys_.end(), [](const Key& a, const Key& b) { return a.value < b.value; })
      ->value;
}

FbxCurve::Way FbxCurve::way_between(double from_s, double to_s) const {
  const double middle = 0.5 * (from_s + to_s);
  if (middle < first_s() || middle > last_s()) {
    const Beyond& beyond = middle < first_s() ? before_ : after_;
    return beyond.form == 'C' ? Way::still : beyond.form == 'K' ? Way::straight : Way::bent;
  }
  const auto next = std::upper_bound(keys_.begin(), keys_.end(), middle,
                                     [](double time_s, const Key& key) { return time_s < key.time_s; });
  if (next == keys_.begin() || next == keys_.end()) return Way::still;
  const Key& key = *(next - 1);
  if (key.form == Form::step || key.form == Form::step_to_next) return Way::still;
  if (key.form == Form::line) return next->value == key.value ? Way::still : Way::straight;
  return key.leaves == 0.F && key.arrives == 0.F && next->value == key.value ? Way::still : Way::bent;
}

double FbxCurve::between(std::size_t i, double time_s) const {
  const Key& key = keys_[i];
  const Key& next = keys_[i + 1];
  if (key.form == Form::step) return key.value;
  if (key.form == Form::step_to_next) return next.value;
  const double length = next.time_s - key.time_s;
  const double t = (time_s - key.time_s) / length;
  if (key.form == Form::line) return key.value + (next.value - key.value) * t;
  // A Bezier curve whose inner points lie along the slopes; times of theirs ascend, so that halving finds the moment.
  const double a = std::clamp(double{key.leaves_weight}, 0.0, 1.0);
  const double b = 1.0 - std::clamp(double{key.arrives_weight}, 0.0, 1.0);
  double s = t;
  if (std::abs(a - 1. / 3) > 1e-5 || std::abs(b - 2. / 3) > 1e-5) {
    double low = 0;
    double high = 1;
    for (int step = 0; step < 40; ++step) {
      s = 0.5 * (low + high);
      const double u = 1.0 - s;
      (3.0 * u * u * s * a + 3.0 * u * s * s * b + s * s * s < t ? low : high) = s;
    }
  }
  const double u = 1.0 - s;
  const double behind = key.value + double{key.leaves} * a * length;
  const double before = next.value - double{key.arrives} * (1.0 - b) * length;
  return u * u * u * key.value + 3.0 * u * u * s * behind + 3.0 * u * s * s * before + s * s * s * next.value;
}

double FbxCurve::within(double time_s) const {
  const auto next = std::upper_bound(keys_.begin(), keys_.end(), time_s,
                                     [](double time, const Key& key) { return time < key.time_s; });
  if (next == keys_.begin()) return keys_.front().value;
  if (next == keys_.end()) return keys_.back().value;
  return between(static_cast<std::size_t>(next - keys_.begin()) - 1, time_s);
}

double FbxCurve::outside(double time_s, const Beyond& beyond, bool before) const {
  const Key& edge = before ? keys_.front() : keys_.back();
  const double length = last_s() - first_s();
  if (beyond.form == 'C' || beyond.times == 0 || length <= 0.0) return edge.value;
  if (beyond.form == 'K') {
    const Key& key = before ? keys_.front() : keys_[keys_.size() - 2];
    const Key& next = before ? keys_[1] : keys_.back();
    const double line = (next.value - key.value) / (next.time_s - key.time_s);
    const double slope = key.form == Form::spline ? double{before ? key.leaves : key.arrives}
                         : key.form == Form::line ? line
                                                  : 0.0;
    return edge.value + slope * (time_s - edge.time_s);
  }
  const double away = before ? first_s() - time_s : time_s - last_s();
  double round = std::floor(away / length);
  double rest = away - round * length;
  if (beyond.times > 0 && round >= static_cast<double>(beyond.times)) {
    round = static_cast<double>(beyond.times - 1);
    rest = length;
  }
  if (beyond.form == 'M' && std::fmod(round, 2.0) < 0.5) rest = length - rest;
  if (before) rest = length - rest;
  const double value = within(first_s() + rest);
  if (beyond.form != 'A') return value;
  return value + (keys_.back().value - keys_.front().value) * (round + 1.0) * (before ? -1.0 : 1.0);
}

double FbxCurve::at(double time_s) const {
  if (time_s < first_s()) return outside(time_s, before_, true);
  if (time_s > last_s()) return outside(time_s, after_, false);
  return within(time_s);
}

}  // namespace penpose::io
