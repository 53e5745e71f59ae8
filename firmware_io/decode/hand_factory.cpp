#include "firmware_io/decode/hand_factory.h"

#include <algorithm>

#include "firmware_io/decode/chosen_tablet.h"
#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/described/battery_decoder.h"
#include "firmware_io/decode/described/described_pad_decoder.h"
#include "firmware_io/decode/described/multitouch_decoder.h"
#include "firmware_io/decode/layout/layout_decoder.h"
#include "firmware_io/decode/layout/protocol.h"
#include "firmware_io/decode/layout/vendor_pad_decoder.h"
#include "firmware_io/decode/layout/vendor_touch_decoder.h"
#include "firmware_io/decode/wacom/hand/wacom_generic_pad_decoder.h"
#include "firmware_io/decode/wacom/hand/wacom_generic_touch_decoder.h"
#include "firmware_io/decode/wacom/hand/wacom_pad_decoder.h"
#include "firmware_io/decode/wacom/hand/wacom_touch_decoder.h"
#include "firmware_io/decode/wacom/wacom_models.h"
#include "firmware_io/decode/wacom/wacom_receiver.h"
#include "firmware_io/decode/wacom/wacom_usages.h"
#include "firmware_io/hid/event_mark.h"

namespace penpose::decode {
namespace {

using hid::ReportDescriptor;
using hid::ReportType;

constexpr std::uint32_t k_two_fingers_length = 20;
constexpr std::uint32_t k_many_fingers_length = 64;
constexpr std::int32_t k_hand_message_maximum = 4096;  ///< of positions in messages of eight bytes
/// Room for fingers where the tablet has to be asked for it, which a decoder cannot.
constexpr std::uint8_t k_assumed_contacts = 16;

/// What the collections of a Wacom interface say is on it, though not how it is told of.
struct Carried {
  bool nothing_said = true;  ///< there is no descriptor
  bool pen = false;
  bool fingers = false;
  bool asks_contacts = false;  ///< says that it knows how many fingers it follows
  std::uint32_t length = 0;
  Axis x, y;  ///< of the fingers
};

Carried carried(const ReportDescriptor& descriptor) {
  Carried has;
  has.nothing_said = descriptor.fields.empty();
  has.length = descriptor.longest_report(ReportType::input);
  for (const hid::Field& field : descriptor.fields) {
    if (field.usages.empty()) continue;
    const hid::Usage usage = standard_usage(field.usage_of(0));
    has.asks_contacts = has.asks_contacts || (field.type == ReportType::feature && usage == hid::k_contact_max);
    if (field.type != ReportType::input) continue;
    const bool pen = is_wacom_pen(descriptor, field);
    const bool finger = !pen && is_wacom_finger(descriptor, field);
    has.pen = has.pen || pen;
    has.fingers = has.fingers || finger;
    for (std::uint32_t i = 0; finger && i < std::min<std::uint64_t>(field.count, k_most_controls_of_field); ++i) {
      const hid::Usage one = standard_usage(field.usage_of(i));
      if (one != hid::k_x && one != hid::k_y) continue;
      (one == hid::k_x ? has.x : has.y) = {static_cast<std::int32_t>(field.logical_minimum),
                                           static_cast<std::int32_t>(field.logical_maximum), hid::units_per_mm(field),
                                           true};
    }
  }
  return has;
}

bool has_wacom_pad(const WacomHand& hand, const Carried& has) {
  switch (hand.pad) {
    case WacomPad::none:
      return false;
    case WacomPad::bamboo:
    case WacomPad::intuos_ht:
      return has.nothing_said || has.length == k_two_fingers_length || has.length == k_many_fingers_length;
    case WacomPad::remote:
    case WacomPad::intuos_pro_bluetooth:
    case WacomPad::intuos_2018_bluetooth:
      return true;
    default:
      return has.nothing_said || has.pen;
  }
}

bool has_wacom_touch(const WacomHand& hand, const Carried& has) {
  switch (hand.touch) {
    case WacomTouch::none:
      return false;
    case WacomTouch::bamboo:
      return has.nothing_said || has.fingers || has.length == k_two_fingers_length ||
             has.length == k_many_fingers_length;
    case WacomTouch::intuos:
      return has.nothing_said || has.fingers || has.length == k_many_fingers_length;
    case WacomTouch::intuos_pro_bluetooth:
    case WacomTouch::bamboo_pad:
      return true;
    default:
      return has.nothing_said || (has.fingers && !has.pen);
  }
}

Axis hand_axis_to(std::int32_t maximum, double units_per_mm = 0) { return {0, maximum, units_per_mm, true}; }

std::unique_ptr<TouchDecoder> make_wacom_touch(const WacomHand& hand, const DeviceIdentity& device,
                                               const Carried& has) {
  TouchAxes axes{has.x, has.y, hand.contacts, false};
  if (axes.contacts == 0) axes.contacts = has.asks_contacts ? k_assumed_contacts : 1;
  const WacomModel* model = find_wacom_model(device.bus, device.vendor, device.product);
  const double width_mm = model != nullptr && model->units_per_mm > 0 ? model->max_x / model->units_per_mm : 0;
  const double height_mm = model != nullptr && model->units_per_mm > 0 ? model->max_y / model->units_per_mm : 0;
  const auto over_pen_area = [&](std::int32_t max_x, std::int32_t max_y) {
    axes.x = hand_axis_to(max_x, width_mm > 0 ? max_x / width_mm : 0);
    axes.y = hand_axis_to(max_y, height_mm > 0 ? max_y / height_mm : 0);
  };
  bool coarse = false;
  switch (hand.touch) {
    case WacomTouch::bamboo:
    case WacomTouch::intuos:
      coarse = hand.pad == WacomPad::bamboo && (has.length == k_two_fingers_length || has.nothing_said);
      if (coarse) {
        axes.x.maximum <<= 5;
        axes.y.maximum <<= 5;
        axes.x.units_per_mm *= 32;
        axes.y.units_per_mm *= 32;
        if (!axes.x.present || !axes.y.present) over_pen_area(0x7ff << 5, 0x7ff << 5);
      } else if (model != nullptr && model->family == WacomFamily::intuos_2015) {
        over_pen_area(model->max_x / 10, model->max_y / 10);
      } else {
        over_pen_area(k_hand_message_maximum, k_hand_message_maximum);
      }
      break;
    case WacomTouch::intuos_pro_bluetooth:
      if (model != nullptr) over_pen_area(model->max_x / 5, model->max_y / 5);
      break;
    case WacomTouch::bamboo_pad:
      axes.x = hand_axis_to(4095, 0);
      axes.y = hand_axis_to(4095, 0);
      break;
    default:
      axes.on_screen = true;
      break;
  }
  return std::make_unique<WacomTouchDecoder>(hand.touch, axes, coarse);
}

HandDecoders make_fixed_wacom(const WacomHand& hand, const DeviceIdentity& device, const ReportDescriptor& descriptor) {
  HandDecoders made;
  const Carried has = carried(descriptor);
  if (has_wacom_pad(hand, has)) made.pad = std::make_unique<WacomPadDecoder>(hand);
  if (has_wacom_touch(hand, has)) made.touch = make_wacom_touch(hand, device, has);
  return made;
}

HandDecoders make_described_wacom(const DeviceIdentity& device, const ReportDescriptor& descriptor,
                                  const std::shared_ptr<TouchSwitch>& touch_switch) {
  HandDecoders made;
  if (auto pad = find_wacom_pad(descriptor, device.product))
    made.pad = std::make_unique<WacomGenericPadDecoder>(std::move(*pad), touch_switch);
  if (auto fingers = find_wacom_fingers(descriptor))
    made.touch = std::make_unique<WacomGenericTouchDecoder>(std::move(*fingers), touch_switch);
  return made;
}

std::unique_ptr<PadDecoder> make_table_pad(const TabletMatch& match, const DeviceIdentity& device,
                                           const TabletTable* own) {
  const Protocol& protocol = *match.identifier->protocol;
  if (!has_pad(protocol) && !has_battery(protocol)) return nullptr;
  auto reports = make_decoder(device, own);
  if (!reports) return nullptr;
  return std::make_unique<VendorPadDecoder>(std::move(reports->decoder), *match.identifier->protocol, match.tablet);
}

std::unique_ptr<TouchDecoder> make_table_touch(const std::shared_ptr<const Protocol>& protocol, const Tablet* tablet) {
  if (!has_touch(*protocol)) return nullptr;
  return std::make_unique<VendorTouchDecoder>(protocol, tablet);
}

HandDecoders make_table_hand(const TabletMatch& match, const DeviceIdentity& device, const TabletTable* own) {
  HandDecoders made{make_table_pad(match, device, own), make_table_touch(match.identifier->protocol, match.tablet)};
  if (made.pad || made.touch) made.guess = guess_of(match, device);
  return made;
}

HandDecoders make_hand_decoders_of(const DeviceIdentity& device, const TabletTable* own,
                                   const std::shared_ptr<TouchSwitch>& touch_switch) {
  ReportDescriptor descriptor;
  if (!device.report_descriptor.empty()) {
    auto parsed = hid::parse_report_descriptor(device.report_descriptor, hid::Strictness::tolerant);
    if (parsed) descriptor = std::move(parsed).value();
  }
  if (hid::has_event_mark(device.report_descriptor)) {
    HandDecoders made;
    if (auto fingers = find_multitouch(descriptor))
      made.touch = std::make_unique<MultitouchDecoder>(std::move(*fingers));
    if (auto pad = find_described_pad(descriptor)) {
      // Wacom's driver counts as Linux does, others leave their tablets' numbers alone.
      pad->features.wheels_clockwise = device.vendor != k_vendor_wacom;
      made.pad = std::make_unique<DescribedPadDecoder>(std::move(*pad), std::nullopt, nullptr, 0);
    }
    return made;
  }
  DeviceIdentity completed = device;
  complete_identity(completed);
  if (own != nullptr && !own->is_choice()) {
    if (const auto match = own->find(completed)) {
      return make_table_hand(*match, device, own);
    }
  }
  if (is_wacom_receiver(completed)) {
    HandDecoders made;
    if (is_receiver_monitor(completed)) made.pad = std::make_unique<ReceiverMonitor>();
    return made;
  }
  if (const WacomHand* hand = find_wacom_hand(device.bus, device.vendor, device.product))
    return make_fixed_wacom(*hand, device, descriptor);
  if (find_wacom_model(device.bus, device.vendor, device.product) != nullptr) return {};
  const bool wacom = device.vendor == k_vendor_wacom;
  HandDecoders made;
  if (wacom) {
    made = make_described_wacom(device, descriptor, touch_switch);
  } else if (auto fingers = find_multitouch(descriptor)) {
    made.touch = std::make_unique<MultitouchDecoder>(std::move(*fingers));
  }
  if (made.pad || (wacom && made.touch)) return made;
  const auto match = find_tablet(completed, own);
  if (match) {
    HandDecoders known = make_table_hand(*match, device, own);
    if (made.touch) known.touch = std::move(made.touch);
    made = std::move(known);
  }
  if (wacom) return made;
  const auto power = find_battery(descriptor);
  if (auto pad = find_described_pad(descriptor)) {
    const int keys = match && match->certain ? match->tablet->pad_keys : 0;
    made.pad = std::make_unique<DescribedPadDecoder>(std::move(*pad), power, std::move(made.pad),
                                                     static_cast<unsigned>(std::max(keys, 0)));
  } else if (power && !made.pad) {
    made.pad = std::make_unique<BatteryDecoder>(*power);
  }
  return made;
}

}  // namespace

HandDecoders make_hand_decoders(const DeviceIdentity& device, const TabletTable* own,
                                std::shared_ptr<TouchSwitch> touch_switch) {
  return make_hand_decoders_of(identified(device, own), own, touch_switch);
}

HandDecoders make_protocol_hand_decoders(std::string_view name) {
  const auto found = known_protocols().find(name);
  if (found == known_protocols().end()) return {};
  HandDecoders made;
  if (has_pad(*found->second)) {
    made.pad =
        std::make_unique<VendorPadDecoder>(std::make_unique<LayoutDecoder>(found->second), *found->second, nullptr);
  }
  made.touch = make_table_touch(found->second, nullptr);
  return made;
}

}  // namespace penpose::decode
