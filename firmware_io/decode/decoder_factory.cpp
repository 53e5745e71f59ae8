#include "firmware_io/decode/decoder_factory.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text/letters.h"
#include "firmware_io/decode/chosen_tablet.h"
#include "firmware_io/decode/described/descriptor_decoder.h"
#include "firmware_io/decode/described/fallback_decoder.h"
#include "firmware_io/decode/layout/layout_decoder.h"
#include "firmware_io/decode/layout/pen_axes.h"
#include "firmware_io/decode/layout/protocol.h"
#include "firmware_io/decode/table/told_ranges.h"
#include "firmware_io/decode/wacom/wacom_axes.h"
#include "firmware_io/decode/wacom/wacom_display_decoder.h"
#include "firmware_io/decode/wacom/wacom_generic_decoder.h"
#include "firmware_io/decode/wacom/wacom_intuos_decoder.h"
#include "firmware_io/decode/wacom/wacom_models.h"
#include "firmware_io/decode/wacom/wacom_pens.h"
#include "firmware_io/decode/wacom/wacom_receiver.h"
#include "firmware_io/decode/wacom/wacom_usages.h"
#include "firmware_io/hid/event_mark.h"

namespace penpose::decode {
namespace {

using F = WacomFamily;

/// Reports of these lengths carry touch on the Bamboos and later Intuos, whatever else the descriptor leaves out.
constexpr std::uint32_t k_touch_length = 20;
constexpr std::uint32_t k_many_touches_length = 64;

bool has_touch_interface(F family) {
  return family == F::bamboo || family == F::intuos_2015 || family == F::intuos5 || family == F::intuos5_large;
}

/// Whether this is the interface of a Wacom tablet that carries its pen. The descriptors of these models tell only
/// which collections there are, not what their bytes mean; one that tells nothing is taken for the pen's.
bool carries_wacom_pen(const WacomModel& model, const hid::ReportDescriptor& descriptor) {
  if (model.family == F::touch_only) return false;
  bool touch = false;
  for (const hid::Field& field : descriptor.fields) {
    if (field.type != hid::ReportType::input) continue;
    if (is_wacom_pad(descriptor, field)) continue;
    if (is_wacom_pen(descriptor, field)) return true;
    touch = touch || is_wacom_finger(descriptor, field);
  }
  const std::uint32_t length = descriptor.longest_report(hid::ReportType::input);
  const bool touch_length = length == k_touch_length || length == k_many_touches_length;
  return !touch && !(has_touch_interface(model.family) && touch_length);
}

/// Takes over ranges that the interface's descriptor states itself. The size stays the model's own, as Linux's wacom
/// driver has it (wacom_set_default_phy): units per mm follow the range.
void adopt_described_ranges(WacomModel& model, const hid::ReportDescriptor& descriptor) {
  const auto pens = find_pens(descriptor, Dialect::wacom);
  if (!pens) return;
  const auto adopt = [&model](std::int32_t& maximum, const Axis& described) {
    const double stretch = described.present && maximum > 0 ? static_cast<double>(described.maximum) / maximum : 1.0;
    if (described.present) maximum = described.maximum;
    return static_cast<std::int32_t>(std::lround(model.units_per_mm * stretch));
  };
  if (pens->axes.pressure.present) model.max_pressure = pens->axes.pressure.maximum;
  const std::int32_t units_x = adopt(model.max_x, pens->axes.x);
  model.units_per_mm_y = adopt(model.max_y, pens->axes.y);
  model.units_per_mm = units_x;
}

std::unique_ptr<PenDecoder> make_wacom_decoder(const WacomModel& model) {
  switch (model.family) {
    case F::penpartner:
      return make_wacom_penpartner(model);
    case F::graphire:
    case F::graphire4:
    case F::graphire_bluetooth:
    case F::bamboo_first:
      return make_wacom_graphire(model);
    case F::bamboo:
      return make_wacom_bamboo(model);
    case F::intuos_pro_bluetooth:
    case F::intuos_2018_bluetooth:
      return make_wacom_bluetooth(model);
    case F::pl:
    case F::ptu:
    case F::dtu:
    case F::dtus:
    case F::tablet_pc:
      return std::make_unique<WacomDisplayDecoder>(model);
    case F::touch_only:
      return nullptr;
    default:
      return std::make_unique<WacomIntuosDecoder>(model);
  }
}

base::Error unreadable(const DeviceIdentity& device, const std::optional<base::Error>& descriptor_error) {
  base::Error error{"no pen that is known: neither its descriptor nor the table of tablets says how to read it",
                    device.name, "name a protocol, or add the tablet with a file of your own"};
  if (descriptor_error) {
    error.what += " (" + descriptor_error->what + " at " + descriptor_error->place + ")";
  }
  return error;
}

base::Result<Recognition> make_decoder_of(const DeviceIdentity& device, const TabletTable* own) {
  hid::ReportDescriptor descriptor;
  std::optional<base::Error> descriptor_error;
  if (!device.report_descriptor.empty()) {
    auto parsed = hid::parse_report_descriptor(device.report_descriptor, hid::Strictness::tolerant);
    if (parsed) {
      descriptor = std::move(parsed).value();
    } else {
      descriptor_error = parsed.error();
    }
  }
  if (hid::has_event_mark(device.report_descriptor)) {
    auto pens = find_pens(descriptor, Dialect::standard);
    if (!pens) return unreadable(device, descriptor_error);
    return Recognition{std::make_unique<DescriptorDecoder>(std::move(*pens)), "event device", false};
  }
  DeviceIdentity completed = device;
  complete_identity(completed);

  if (own != nullptr && !own->is_choice()) {
    if (const auto match = own->find(completed)) {
      return Recognition{make_tablet_decoder(*match), "protocol " + match->identifier->protocol->name, match->is_pad};
    }
  }

  if (is_wacom_receiver(completed)) {
    return base::Error{"the wireless receiver has not said which tablet it hears", device.name,
                       "record its first interface as well, and begin before the pen does"};
  }
  if (const WacomModel* known = find_wacom_model(device.bus, device.vendor, device.product)) {
    if (!carries_wacom_pen(*known, descriptor)) return unreadable(device, descriptor_error);
    WacomModel model = *known;
    adopt_described_ranges(model, descriptor);
    return Recognition{make_wacom_decoder(model), "wacom " + std::string(model.name), false};
  }

  const bool wacom = device.vendor == k_vendor_wacom;
  auto pens = find_pens(descriptor, wacom ? Dialect::wacom : Dialect::standard);
  // Wacom's own descriptors are complete; the table is for those that have none.
  const auto match = wacom && pens ? std::nullopt : find_tablet(completed, own);
  if (match && match->identifier->replaces_descriptor) pens.reset();
  std::unique_ptr<PenDecoder> described;
  if (pens) {
    const Tablet* const named = match ? match->tablet : known_tablets().only_one(device);
    correct_size(pens->axes, named != nullptr ? named->width_mm : 0, named != nullptr ? named->height_mm : 0);
    if (wacom) {
      described = std::make_unique<WacomGenericDecoder>(*pens);
    } else {
      described = std::make_unique<DescriptorDecoder>(*pens);
    }
  }
  const auto told = match ? std::nullopt : told_ranges(device, descriptor);
  if (!match && !told) {
    if (!described) return unreadable(device, descriptor_error);
    return Recognition{std::move(described), "descriptor", false};
  }
  const auto& protocol = match ? match->identifier->protocol : known_protocols().at(k_ranges_protocol);
  auto vendor = match ? make_tablet_decoder(*match) : std::make_unique<LayoutDecoder>(protocol, *told);
  const bool is_pad = match && match->is_pad && !described;
  const std::string prefix = described ? "descriptor, " : "";
  return Recognition{
      std::make_unique<FallbackDecoder>(descriptor, std::move(pens), std::move(described), std::move(vendor)),
      prefix + "protocol " + protocol->name, is_pad, match ? guess_of(*match, device) : std::string()};
}

}  // namespace

void complete_identity(DeviceIdentity& device) {
  if (device.report_descriptor.empty()) return;
  const auto parsed = hid::parse_report_descriptor(device.report_descriptor, hid::Strictness::tolerant);
  if (!parsed) return;
  const auto fill = [&](std::optional<std::uint16_t>& length, hid::ReportType type) {
    if (!length) length = static_cast<std::uint16_t>(std::min(parsed->longest_report(type), 65535u));
  };
  fill(device.input_report_length, hid::ReportType::input);
  fill(device.output_report_length, hid::ReportType::output);
  fill(device.feature_report_length, hid::ReportType::feature);
}

base::Result<Recognition> make_decoder(const DeviceIdentity& device, const TabletTable* own) {
  return make_decoder_of(identified(device, own), own);
}

}  // namespace penpose::decode
