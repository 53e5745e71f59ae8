#include "firmware_io/decode/described/described_pad_decoder.h"

#include <algorithm>

#include "firmware_io/decode/sample/pad_events.h"

namespace penpose::decode {
namespace {

using Role = DescribedPadRole;

bool counts_steps(const DescribedPadControl& control) {
  return control.role == Role::wheel || control.role == Role::dial;
}

}  // namespace

DescribedPadDecoder::DescribedPadDecoder(DescribedPad pad, const std::optional<BatteryLayout>& battery,
                                         std::unique_ptr<PadDecoder> vendor, unsigned keys)
    : PadDecoder(pad.features),
      pad_(std::move(pad)),
      last_(pad_.controls.size()),
      charge_(battery),
      vendor_(std::move(vendor)) {
  if (keys > 0) {
    PadKeys kept;
    for (const DescribedPadControl& control : pad_.controls) {
      const bool is_key = control.role == Role::key && features_.keys.has(control.key);
      if (is_key && kept.count() < keys) kept.set(control.key);
    }
    features_.keys = kept;
  }
  if (vendor_) features_.wheels = std::max(features_.wheels, vendor_->features().wheels);
}

void DescribedPadDecoder::reset() {
  PadDecoder::reset();
  std::fill(last_.begin(), last_.end(), 0);
  if (vendor_) vendor_->reset();
}

bool DescribedPadDecoder::decode(base::Bytes report) {
  if (charge_) {
    if (const auto percent = charge_in(*charge_, report)) battery_.percent = *percent;
  }
  const std::uint8_t id = pad_.has_report_ids && !report.empty() ? report[0] : 0;
  if (!pad_.has(report) || (vendor_ && pad_.length[id] != report.size())) return decode_vendor(report);
  sample_.wheel = {};
  sample_.fine_wheel = {};
  std::optional<bool> finger;
  for (std::size_t i = 0; i < pad_.controls.size(); ++i) {
    const DescribedPadControl& control = pad_.controls[i];
    if (control.report_id != id) continue;
    const auto value = control.value(report);
    if (!value) continue;
    if (control.role == Role::finger) finger = *value != 0;
    if (!counts_steps(control) && *value == last_[i]) continue;
    last_[i] = *value;
    apply(control, *value);
  }
  for (const DescribedPadControl& control : pad_.controls) {
    if (control.report_id != id) continue;
    const std::uint8_t side = control.side;
    if (control.role == Role::ring) sample_.ring_touched[side] = finger.value_or(sample_.ring[side] != 0);
    if (control.role == Role::strip) sample_.strip_at_zero[side] = finger.value_or(false) && sample_.strip[side] == 0;
  }
  return true;
}

bool DescribedPadDecoder::decode_vendor(base::Bytes report) {
  if (!vendor_) return false;
  const bool told = vendor_->decode(report);
  if (vendor_->battery().percent >= 0) battery_ = vendor_->battery();
  if (told) sample_ = vendor_->sample();
  return told;
}

void DescribedPadDecoder::apply(const DescribedPadControl& control, std::int64_t value) {
  const auto number = static_cast<std::int32_t>(std::clamp<std::int64_t>(value, INT32_MIN, INT32_MAX));
  // More than a hand turns within a report, and far from what overflows.
  constexpr std::int32_t k_most_steps = 1 << 20;
  const std::int32_t steps = std::clamp(number, -k_most_steps, k_most_steps);
  switch (control.role) {
    case Role::key:
      sample_.keys.set(control.key, value != 0);
      return;
    case Role::ring:
      sample_.ring[control.side] = number;
      return;
    case Role::strip:
      sample_.strip[control.side] = number;
      return;
    case Role::wheel:
      sample_.wheel[control.side] += steps;
      sample_.fine_wheel[control.side] += steps * k_notch;
      return;
    case Role::dial:
      // Linux's whole steps are those of its two wheels.
      sample_.fine_wheel[control.side] += steps * k_notch;
      return;
    case Role::finger:
      return;
  }
}

}  // namespace penpose::decode
