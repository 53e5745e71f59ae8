#include "firmware_io/device/live_tablet.h"

#include <algorithm>
#include <set>
#include <string>
#include <unistd.h>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/described/described_pad.h"
#include "firmware_io/decode/hand_factory.h"
#include "firmware_io/decode/table/told_ranges.h"
#include "firmware_io/decode/wacom/wacom_models.h"
#include "firmware_io/decode/wacom/wacom_receiver.h"
#include "firmware_io/device/list/event_list.h"
#include "firmware_io/device/list/interface_list.h"
#include "firmware_io/device/source/built_in.h"
#include "firmware_io/device/source/event_source.h"
#include "firmware_io/device/source/hidraw_source.h"
#include "firmware_io/device/source/libusb_source.h"
#include "firmware_io/device/source/usb_strings.h"

namespace penpose::device {
namespace {

/// PenPartner: its reports are a byte shorter than its descriptor says, and Linux keeps such from /dev/hidraw.
constexpr std::uint16_t k_penpartner = 0x0000;

/// Wacom's tablets are mice until this makes them pens. The kernel's driver sends it a second after they are plugged
/// in, and where it has done so already a second time may confuse them.
const std::vector<std::uint8_t> k_wacom_pen_mode{0x02, 0x02};
constexpr std::string_view k_wacom_driver = "wacom";

/// This driver of the kernel wakes its tablets, also after a sleep, and shows a descriptor of its own making that fits
/// the reports as it rewrites them. What it shows is read like any pen that describes itself.
constexpr std::string_view k_waking_driver = "uclogic";
constexpr const char* k_beside_driver = "the kernel's driver goes on beside it";
/// Stands for a program that holds the interface.
constexpr std::string_view k_program = "usbfs";

/// The strings that tell the tablets with these ids apart. Those that wake a tablet up are no part of it.
std::set<std::uint8_t> telling_strings(const decode::TabletTable& table, const decode::DeviceIdentity& device) {
  std::set<std::uint8_t> indices;
  for (const decode::Tablet& tablet : table.tablets()) {
    for (const auto* list : {&tablet.identifiers, &tablet.pads}) {
      for (const decode::TabletIdentifier& identifier : *list) {
        if (identifier.vendor != device.vendor || identifier.product != device.product) continue;
        for (const auto& check : identifier.strings) indices.insert(check.index);
      }
    }
  }
  return indices;
}

base::Result<std::string> read_usb_string(const std::string& usb_node, std::uint8_t index) {
  auto strings = UsbStrings::open(usb_node);
  if (!strings) return strings.error();
  return strings->read(index);
}

bool read_strings(LiveTablet& tablet, const decode::TabletTable* own, const ReadString& read) {
  decode::DeviceIdentity& identity = tablet.interface.identity;
  auto indices = telling_strings(decode::known_tablets(), identity);
  if (own != nullptr) indices.merge(telling_strings(*own, identity));
  const auto read_all = [&] {
    std::erase_if(indices, [&](std::uint8_t index) { return identity.strings.contains(index); });
    if (indices.empty()) return true;
    const std::string& node = tablet.interface.usb_node;
    if (node.empty() || (!read && ::access(node.c_str(), R_OK | W_OK) != 0)) return false;
    for (const std::uint8_t index : indices) {
      // A string that the device does not have is known: it holds nothing.
      const auto text = read ? read(node, index) : read_usb_string(node, index);
      identity.strings[index] = text ? *text : std::string();
    }
    return true;
  };
  if (!read_all()) return false;
  // One that no table has tells its ranges with the string that wakes it.
  const bool is_unknown = identity.vendor == decode::k_vendor_huion && tablet.interface.driver != k_waking_driver &&
                          !tablet.interface.usb_node.empty() && !decode::find_tablet(identity, own);
  if (is_unknown) indices.insert(decode::k_ranges_string);
  return read_all();
}

void identify(LiveTablet& tablet, const decode::TabletTable* own) {
  const decode::DeviceIdentity& identity = tablet.interface.identity;
  if (decode::is_wacom_receiver(identity)) {
    // What comes here is known once it says which tablet it hears; pen and fingers have an interface each.
    constexpr int k_pen_interface = 1;
    const bool monitor = decode::is_receiver_monitor(identity);
    tablet.has_touch = !monitor && identity.interface_number != k_pen_interface;
    tablet.has_keys = !monitor;
    tablet.carries = monitor ? Carries::receiver : tablet.has_touch ? Carries::touch : Carries::pen;
    tablet.method = "the tablet that the receiver hears";
    return;
  }
  const auto recognition = decode::make_decoder(identity, own);
  if (recognition) {
    tablet.carries = recognition->is_pad ? Carries::pad : Carries::pen;
    tablet.method = recognition->method;
    tablet.match = decode::find_tablet(identity, own);
    tablet.guess = recognition->guess;
  }
  const decode::HandDecoders hand = decode::make_hand_decoders(identity, own);
  tablet.has_keys = hand.pad != nullptr && hand.pad->features().any();
  tablet.has_touch = hand.touch != nullptr;
  if (recognition || (!tablet.has_keys && !tablet.has_touch)) return;
  tablet.carries = tablet.has_keys ? Carries::pad : Carries::touch;
  tablet.method = tablet.has_keys ? "keys of the tablet" : "fingers on the tablet";
}

/// What is known of the same interface: between two drivers the system tells neither its name nor its descriptor.
void take_over(decode::DeviceIdentity& identity, const decode::DeviceIdentity& known) {
  identity.strings = known.strings;
  if (identity.name.empty()) identity.name = known.name;
  if (!identity.report_descriptor.empty()) return;
  identity.report_descriptor = known.report_descriptor;
  decode::complete_identity(identity);
}

/// Fingers alone are those of a tablet on the same device, or of one by Wacom, whose fingers may be a device of their
/// own beside it. Others are a touch screen's or a laptop's, which the desktop reads.
bool belongs_to_a_tablet(const LiveTablet& touch, const std::vector<LiveTablet>& all) {
  return std::any_of(all.begin(), all.end(), [&](const LiveTablet& other) {
    if (other.carries != Carries::pen && other.carries != Carries::pad) return false;
    if (!touch.interface.parent.empty() && other.interface.parent == touch.interface.parent) return true;
    return touch.interface.identity.vendor == decode::k_vendor_wacom && other.carries == Carries::pen &&
           other.interface.identity.vendor == decode::k_vendor_wacom;
  });
}

/// Whether the kernel's driver has woken the tablet and made it describe its pen and, behind it, its keys. Its other
/// interfaces keep their descriptors, or are refused.
bool is_woken(const LiveTablet& tablet) {
  const auto& descriptor = tablet.interface.identity.report_descriptor;
  if (tablet.interface.driver != k_waking_driver || tablet.carries != Carries::pen || descriptor.empty()) return false;
  const auto parsed = hid::parse_report_descriptor(descriptor, hid::Strictness::tolerant);
  return parsed && decode::find_described_pad(*parsed);
}

/// An interface of which nothing is known but the tablet's ids, beside one that the kernel's driver has woken: it has
/// no pen, or the driver would not have refused it.
bool was_refused(const LiveTablet& tablet, const std::vector<LiveTablet>& all) {
  const HidInterface& interface = tablet.interface;
  if (!interface.identity.report_descriptor.empty() || interface.parent.empty()) return false;
  return std::any_of(all.begin(), all.end(), [&](const LiveTablet& other) {
    return other.interface.parent == interface.parent && is_woken(other);
  });
}

void choose_transport(LiveTablet& tablet) {
  const HidInterface& interface = tablet.interface;
  const auto choose = [&](Transport transport, const char* reason) {
    tablet.transport = transport;
    tablet.reason = reason;
  };
  if (!interface.event_node.empty()) return choose(Transport::event, "there is no HID interface behind it");
  if (interface.usb_node.empty()) return choose(Transport::hidraw, k_beside_driver);
  if (interface.hidraw_node.empty()) return choose(Transport::libusb, "it has no hidraw node");
  if (interface.identity.vendor == decode::k_vendor_wacom && interface.identity.product == k_penpartner)
    return choose(Transport::libusb, "the kernel keeps its reports from hidraw");
  const WakeUp steps = tablet.wake_up();
  const bool by_usb = reads_through(Transport::libusb) && (!steps.read_strings.empty() || !steps.send_outputs.empty());
  choose(by_usb ? Transport::libusb : Transport::hidraw, by_usb ? "it must be woken over USB" : k_beside_driver);
}

Access check_access(const LiveTablet& tablet) {
  if (tablet.node().empty() || !reads_through(tablet.transport)) return Access::absent;
  if (tablet.transport == Transport::libusb && tablet.interface.driver == k_program) return Access::busy;
  const int rights = tablet.transport == Transport::event ? R_OK : R_OK | W_OK;
  if (::access(tablet.node().c_str(), rights) == 0) return Access::allowed;
  return ::access(tablet.node().c_str(), F_OK) == 0 ? Access::denied : Access::absent;
}

/// Those without an entry in the table of tablets, which says of the others how they wake up.
bool begins_as_wacom_mouse(const LiveTablet& tablet) {
  const decode::DeviceIdentity& identity = tablet.interface.identity;
  if (tablet.match || tablet.carries != Carries::pen || identity.bus != decode::k_bus_usb) return false;
  if (tablet.transport == Transport::hidraw && tablet.interface.driver == k_wacom_driver) return false;
  const auto* const model = decode::find_wacom_model(identity.bus, identity.vendor, identity.product);
  return model != nullptr && model->family != decode::WacomFamily::tablet_pc;
}

}  // namespace

const std::string& LiveTablet::node() const {
  if (transport == Transport::event) return interface.event_node;
  return transport == Transport::libusb ? interface.usb_node : interface.hidraw_node;
}

std::string LiveTablet::path() const { return transport == Transport::libusb ? "usb:" + interface.usb_name : node(); }

WakeUp LiveTablet::wake_up() const {
  if (transport == Transport::event) return {};
  if (interface.driver == k_waking_driver && transport == Transport::hidraw) return {};
  if (!begins_as_wacom_mouse(*this)) return wake_up_of(match);
  WakeUp steps;
  steps.send_features = {k_wacom_pen_mode};
  steps.ask_first = true;
  return steps;
}

void LiveTablet::use(Transport other) {
  if (transport != other) reason = "it was asked for";
  transport = other;
  access = check_access(*this);
}

LiveTablet recognise(HidInterface interface, const decode::TabletTable* own, const ReadString& read_string) {
  LiveTablet tablet;
  tablet.interface = std::move(interface);
  if (tablet.interface.event_node.empty()) tablet.strings_unread = !read_strings(tablet, own, read_string);
  identify(tablet, own);
  choose_transport(tablet);
  tablet.access = check_access(tablet);
  return tablet;
}

std::vector<LiveTablet> with_event_devices(std::vector<LiveTablet> tablets, const std::vector<HidInterface>& all,
                                           std::vector<LiveTablet> events) {
  const auto draws = [](const LiveTablet& tablet) {
    return tablet.carries != Carries::touch && tablet.carries != Carries::other;
  };
  const auto is_open = [&](const LiveTablet& tablet) {
    return draws(tablet) && (tablet.access == Access::allowed || tablet.access == Access::busy);
  };
  std::set<std::string> read, denied, interfaces;
  for (const HidInterface& interface : all) interfaces.insert(interface.parent);
  for (const LiveTablet& tablet : tablets) (is_open(tablet) ? read : denied).insert(tablet.interface.parent);
  std::erase_if(events, [&](const LiveTablet& device) { return read.contains(device.interface.parent); });
  std::set<std::string> instead;
  bool has_pen = !read.empty();
  for (const LiveTablet& device : events) {
    if (!is_open(device)) continue;
    instead.insert(device.interface.parent);
    has_pen = has_pen || (device.carries == Carries::pen && !device.interface.made_by_program);
  }
  std::erase_if(tablets, [&](const LiveTablet& tablet) { return instead.contains(tablet.interface.parent); });
  for (LiveTablet& device : events) {
    const std::string& parent = device.interface.parent;
    if (device.interface.made_by_program && has_pen) continue;
    if (denied.contains(parent) && !instead.contains(parent)) continue;
    if (denied.contains(parent)) {
      device.reason = "its HID interface cannot be opened";
    } else if (interfaces.contains(parent)) {
      device.reason = "only the kernel's driver knows its reports";
    }
    tablets.push_back(std::move(device));
  }
  return tablets;
}

std::vector<LiveTablet> list_tablets(const decode::TabletTable* own, const std::vector<LiveTablet>& before) {
  const std::vector<HidInterface> interfaces = list_interfaces();
  std::vector<LiveTablet> tablets;
  for (HidInterface interface : interfaces) {
    const auto known = std::find_if(before.begin(), before.end(), [&](const LiveTablet& tablet) {
      return !interface.usb_name.empty() && tablet.interface.usb_node == interface.usb_node &&
             tablet.interface.usb_name == interface.usb_name;
    });
    if (known != before.end() && interface.driver == k_program) {
      // A program, this one perhaps, has taken it, and the system tells less of it now than then.
      tablets.push_back(*known);
      tablets.back().access = Access::busy;
      continue;
    }
    if (known != before.end()) take_over(interface.identity, known->interface.identity);
    LiveTablet tablet = recognise(std::move(interface), own);
    if (tablet.carries != Carries::other) tablets.push_back(std::move(tablet));
  }
  const std::vector<LiveTablet> found = tablets;
  std::erase_if(tablets, [&](const LiveTablet& one) { return was_refused(one, found); });
  std::vector<LiveTablet> events;
  for (HidInterface& device : list_event_devices()) {
    LiveTablet tablet = recognise(std::move(device), own);
    if (tablet.carries != Carries::other) events.push_back(std::move(tablet));
  }
  tablets = with_event_devices(std::move(tablets), interfaces, std::move(events));
  const std::vector<LiveTablet> all = tablets;
  std::erase_if(tablets,
                [&](const LiveTablet& one) { return one.carries == Carries::touch && !belongs_to_a_tablet(one, all); });
  return tablets;
}

base::Result<std::unique_ptr<ReportSource>> open_tablet(LiveTablet& tablet, const decode::TabletTable* own) {
  if (tablet.transport == Transport::hidraw) return open_hidraw(tablet.interface);
  if (tablet.transport == Transport::event) {
    auto source = open_event_device(tablet.interface);
    if (source) identify(tablet, own);
    return source;
  }
  const bool described = !tablet.interface.identity.report_descriptor.empty();
  auto source = open_libusb(tablet.interface);
  if (source && !described) identify(tablet, own);
  return source;
}

}  // namespace penpose::device
