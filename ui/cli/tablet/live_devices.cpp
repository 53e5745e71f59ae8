#include "ui/cli/tablet/live_devices.h"

#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "core/base/json/json.h"
#include "core/base/text/shown_text.h"
#include "firmware_io/device/list/interface_list.h"
#include "firmware_io/device/list/permission.h"
#include "firmware_io/device/live_tablet.h"
#include "firmware_io/device/source/driver_guard.h"
#include "ui/cli/commands.h"
#include "ui/files/files.h"
#include "ui/files/own_tablets.h"
#include "ui/files/process/own_program.h"
#include "ui/render/renderer.h"

namespace penpose::cli {
namespace {

using json::Json;

constexpr std::size_t k_longest_live_line = 4096;

std::string hex(std::uint16_t id) {
  char text[5] = {};
  std::snprintf(text, sizeof text, "%04x", id);
  return text;
}

const char* word(device::Carries carries) {
  if (carries == device::Carries::receiver) return "receiver";
  return carries == device::Carries::pad ? "pad" : carries == device::Carries::touch ? "touch" : "pen";
}

/// What else is on the interface: ", keys", ", fingers".
std::string beside(const device::LiveTablet& tablet) {
  std::string text;
  if (tablet.has_keys && tablet.carries != device::Carries::pad) text += ", keys";
  if (tablet.has_touch && tablet.carries != device::Carries::touch) text += ", fingers";
  return text;
}

const char* word(device::Transport transport) {
  if (transport == device::Transport::event) return "event device";
  return transport == device::Transport::libusb ? "libusb" : "hidraw";
}

Json or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json to_json(const device::LiveTablet& tablet) {
  const auto& interface = tablet.interface;
  const auto& identity = interface.identity;
  Json out{{"path", tablet.path()},
           {"name", identity.name},
           {"vendor", identity.vendor},
           {"product", identity.product},
           {"bus", identity.bus},
           {"interface", identity.interface_number ? Json(*identity.interface_number) : Json()},
           {"carries", word(tablet.carries)},
           {"keys", tablet.has_keys},
           {"touch", tablet.has_touch},
           {"method", tablet.method},
           {"tablet", nullptr},
           {"certain", tablet.match && tablet.match->certain},
           {"guess", or_null(tablet.guess)},
           {"transport", word(tablet.transport)},
           {"transport_reason", tablet.reason},
           {"driver", or_null(interface.driver)},
           {"node", or_null(tablet.node())},
           {"hidraw", or_null(interface.hidraw_node)},
           {"event", or_null(interface.event_node)},
           {"usb", or_null(interface.usb_name)},
           {"device", interface.parent},
           {"can_open", tablet.access == device::Access::allowed},
           {"missing", or_null(device::missing(tablet, files::own_program()))}};
  if (tablet.match) out["tablet"] = tablet.match->tablet->vendor + " " + tablet.match->tablet->name;
  Json strings = Json::object();
  for (const auto& [index, text] : identity.strings) strings[std::to_string(index)] = text;
  out["strings"] = std::move(strings);
  return out;
}

void print(const device::LiveTablet& tablet) {
  const auto& identity = tablet.interface.identity;
  std::cout << tablet.path() << "  " << base::shown_name(identity.name) << " (" << hex(identity.vendor) << ':'
            << hex(identity.product) << "), " << word(tablet.carries) << beside(tablet) << ", read as "
            << tablet.method;
  if (tablet.match && tablet.match->certain) {
    std::cout << " (" << base::shown_name(tablet.match->tablet->vendor + " " + tablet.match->tablet->name) << ')';
  }
  std::cout << (tablet.access == device::Access::allowed ? ", can be opened\n" : ", cannot be opened\n");
  std::cout << "    through " << (tablet.transport == device::Transport::event ? "its " : "") << word(tablet.transport)
            << ": " << tablet.reason << '\n';
  // What is missing comes first: once it is there, the tablet's strings may tell the model.
  std::string note = device::missing(tablet, files::own_program());
  if (note.empty() && !tablet.guess.empty()) note = files::guess_note(tablet.guess);
  if (!note.empty()) std::cout << "    " << base::shown_line(note, k_longest_live_line) << '\n';
}

/// How pictures would be drawn, and how else they can be.
Json to_json(const std::vector<render::WayHere>& ways) {
  Json out = Json::array();
  for (const render::WayHere& one : ways) {
    Json row{{"way", std::string(render::name_of(one.way))}, {"driver", nullptr}, {"missing", nullptr}};
    if (one.driver) row["driver"] = *one.driver;
    if (!one.driver) row["missing"] = one.driver.error().line();
    out.push_back(std::move(row));
  }
  return out;
}

void print(const std::vector<render::WayHere>& ways) {
  std::string first;
  std::string others;
  for (const render::WayHere& one : ways) {
    const std::string name(render::name_of(one.way));
    if (!one.driver) continue;
    if (first.empty()) {
      first = name + " (" + *one.driver + ')';
    } else {
      others += (others.empty() ? "; also there: " : ", ") + name;
    }
  }
  std::cout << "pictures are drawn by " << base::shown_line(first, k_longest_live_line) << others << '\n';
}

std::string rule_with(const decode::TabletTable& own) {
  std::vector<decode::Tablet> all(decode::known_tablets().tablets().begin(), decode::known_tablets().tablets().end());
  all.insert(all.end(), own.tablets().begin(), own.tablets().end());
  return device::udev_rule(decode::TabletTable(std::move(all)), device::list_tablets(&own));
}

}  // namespace

int list_live_devices(const decode::TabletTable& own, bool json) {
  const auto tablets = device::list_tablets(&own);
  if (json) {
    Json list = Json::array();
    for (const auto& tablet : tablets) list.push_back(to_json(tablet));
    const Json out{{"count", tablets.size()}, {"tablets", std::move(list)}, {"draw", to_json(render::ways_here())}};
    std::cout << out.dump_as_made(2) << '\n';
    return k_success;
  }
  for (const auto& tablet : tablets) print(tablet);
  if (tablets.empty()) std::cout << "no tablet is plugged in\n";
  print(render::ways_here());
  return k_success;
}

int print_udev_rule(const decode::TabletTable& own) {
  std::cout << rule_with(own);
  return k_success;
}

int install_udev_rule(const decode::TabletTable& own, const std::string& folder) {
  const auto done = device::install_udev_rule(folder, rule_with(own));
  if (!done) return files::report(done.error());
  std::cout << folder << '/' << device::k_rule_file << " is installed\n";
  return k_success;
}

int give_back_devices() {
  int status = k_success;
  for (const auto& interface : device::list_interfaces()) {
    if (!interface.driver.empty() || interface.usb_node.empty() || !interface.identity.interface_number) continue;
    const auto bound = device::bind_kernel_driver(interface.usb_node, *interface.identity.interface_number);
    if (!bound) {
      status = files::report(bound.error(), interface.usb_name);
    } else {
      std::cout << interface.usb_name << "  " << base::shown_name(interface.identity.name) << " has its driver again\n";
    }
  }
  return status;
}

}  // namespace penpose::cli
