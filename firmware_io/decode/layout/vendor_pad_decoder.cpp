#include "firmware_io/decode/layout/vendor_pad_decoder.h"

#include <algorithm>

namespace penpose::decode {
namespace {

/// Keys that a report of any protocol has room for at most; the buttons in wheels come after them where no tablet says
/// how many there are.
constexpr unsigned k_most_keys = 20;
constexpr unsigned k_most_wheel_buttons = 4;

bool tells_of_keys(const Layout& layout) {
  return layout.keys || layout.changed_key || layout.key_codes || layout.wheel_buttons ||
         layout.gives == Gives::touch_pad;
}

unsigned number_of_keys(const Tablet* tablet) {
  return tablet == nullptr ? k_most_keys : static_cast<unsigned>(std::max(tablet->pad_keys, 0));
}

}  // namespace

bool has_battery(const Protocol& protocol) {
  return std::any_of(protocol.rules.begin(), protocol.rules.end(),
                     [](const Protocol::Rule& rule) { return rule.layout->battery.has_value(); });
}

bool has_pad(const Protocol& protocol) {
  return std::any_of(protocol.rules.begin(), protocol.rules.end(), [](const Protocol::Rule& rule) {
    const Layout& layout = *rule.layout;
    return layout.gives == Gives::pad || tells_of_keys(layout) || layout.ring || layout.second_ring || layout.strip ||
           layout.second_strip || layout.dial || layout.second_dial;
  });
}

PadFeatures pad_features(const Protocol& protocol, const Tablet* tablet) {
  PadFeatures has;
  has.wheels_clockwise = true;
  unsigned buttons = 0;
  for (const Protocol::Rule& rule : protocol.rules) {
    const Layout& layout = *rule.layout;
    if (tells_of_keys(layout)) has.keys = numbered_keys(~std::uint64_t{0}, number_of_keys(tablet));
    if (layout.wheel_buttons) buttons = k_most_wheel_buttons;
    if (layout.ring) has.rings = std::max(has.rings, 1U);
    if (layout.second_ring) has.rings = 2;
    if (layout.strip) has.strips = std::max(has.strips, 1U);
    if (layout.second_strip) has.strips = 2;
    if (layout.dial) has.wheels = std::max(has.wheels, 1U);
    if (layout.second_dial) has.wheels = 2;
  }
  if (tablet != nullptr) {
    const auto rings = std::count_if(tablet->wheels.begin(), tablet->wheels.end(),
                                     [](const TabletWheel& wheel) { return wheel.is_ring; });
    has.rings = std::min(has.rings, static_cast<unsigned>(rings));
    has.wheels = std::min(has.wheels, static_cast<unsigned>(tablet->wheels.size() - static_cast<std::size_t>(rings)));
    buttons = 0;
    for (const TabletWheel& wheel : tablet->wheels) {
      buttons += static_cast<unsigned>(std::max(wheel.buttons, 0));
      if (wheel.is_ring && wheel.steps > 0) has.ring_maximum = static_cast<std::int32_t>(wheel.steps) - 1;
    }
  }
  has.keys |= numbered_keys(((std::uint64_t{1} << std::min(buttons, 32U)) - 1) << std::min(number_of_keys(tablet), 63U),
                            k_numbered_keys);
  return has;
}

VendorPadDecoder::VendorPadDecoder(std::unique_ptr<PenDecoder> reports, const Protocol& protocol, const Tablet* tablet)
    : PadDecoder(pad_features(protocol, tablet)),
      reports_(std::move(reports)),
      first_wheel_button_(std::min(number_of_keys(tablet), 63U)) {}

void VendorPadDecoder::reset() {
  PadDecoder::reset();
  reports_->reset();
  last_ = {};
}

bool VendorPadDecoder::decode(base::Bytes report) {
  const ReportKind kind = reports_->decode(report);
  const PadState& pad = reports_->pad();
  const bool same =
      pad.keys == last_.keys && pad.wheel_position == last_.wheel_position && pad.wheel_buttons == last_.wheel_buttons;
  sample_.wheel = {};
  battery_.percent = pad.battery;
  if (kind == ReportKind::ignored || (kind == ReportKind::pen && same)) return false;
  last_ = pad;
  sample_.keys = numbered_keys(pad.keys | std::uint64_t{pad.wheel_buttons} << first_wheel_button_, k_numbered_keys);
  sample_.ring_touched = {pad.wheel_position >= 0, pad.second_wheel_position >= 0};
  sample_.ring = {std::max(pad.wheel_position, 0), std::max(pad.second_wheel_position, 0)};
  sample_.strip = {pad.strip, pad.second_strip};
  // Steps are those of a report of the pad; in one of the pen they are old.
  if (kind == ReportKind::pad) sample_.wheel = {pad.wheel_delta, pad.second_wheel_delta};
  return true;
}

}  // namespace penpose::decode
