#include "firmware_io/decode/table/open_tablet_driver.h"

#include <algorithm>
#include <array>

#include "core/base/numbers.h"
#include "firmware_io/decode/layout/protocol.h"
#include "firmware_io/decode/table/device_strings.h"
#include "firmware_io/decode/table/json_place.h"

namespace penpose::decode {
namespace {

struct ParserName {
  std::string_view parser;
  std::string_view protocol;
};

// Class names as they stand in configurations, without their namespaces.
constexpr std::array k_parsers = std::to_array<ParserName>({
    {"AcepenReportParser", "acepen"},
    {"AuxReportParser", "generic_keypad"},
    {"BambooPadReportParser", "wacom_bamboo_pad"},
    {"BambooReportParser", "wacom_bamboo"},
    {"BambooV2AuxReportParser", "wacom_bamboo_v2_keypad"},
    {"CintiqV1ReportParser", "wacom_cintiq_v1"},
    {"FmaReportParser", "floogoo_fma"},
    {"GeniusReportParser", "genius"},
    {"GeniusReportParserV2", "genius_v2"},
    {"GianoReportParser", "huion_giano"},
    {"GraphireReportParser", "wacom_graphire"},
    {"HuionTiltReportParser", "huion_ring"},
    {"HuionWheelReportParser", "huion_ring"},
    {"InspiroyReportParser", "huion_inspiroy"},
    {"Intuos1ReportParser", "wacom_intuos_v1"},
    {"Intuos3ExtraAuxReportParser", "wacom_intuos3_extra"},
    {"Intuos3ReportParser", "wacom_intuos3"},
    {"Intuos4ReportParser", "wacom_intuos4"},
    {"IntuosProReportParser", "wacom_intuos_pro"},
    {"IntuosReportParser", "wacom_intuos"},
    {"IntuosV1ReportParser", "wacom_intuos_v1"},
    {"IntuosV2ReportParser", "wacom_intuos_v2"},
    {"IntuosV3ReportParser", "wacom_intuos_v3"},
    {"KamvasOffsetReportParser", "huion_kamvas"},
    {"LifetecReportParser", "lifetec"},
    {"PLReportParser", "wacom_pl"},
    {"PTUReportParser", "wacom_ptu"},
    {"PassthroughReportParser", "unread"},
    {"RobotPenReportParser", "robotpen"},
    {"SkipByteTabletReportParser", "generic_skip1"},
    {"TabletReportParser", "generic"},
    {"TenMoonReportParser", "ten_moons"},
    {"TiltTabletReportParser", "generic_tilt"},
    {"UCLogicReportParser", "uclogic"},
    {"UCLogicTiltReportParser", "uclogic_tilt"},
    {"UCLogicV1ReportParser", "uclogic_v1"},
    {"UCLogicV2ReportParser", "uclogic_v2"},
    {"VeikkA15ReportParser", "veikk_a15"},
    {"VeikkReportParser", "veikk"},
    {"VeikkTiltReportParser", "veikk_tilt"},
    {"VeikkV1ReportParser", "veikk_v1"},
    {"Wacom64bAuxReportParser", "wacom_touch64"},
    {"WacomDriverIntuos1ReportParser", "wacom_intuos_v1_skip1"},
    {"WacomDriverIntuos3ReportParser", "wacom_intuos3_skip1"},
    {"WacomDriverIntuos4ReportParser", "wacom_intuos4_skip1"},
    {"WacomDriverIntuosProReportParser", "wacom_intuos_pro_skip1"},
    {"WacomDriverIntuosReportParser", "wacom_intuos_skip1"},
    {"WacomDriverIntuosV1ReportParser", "wacom_intuos_v1_skip1"},
    {"WacomDriverIntuosV2ReportParser", "wacom_intuos_v2_skip1"},
    {"WacomDriverIntuosV3ReportParser", "wacom_intuos_v3_skip1"},
    {"WoodPadReportParser", "viewsonic_woodpad"},
    {"XENXReportParser", "xenx"},
    {"XP_PenDedicatedAuxReportParser", "xp_pen_keypad"},
    {"XP_PenGen2ReportParser", "xp_pen_gen2"},
    {"XP_PenOffsetAuxReportParser", "xp_pen_offset_aux"},
    {"XP_PenOffsetPressureReportParser", "xp_pen_offset_pressure"},
    {"XP_PenReportParser", "xp_pen"},
    {"XenceLabsReportParser", "xencelabs"},
});

std::optional<std::uint32_t> base64_digit(char letter) {
  if (letter >= 'A' && letter <= 'Z') return letter - 'A';
  if (letter >= 'a' && letter <= 'z') return letter - 'a' + 26;
  if (letter >= '0' && letter <= '9') return letter - '0' + 52;
  if (letter == '+') return 62;
  if (letter == '/') return 63;
  return std::nullopt;
}

std::vector<std::uint8_t> read_base64(const JsonPlace& place) {
  const auto text = place.text(8192);
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int count = 0;
  const auto end = std::find(text.begin(), text.end(), '=');
  for (auto letter = text.begin(); letter != end; ++letter) {
    const auto digit = base64_digit(*letter);
    if (!digit) {
      place.fail("is no Base64", "copy the configuration anew");
      return {};
    }
    bits = (bits << 6 | *digit) & 0xffffff;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> count));
  }
  return bytes;
}

/// Configurations have a list of reports; early ones a single report.
std::vector<std::vector<std::uint8_t>> read_reports(const JsonPlace& place) {
  std::vector<std::vector<std::uint8_t>> reports;
  if (place.is_text()) {
    reports.push_back(read_base64(place));
  } else {
    for (const auto& item : place.items()) reports.push_back(read_base64(item));
  }
  std::erase_if(reports, [](const auto& report) { return report.empty(); });
  return reports;
}

void read_length(const JsonPlace& place, std::optional<std::uint16_t>& into) {
  if (place.present()) into = static_cast<std::uint16_t>(place.integer(0, 65535));
}

std::optional<int> read_attribute(const JsonPlace& owner, std::string_view name, int most) {
  const auto place = owner.at("Attributes").at(name);
  if (!place.present()) return std::nullopt;
  const auto value = base::parse_uint(place.text());
  if (value && *value <= static_cast<std::uint64_t>(most)) return static_cast<int>(*value);
  place.fail("is no number that fits", "write 0 to " + std::to_string(most) + " in quotes");
  return std::nullopt;
}

/// Index of a USB string; releases of 0.5 wrote it in quotes.
std::uint8_t read_string_index(const JsonPlace& place) {
  if (!place.is_text()) return static_cast<std::uint8_t>(place.integer(0, 255));
  const auto value = base::parse_uint(place.text());
  if (value && *value <= 255) return static_cast<std::uint8_t>(*value);
  place.fail("is no index of a USB string", "write a number from 0 to 255");
  return 0;
}

/// Adds an identifier to a list, or its report parser to those that are not known.
void read_identifier(const JsonPlace& place, const JsonPlace& file, std::vector<TabletIdentifier>& into,
                     std::vector<std::string>& unread_parsers) {
  TabletIdentifier identifier;
  identifier.vendor = static_cast<std::uint16_t>(place.at("VendorID").integer(0, 65535));
  identifier.product = static_cast<std::uint16_t>(place.at("ProductID").integer(0, 65535));
  read_length(place.at("InputReportLength"), identifier.input_report_length);
  read_length(place.at("OutputReportLength"), identifier.output_report_length);
  identifier.interface_number = read_attribute(place, "Interface", 255);
  if (!identifier.interface_number) identifier.interface_number = read_attribute(file, "Interface", 255);
  identifier.strings = read_device_strings(place.at("DeviceStrings"));
  for (const auto& item : place.at("InitializationStrings").items()) {
    identifier.read_strings.push_back(read_string_index(item));
  }
  identifier.send_features = read_reports(place.at("FeatureInitReport"));
  identifier.send_outputs = read_reports(place.at("OutputInitReport"));
  const auto parser = place.at("ReportParser");
  const auto name = parser.present() ? protocol_of_parser(parser.text()) : std::string_view("generic");
  const auto protocol = known_protocols().find(name);
  if (protocol == known_protocols().end()) {
    const std::string unread = parser.text();
    if (std::find(unread_parsers.begin(), unread_parsers.end(), unread) == unread_parsers.end()) {
      unread_parsers.push_back(unread);
    }
    return;
  }
  identifier.protocol = protocol->second;
  into.push_back(std::move(identifier));
}

int read_count(const JsonPlace& place, int most) {
  const auto nested = place.at("Buttons").at("ButtonCount");
  const auto count = nested.present() ? nested : place.at("ButtonCount");
  return count.present() ? static_cast<int>(count.integer(0, most)) : 0;
}

/// Releases differ in how they tell rings from dials: by `IsRelative`, or by which of two step counts there is.
TabletWheel read_driver_wheel(const JsonPlace& place) {
  TabletWheel wheel;
  const auto relative = place.at("IsRelative");
  wheel.is_ring = relative.present() ? !relative.boolean() : place.at("AbsoluteWheelMax").present();
  for (const auto* const name : {"StepCount", "RelativeWheelSteps", "AbsoluteWheelMax"}) {
    if (const auto steps = place.at(name); steps.present()) wheel.steps = steps.number(0, 1e6);
  }
  if (const auto zero = place.at("AngleOfZeroReading"); zero.present()) wheel.zero_degrees = zero.number(-360, 360);
  wheel.buttons = read_count(place, 32);
  return wheel;
}

void read_ranges(const JsonPlace& area, const JsonPlace& pen, Tablet& tablet) {
  tablet.width_mm = area.at("Width").number(0, 10000);
  tablet.height_mm = area.at("Height").number(0, 10000);
  tablet.max_x = static_cast<std::int32_t>(area.at("MaxX").number(0, 0x7fffffff));
  tablet.max_y = static_cast<std::int32_t>(area.at("MaxY").number(0, 0x7fffffff));
  tablet.max_pressure = static_cast<std::int32_t>(pen.at("MaxPressure").number(0, 0x7fffffff));
}

TabletTouch read_driver_touch(const JsonPlace& place) {
  TabletTouch touch;
  if (const auto width = place.at("Width"); width.present()) touch.width_mm = width.number(0, 10000);
  if (const auto height = place.at("Height"); height.present()) touch.height_mm = height.number(0, 10000);
  touch.max_x = static_cast<std::int32_t>(place.at("MaxX").number(0, 0x7fffffff));
  touch.max_y = static_cast<std::int32_t>(place.at("MaxY").number(0, 0x7fffffff));
  return touch;
}

void read_specifications(const JsonPlace& specifications, Tablet& tablet) {
  const auto pen = specifications.at("Pen");
  read_ranges(specifications.at("Digitizer"), pen, tablet);
  tablet.pen_buttons = read_count(pen, 32);
  tablet.pad_keys = read_count(specifications.at("AuxiliaryButtons"), 64);
  tablet.mouse_buttons = read_count(specifications.at("MouseButtons"), 32);
  if (const auto wheel = specifications.at("Wheel"); wheel.present()) tablet.wheels.push_back(read_driver_wheel(wheel));
  if (const auto touch = specifications.at("Touch"); touch.present()) tablet.touch = read_driver_touch(touch);
  for (const auto& wheel : specifications.at("Wheels").items()) tablet.wheels.push_back(read_driver_wheel(wheel));
}

}  // namespace

std::string_view protocol_of_parser(std::string_view class_name) {
  const auto dot = class_name.rfind('.');
  const auto last = dot == std::string_view::npos ? class_name : class_name.substr(dot + 1);
  const auto* const found =
      std::find_if(k_parsers.begin(), k_parsers.end(), [&](const ParserName& one) { return one.parser == last; });
  return found == k_parsers.end() ? std::string_view{} : found->protocol;
}

Tablet read_open_tablet_driver(const JsonPlace& file) {
  Tablet tablet;
  const auto name = file.at("Name").text();
  const auto blank = name.find(' ');
  tablet.vendor = name.substr(0, blank);
  tablet.name = blank == std::string::npos ? name : name.substr(blank + 1);
  const auto specifications = file.at("Specifications");
  const auto identifiers = file.at("DigitizerIdentifiers").items();
  // Before version 0.6 each identifier stated the ranges.
  if (!specifications.present() && !identifiers.empty() && identifiers.front().at("Width").present()) {
    read_ranges(identifiers.front(), identifiers.front(), tablet);
  } else {
    read_specifications(specifications, tablet);
  }
  tablet.hide_from_desktop = read_attribute(file, "libinputoverride", 1).value_or(0) == 1;
  tablet.feature_delay_ms = read_attribute(file, "FeatureInitDelayMs", 60000).value_or(0);
  for (const auto& item : identifiers) read_identifier(item, file, tablet.identifiers, tablet.unread_parsers);
  if (identifiers.empty()) file.at("DigitizerIdentifiers").fail("lists no identifier", "add one");
  // Some releases spell the member with a letter missing.
  for (const auto* const spelling : {"AuxiliaryDeviceIdentifiers", "AuxilaryDeviceIdentifiers"}) {
    for (const auto& item : file.at(spelling).items()) {
      read_identifier(item, file, tablet.pads, tablet.unread_parsers);
    }
  }
  return tablet;
}

}  // namespace penpose::decode
