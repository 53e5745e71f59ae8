#include "firmware_io/device/list/interface_list.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <sys/stat.h>
#include <tuple>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/device/list/sys_device.h"

namespace penpose::device {
namespace {

constexpr std::size_t k_longest_descriptor = 4096;  // HID_MAX_DESCRIPTOR_SIZE of Linux
constexpr std::string_view k_hid_class = "03";
constexpr const char* k_hidraw_devices = "/sys/class/hidraw";
constexpr const char* k_hid_devices = "/sys/bus/hid/devices";
constexpr const char* k_usb_devices = "/sys/bus/usb/devices";

std::optional<unsigned> hex(std::string_view digits) {
  const std::string copy(digits);
  char* end = nullptr;
  const unsigned long value = std::strtoul(copy.c_str(), &end, 16);
  if (copy.empty() || end != copy.c_str() + copy.size() || value > 0xffffffffUL) return std::nullopt;
  return static_cast<unsigned>(value);
}

std::vector<std::uint8_t> read_descriptor(const std::string& path) {
  std::vector<std::uint8_t> bytes(k_longest_descriptor);
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  bytes.resize(file ? std::fread(bytes.data(), 1, bytes.size(), file.get()) : 0);
  return bytes;
}

/// "0003:0000056A:000000B8" of a hid device.
void take_ids(decode::DeviceIdentity& identity, std::string_view id) {
  const std::size_t first = id.find(':');
  const std::size_t second = first == std::string_view::npos ? first : id.find(':', first + 1);
  if (second == std::string_view::npos) return;
  const auto bus = hex(id.substr(0, first));
  const auto vendor = hex(id.substr(first + 1, second - first - 1));
  const auto product = hex(id.substr(second + 1));
  if (!bus || !vendor || !product) return;
  identity.bus = static_cast<std::uint16_t>(*bus);
  identity.vendor = static_cast<std::uint16_t>(*vendor);
  identity.product = static_cast<std::uint16_t>(*product);
}

/// What a USB interface and its device say.
void take_usb(HidInterface& found, const SysDevice& interface) {
  found.usb_name = interface.name();
  if (const auto number = hex(interface.attribute("bInterfaceNumber"))) {
    found.identity.interface_number = static_cast<int>(*number);
  }
  const auto device = interface.parent_in("usb", "usb_device");
  if (!device) return;
  found.usb_node = device->node();
  found.parent = device->path();
  if (!found.identity.name.empty()) return;
  found.identity.bus = decode::k_bus_usb;
  const auto vendor = hex(device->attribute("idVendor"));
  const auto product = hex(device->attribute("idProduct"));
  found.identity.vendor = static_cast<std::uint16_t>(vendor.value_or(0));
  found.identity.product = static_cast<std::uint16_t>(product.value_or(0));
  const std::string maker = device->attribute("manufacturer");
  const std::string name = device->attribute("product");
  found.identity.name = maker.empty() || name.empty() ? maker + name : maker + " " + name;
}

std::optional<HidInterface> from_hid(const SysDevice& hid) {
  if (hid.property("HID_ID").empty()) return std::nullopt;
  HidInterface found;
  found.driver = hid.driver();
  found.hid_name = hid.name();
  found.physical = hid.property("HID_PHYS");
  found.identity.name = hid.property("HID_NAME");
  take_ids(found.identity, hid.property("HID_ID"));
  found.parent = hid.path();
  found.identity.report_descriptor = read_descriptor(found.parent + "/report_descriptor");
  const auto interface = hid.parent_in("usb", "usb_interface");
  if (interface) take_usb(found, *interface);
  return found;
}

std::optional<HidInterface> from_hidraw(const SysDevice& device) {
  const auto hid = device.parent_in("hid");
  if (!hid || device.node().empty()) return std::nullopt;
  auto found = from_hid(*hid);
  if (!found) return found;
  found->hidraw_node = device.node();
  // The kernel numbers its entries as they come.
  struct stat entry {};
  if (::stat(device.path().c_str(), &entry) == 0) found->node_made = entry.st_ino;
  return found;
}

std::optional<HidInterface> from_usb(const SysDevice& device) {
  if (device.property("DEVTYPE") != "usb_interface") return std::nullopt;
  if (device.attribute("bInterfaceClass") != k_hid_class) return std::nullopt;
  HidInterface found;
  take_usb(found, device);
  found.driver = device.driver();
  // Without the interface, as the kernel names the places of those that it has.
  found.physical = std::filesystem::path(found.parent).filename().string();
  if (found.usb_node.empty()) return std::nullopt;
  return found;
}

/// Of the devices of a class or a bus, whose names stand in a folder, those that are wanted.
template <typename Want, typename Make>
void scan(const std::string& folder, const Want& want, const Make& make, std::vector<HidInterface>& list) {
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!want(name)) continue;
    // A device that has gone since then gives none.
    const auto device = SysDevice::at(folder + "/" + name);
    if (!device) continue;
    if (auto found = make(*device)) list.push_back(std::move(*found));
  }
}

std::string unit_of(const HidInterface& found) {
  // A path that ends so is of USB or stands for it; over Bluetooth it is the adapter's.
  if (!found.usb_name.empty()) return std::filesystem::path(found.parent).filename().string();
  if (found.physical.find("/input") != std::string::npos) return decode::unit_of_path(found.physical);
  return found.hid_name;
}

bool is_hid_class(const std::string& usb_name) {
  return read_sys_line(std::string(k_usb_devices) + "/" + usb_name + "/bInterfaceClass") == k_hid_class;
}

}  // namespace

std::vector<HidInterface> list_interfaces() {
  std::vector<HidInterface> list;
  scan(
      k_hidraw_devices, [](const std::string&) { return true; }, from_hidraw, list);
  // Then those whose driver refused them, so that no node was made, and those that no driver holds. Without a node only
  // USB can reach them.
  std::set<std::string> known;
  std::set<std::string> known_hid;
  for (const HidInterface& found : list) {
    known.insert(found.usb_name);
    known_hid.insert(found.hid_name);
  }
  std::vector<HidInterface> bare;
  scan(
      k_hid_devices, [&](const std::string& name) { return !known_hid.contains(name); }, from_hid, bare);
  for (const HidInterface& found : bare) known_hid.insert(found.usb_name);
  scan(
      k_usb_devices,
      [&](const std::string& name) {
        return name.find(':') != std::string::npos && !known.contains(name) && !known_hid.contains(name) &&
               is_hid_class(name);
      },
      from_usb, bare);
  for (HidInterface& found : bare) {
    if (!found.usb_name.empty() && known.insert(found.usb_name).second) list.push_back(std::move(found));
  }
  for (HidInterface& found : list) {
    decode::complete_identity(found.identity);
    found.identity.unit = unit_of(found);
  }
  std::sort(list.begin(), list.end(), [](const HidInterface& a, const HidInterface& b) {
    return std::tie(a.parent, a.identity.interface_number, a.hidraw_node) <
           std::tie(b.parent, b.identity.interface_number, b.hidraw_node);
  });
  return list;
}

}  // namespace penpose::device
