#include "firmware_io/decode/table/tablet_reader.h"

#include <algorithm>

#include "core/base/numbers.h"
#include "firmware_io/decode/layout/protocol.h"
#include "firmware_io/decode/table/device_strings.h"
#include "firmware_io/decode/table/open_tablet_driver.h"

namespace penpose::decode {
namespace {

constexpr std::int64_t k_longest_report = 65535;
constexpr std::int64_t k_largest_value = 0x7fffffff;

template <typename Number>
void read_optional(const JsonPlace& place, std::int64_t most, std::optional<Number>& into) {
  if (place.present()) into = static_cast<Number>(place.integer(0, most));
}
template <typename Number>
void read_if_present(const JsonPlace& place, std::int64_t most, Number& into) {
  if (place.present()) into = static_cast<Number>(place.integer(0, most));
}

std::vector<std::uint8_t> read_hex(const JsonPlace& place) {
  const auto text = place.text(8192);
  std::vector<std::uint8_t> bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    const auto byte = base::parse_uint(std::string_view(text).substr(i, 2), 16);
    if (!byte) break;
    bytes.push_back(static_cast<std::uint8_t>(*byte));
  }
  if (bytes.empty() || bytes.size() * 2 != text.size())
    place.fail("is no report", "write its bytes as hexadecimal digits");
  return bytes;
}

/// `256c:006e`
void read_id(const JsonPlace& place, TabletIdentifier& into) {
  const auto text = place.text();
  const auto colon = text.find(':');
  const auto view = std::string_view(text);
  const auto vendor = base::parse_uint(view.substr(0, colon), 16);
  const auto product = colon == std::string::npos ? std::nullopt : base::parse_uint(view.substr(colon + 1), 16);
  if (!vendor || !product || *vendor > 0xffff || *product > 0xffff) {
    place.fail("is no device id", "write vendor and product as in 256c:006e");
    return;
  }
  into.vendor = static_cast<std::uint16_t>(*vendor);
  into.product = static_cast<std::uint16_t>(*product);
}

TabletIdentifier read_identifier(const JsonPlace& place, const ProtocolMap& own) {
  place.allow_only({"id", "input", "output", "feature", "interface", "strings", "read_strings", "send_features",
                    "send_outputs", "protocol", "replaces_descriptor"});
  TabletIdentifier identifier;
  read_id(place.at("id"), identifier);
  read_optional(place.at("input"), k_longest_report, identifier.input_report_length);
  read_optional(place.at("output"), k_longest_report, identifier.output_report_length);
  read_optional(place.at("feature"), k_longest_report, identifier.feature_report_length);
  read_optional(place.at("interface"), 255, identifier.interface_number);
  identifier.strings = read_device_strings(place.at("strings"));
  for (const auto& item : place.at("read_strings").items()) {
    identifier.read_strings.push_back(static_cast<std::uint8_t>(item.integer(0, 255)));
  }
  for (const auto& item : place.at("send_features").items()) identifier.send_features.push_back(read_hex(item));
  for (const auto& item : place.at("send_outputs").items()) identifier.send_outputs.push_back(read_hex(item));
  if (const auto replaces = place.at("replaces_descriptor"); replaces.present()) {
    identifier.replaces_descriptor = replaces.boolean();
  }
  const auto protocol = place.at("protocol");
  const auto name = protocol.text();
  const auto mine = own.find(name);
  const auto known = known_protocols().find(name);
  if (mine != own.end()) {
    identifier.protocol = mine->second;
  } else if (known != known_protocols().end()) {
    identifier.protocol = known->second;
  } else {
    protocol.fail("names no protocol", "define it under protocols, or use one that `penpose devices --known` shows");
  }
  return identifier;
}

TabletWheel read_wheel(const JsonPlace& place) {
  place.allow_only({"kind", "steps", "zero_degrees", "buttons"});
  TabletWheel wheel;
  const auto kind = place.at("kind").text();
  if (kind != "ring" && kind != "dial") place.at("kind").fail("is no kind of wheel", "write ring or dial");
  wheel.is_ring = kind == "ring";
  if (const auto steps = place.at("steps"); steps.present()) wheel.steps = steps.number(0, 1e6);
  if (const auto zero = place.at("zero_degrees"); zero.present()) wheel.zero_degrees = zero.number(-360, 360);
  read_if_present(place.at("buttons"), 32, wheel.buttons);
  return wheel;
}

TabletTouch read_touch(const JsonPlace& place) {
  place.allow_only({"size_mm", "max", "contacts"});
  TabletTouch touch;
  if (const auto size = place.at("size_mm").items(); size.size() == 2) {
    touch.width_mm = size[0].number(0, 10000);
    touch.height_mm = size[1].number(0, 10000);
  } else if (place.at("size_mm").present()) {
    place.at("size_mm").fail("is no pair of numbers", "write [x, y]");
  }
  if (const auto max = place.at("max").items(); max.size() == 2) {
    touch.max_x = static_cast<std::int32_t>(max[0].integer(0, k_largest_value));
    touch.max_y = static_cast<std::int32_t>(max[1].integer(0, k_largest_value));
  } else {
    place.at("max").fail("is no pair of numbers", "write [x, y]");
  }
  read_if_present(place.at("contacts"), 64, touch.contacts);
  return touch;
}

Tablet read_tablet(const JsonPlace& place, const ProtocolMap& own) {
  place.allow_only({"vendor", "name", "size_mm", "max", "max_pressure", "pen_buttons", "pad_keys", "mouse_buttons",
                    "wheels", "strips", "touch", "hide_from_desktop", "feature_delay_ms", "identifiers", "pads"});
  Tablet tablet;
  tablet.vendor = place.at("vendor").text();
  tablet.name = place.at("name").text();
  const auto pair = [&](const char* name) {
    auto items = place.at(name).items();
    if (items.size() == 2) return items;
    place.at(name).fail("is no pair of numbers", "write [x, y]");
    return std::vector<JsonPlace>{};
  };
  if (const auto size = pair("size_mm"); !size.empty()) {
    tablet.width_mm = size[0].number(0, 10000);
    tablet.height_mm = size[1].number(0, 10000);
  }
  if (const auto max = pair("max"); !max.empty()) {
    tablet.max_x = static_cast<std::int32_t>(max[0].integer(0, k_largest_value));
    tablet.max_y = static_cast<std::int32_t>(max[1].integer(0, k_largest_value));
  }
  tablet.max_pressure = static_cast<std::int32_t>(place.at("max_pressure").integer(0, k_largest_value));
  read_if_present(place.at("pen_buttons"), 32, tablet.pen_buttons);
  read_if_present(place.at("pad_keys"), 64, tablet.pad_keys);
  read_if_present(place.at("mouse_buttons"), 32, tablet.mouse_buttons);
  for (const auto& item : place.at("wheels").items()) tablet.wheels.push_back(read_wheel(item));
  read_if_present(place.at("strips"), 2, tablet.strips);
  if (const auto touch = place.at("touch"); touch.present()) tablet.touch = read_touch(touch);
  if (const auto hide = place.at("hide_from_desktop"); hide.present()) tablet.hide_from_desktop = hide.boolean();
  read_if_present(place.at("feature_delay_ms"), 60000, tablet.feature_delay_ms);
  for (const auto& item : place.at("identifiers").items()) tablet.identifiers.push_back(read_identifier(item, own));
  for (const auto& item : place.at("pads").items()) tablet.pads.push_back(read_identifier(item, own));
  if (tablet.identifiers.empty() && tablet.pads.empty()) {
    place.fail("has no identifiers", "say in `identifiers` how the tablet is recognised");
  }
  return tablet;
}

TabletTable read_own_form(const JsonPlace& file) {
  file.allow_only({"penpose_tablets", "origin", "layouts", "rule_lists", "protocols", "tablets"});
  if (file.at("penpose_tablets").integer(1, 1'000'000) != 1) {
    file.at("penpose_tablets").fail("is a version that is not known", "write 1, or use a newer penpose");
  }
  const auto protocols = read_protocols(file);
  std::vector<Tablet> tablets;
  for (const auto& item : file.at("tablets").items()) tablets.push_back(read_tablet(item, protocols));
  return TabletTable(std::move(tablets));
}

}  // namespace

base::Result<TabletTable> read_tablet_file(std::string_view text) {
  const auto tree = parse_json(text);
  if (!tree) return tree.error();
  base::Error error;
  const JsonPlace file(*tree, error);
  TabletTable table;
  if (file.at("penpose_tablets").present()) {
    table = read_own_form(file);
  } else if (file.at("DigitizerIdentifiers").present()) {
    table = TabletTable({read_open_tablet_driver(file)});
  } else {
    file.fail("is neither a tablet file of penpose nor a configuration of OpenTabletDriver",
              "begin it with \"penpose_tablets\": 1");
  }
  if (!error.what.empty()) return error;
  return table;
}

}  // namespace penpose::decode
