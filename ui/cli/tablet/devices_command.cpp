#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <optional>
#include <set>
#include <span>
#include <string>

#include "core/base/json/json.h"
#include "core/base/numbers.h"
#include "core/base/text/shown_text.h"
#include "firmware_io/decode/hand_factory.h"
#include "firmware_io/decode/table/tablet_table.h"
#include "firmware_io/decode/wacom/hand/wacom_hands.h"
#include "firmware_io/device/list/permission.h"
#include "ui/cli/subcommand.h"
#include "ui/cli/tablet/live_devices.h"
#include "ui/cli/tablet/tablet_options.h"
#include "ui/files/files.h"

namespace penpose::cli {
namespace {

using json::Json;

struct DevicesOptions {
  bool known = false;
  bool json = false;
  bool udev_rule = false;
  bool give_back = false;
  bool install = false;
  std::string rules_folder = device::k_rules_folder;
  files::OwnTablets own;
};

std::string device_id(const decode::TabletIdentifier& identifier) {
  char text[10] = {};
  std::snprintf(text, sizeof text, "%04x:%04x", identifier.vendor, identifier.product);
  return text;
}

Json to_json(const decode::TabletIdentifier& identifier) {
  Json out{{"id", device_id(identifier)}, {"protocol", identifier.protocol->name}};
  if (identifier.input_report_length) out["input"] = *identifier.input_report_length;
  if (identifier.output_report_length) out["output"] = *identifier.output_report_length;
  if (identifier.feature_report_length) out["feature"] = *identifier.feature_report_length;
  if (identifier.interface_number) out["interface"] = *identifier.interface_number;
  for (const auto& check : identifier.strings) out["strings"][std::to_string(check.index)] = check.pattern.text();
  return out;
}

/// What the hand finds on a tablet: what the table says of it, and what reads its reports.
struct Hand {
  std::size_t keys = 0;
  std::size_t rings = 0;
  std::size_t dials = 0;
  std::size_t strips = 0;
  std::optional<decode::TabletTouch> touch;
};

Hand hand_of(const decode::Tablet& tablet) {
  Hand hand;
  hand.keys = static_cast<std::size_t>(std::max(tablet.pad_keys, 0));
  hand.rings = static_cast<std::size_t>(std::count_if(tablet.wheels.begin(), tablet.wheels.end(),
                                                      [](const decode::TabletWheel& wheel) { return wheel.is_ring; }));
  hand.dials = tablet.wheels.size() - hand.rings;
  hand.strips = static_cast<std::size_t>(std::max(tablet.strips, 0));
  hand.touch = tablet.touch;
  for (const auto& identifier : tablet.identifiers) {
    for (const std::uint16_t bus : {decode::k_bus_usb, decode::k_bus_bluetooth}) {
      const decode::WacomHand* known = decode::find_wacom_hand(bus, identifier.vendor, identifier.product);
      if (known == nullptr) continue;
      decode::DeviceIdentity device;
      device.bus = bus;
      device.vendor = identifier.vendor;
      device.product = identifier.product;
      const auto made = decode::make_hand_decoders(device);
      if (made.pad) {
        const decode::PadFeatures& has = made.pad->features();
        if (hand.keys == 0) hand.keys = has.keys.count();
        hand.rings = std::max<std::size_t>(hand.rings, has.rings);
        hand.dials = std::max<std::size_t>(hand.dials, has.wheels);
        hand.strips = std::max<std::size_t>(hand.strips, has.strips);
      }
      // Fingers on some displays are a USB device of their own, which says how large it is.
      if (known->has_partner && known->pad != decode::WacomPad::none && !hand.touch) hand.touch.emplace();
      if (made.touch && !hand.touch) {
        const decode::TouchAxes& axes = made.touch->axes();
        const auto length = [](const decode::Axis& axis) {
          return axis.units_per_mm > 0 ? std::round(axis.maximum / axis.units_per_mm) : 0.0;
        };
        hand.touch = {length(axes.x), length(axes.y), axes.x.maximum, axes.y.maximum, known->contacts};
      }
    }
  }
  return hand;
}

Json to_json(const decode::Tablet& tablet) {
  const Hand hand = hand_of(tablet);
  Json out{{"vendor", tablet.vendor},
           {"name", tablet.name},
           {"size_mm", {tablet.width_mm, tablet.height_mm}},
           {"max", {tablet.max_x, tablet.max_y}},
           {"max_pressure", tablet.max_pressure},
           {"pen_buttons", tablet.pen_buttons},
           {"pad_keys", hand.keys},
           {"mouse_buttons", tablet.mouse_buttons},
           {"wheels", hand.rings + hand.dials},
           {"rings", hand.rings},
           {"strips", hand.strips},
           {"identifiers", Json::array()},
           {"pads", Json::array()}};
  if (hand.touch) {
    out["touch"] = {{"size_mm", {hand.touch->width_mm, hand.touch->height_mm}},
                    {"max", {hand.touch->max_x, hand.touch->max_y}}};
    if (hand.touch->contacts > 0) out["touch"]["contacts"] = hand.touch->contacts;
  }
  for (const auto& identifier : tablet.identifiers) out["identifiers"].push_back(to_json(identifier));
  for (const auto& pad : tablet.pads) out["pads"].push_back(to_json(pad));
  return out;
}

/// `; 8 keys, 1 ring, touch`.
std::string shown(const Hand& hand) {
  std::string list;
  const auto add = [&](std::size_t count, const std::string& what) {
    if (count == 0) return;
    list += (list.empty() ? "; " : ", ") + std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
  };
  add(hand.keys, "key");
  add(hand.rings, "ring");
  add(hand.dials, "dial");
  add(hand.strips, "strip");
  if (hand.touch) list += list.empty() ? "; touch" : ", touch";
  return list;
}

void print(const decode::Tablet& tablet) {
  std::set<std::string> ids;
  std::set<std::string> protocols;
  const bool has_pen = !tablet.identifiers.empty();
  for (const auto& identifier : has_pen ? tablet.identifiers : tablet.pads) {
    ids.insert(device_id(identifier));
    protocols.insert(identifier.protocol->name);
  }
  std::cout << base::shown_name(tablet.vendor + " " + tablet.name) << ':';
  if (has_pen) {
    std::cout << ' ' << base::format_double(tablet.width_mm) << " x " << base::format_double(tablet.height_mm)
              << " mm, pressure 0.." << tablet.max_pressure << ',';
  }
  for (const auto& id : ids) std::cout << ' ' << id;
  std::cout << ',';
  for (const auto& protocol : protocols) std::cout << ' ' << protocol;
  std::cout << shown(hand_of(tablet));
  std::cout << '\n';
}

int list_known(const DevicesOptions& options, const decode::TabletTable& own) {
  Json list = Json::array();
  std::size_t count = 0;
  const auto add = [&](std::span<const decode::Tablet> tablets) {
    for (const auto& tablet : tablets) {
      ++count;
      if (options.json) {
        list.push_back(to_json(tablet));
      } else {
        print(tablet);
      }
    }
  };
  add(own.tablets());
  // One that was named is the whole answer.
  if (!own.is_choice()) add(decode::known_tablets().tablets());
  if (options.json) {
    const Json out{{"count", count}, {"tablets", std::move(list)}};
    std::cout << out.dump_as_made(2) << '\n';
  } else {
    std::cout << count << (count == 1 ? " tablet\n" : " tablets\n");
  }
  return k_success;
}

int run_devices(const DevicesOptions& options) {
  const auto own = files::read_own_tablets(options.own);
  if (!own) return files::report(own.error());
  if (options.known) return list_known(options, *own);
  if (options.udev_rule) return print_udev_rule(*own);
  if (options.install) return install_udev_rule(*own, options.rules_folder);
  if (options.give_back) return give_back_devices();
  return list_live_devices(*own, options.json);
}

void add_devices_options(const Command& command, DevicesOptions& options) {
  const Option known = command.add_flag("--known", options.known, "All tablets of the table, plugged in or not");
  command.add_flag("--json", options.json, "Print one JSON object");
  const Option rule = command.add_flag("--udev-rule", options.udev_rule,
                                       "Print the udev rule that lets whoever sits at the machine open tablets");
  const Option install =
      command.add_flag("--install-udev-rule", options.install, "Install and apply that rule (as root)");
  command.add_option("--rules-folder", options.rules_folder, "Where to install it").needs(install);
  const Option give_back = command.add_flag(
      "--give-back", options.give_back, "Bind the system's drivers to devices that have lost them, as after a crash");
  for (const Option& one : {known, rule, install, give_back}) {
    for (const Option& other : {known, rule, install, give_back}) {
      if (one != other) one.excludes(other);
    }
  }
  add_tablet_options(command, options.own);
}

}  // namespace

Subcommand devices_subcommand() {
  return subcommand<DevicesOptions>(
      "devices", files::Rights::all, "Lists the tablets that are plugged in, or those that can be read.",
      add_devices_options, run_devices,
      {"penpose devices", "the tablets that are plugged in, and what is missing to open them"},
      {"penpose devices --known", "every tablet whose raw reports are understood"},
      {{"--rules-folder", Completes::folders}});
}

}  // namespace penpose::cli
