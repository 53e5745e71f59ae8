#include "firmware_io/device/list/event_list.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <linux/input-event-codes.h>
#include <optional>
#include <sys/stat.h>
#include <tuple>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/device/list/sys_device.h"

namespace penpose::device {
namespace {

/// In place of ranges that only an open device tells.
constexpr event::AbsRange k_some_range{0, 65535, 0};
constexpr event::AbsRange k_some_slots{0, 9, 0};
/// Parts of a bit map have the size of a `long` of whoever reads it (input_bits_to_string of Linux's input.c).
constexpr std::size_t k_bits_of_part = 8 * sizeof(long);

std::optional<std::uint64_t> from_hex(std::string_view digits) {
  std::uint64_t value = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (digits.empty() || read.ec != std::errc() || read.ptr != digits.data() + digits.size()) return std::nullopt;
  return value;
}

std::uint16_t read_id(const std::string& path) {
  return static_cast<std::uint16_t>(from_hex(read_sys_line(path)).value_or(0));
}

/// The numbers of the bits that are set; the most significant part comes first.
std::vector<std::uint16_t> read_bits(const std::string& path) {
  const std::string line = read_sys_line(path);
  std::vector<std::uint64_t> parts;
  for (std::size_t begin = 0; begin < line.size();) {
    const std::size_t end = std::min(line.find(' ', begin), line.size());
    if (end > begin) parts.push_back(from_hex(std::string_view(line).substr(begin, end - begin)).value_or(0));
    begin = end + 1;
  }
  std::reverse(parts.begin(), parts.end());
  std::vector<std::uint16_t> bits;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    for (std::size_t bit = 0; bit < k_bits_of_part; ++bit) {
      if ((parts[part] >> bit & 1) != 0) bits.push_back(static_cast<std::uint16_t>(part * k_bits_of_part + bit));
    }
  }
  return bits;
}

bool is_of_a_tablet(const event::EventAxes& facts) {
  return event::has_pen(facts) || event::has_pad(facts) || event::has_fingers(facts);
}

/// Where it is plugged in, the same for all nodes of a device and for its HID interfaces (interface_list.cpp).
void take_parents(HidInterface& found, const SysDevice& device) {
  if (const auto hid = device.parent_in("hid")) {
    found.hid_name = hid->name();
    found.driver = hid->driver();
    found.parent = hid->path();
  }
  if (const auto usb = device.parent_in("usb", "usb_device")) found.parent = usb->path();
  if (!found.parent.empty()) return;
  const auto input = device.parent();
  const auto above = input ? input->parent() : std::nullopt;
  if (above) {
    found.driver = above->driver();
    found.parent = above->path();
    return;
  }
  // Made by a program. What it plugs into one place belongs together.
  found.made_by_program = true;
  found.parent = decode::unit_of_path(found.physical);
  if (found.parent.empty() && input) found.parent = input->path();
}

std::optional<HidInterface> look_at(const std::string& folder) {
  const event::EventAxes facts = read_event_facts(folder + "/device");
  if (!is_of_a_tablet(facts)) return std::nullopt;
  const auto device = SysDevice::at(folder);
  if (!device || device->node().empty()) return std::nullopt;
  HidInterface found;
  found.event_node = device->node();
  found.physical = facts.physical;
  found.identity.bus = facts.bus;
  found.identity.vendor = facts.vendor;
  found.identity.product = facts.product;
  found.identity.name = facts.name;
  found.identity.report_descriptor = event::report_descriptor(facts);
  decode::complete_identity(found.identity);
  // The kernel numbers its entries as they come.
  struct stat entry {};
  if (::stat(device->path().c_str(), &entry) == 0) found.node_made = entry.st_ino;
  take_parents(found, *device);
  const bool has_place = found.physical.find("/input") != std::string::npos;
  found.identity.unit = has_place ? decode::unit_of_path(found.physical) : found.parent;
  return found;
}

}  // namespace

event::EventAxes read_event_facts(const std::string& folder) {
  event::EventAxes facts;
  for (const std::uint16_t key : read_bits(folder + "/capabilities/key")) facts.keys.insert(key);
  for (const std::uint16_t code : read_bits(folder + "/capabilities/abs")) {
    // A tool's kind and what HID drivers do not know are told apart by their range only.
    facts.abs[code] = code == ABS_MT_SLOT ? k_some_slots : code == ABS_MISC ? event::AbsRange{} : k_some_range;
  }
  for (const std::uint16_t code : read_bits(folder + "/capabilities/rel")) facts.rels.insert(code);
  if (!is_of_a_tablet(facts)) return facts;
  for (const std::uint16_t code : read_bits(folder + "/capabilities/msc")) facts.mscs.insert(code);
  for (const std::uint16_t property : read_bits(folder + "/properties")) facts.properties.insert(property);
  facts.name = read_sys_line(folder + "/name");
  facts.physical = read_sys_line(folder + "/phys");
  facts.bus = read_id(folder + "/id/bustype");
  facts.vendor = read_id(folder + "/id/vendor");
  facts.product = read_id(folder + "/id/product");
  return facts;
}

std::vector<HidInterface> list_event_devices(const std::string& folder) {
  std::vector<HidInterface> list;
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
    if (entry->path().filename().string().rfind("event", 0) != 0) continue;
    if (auto found = look_at(entry->path().string())) list.push_back(std::move(*found));
  }
  std::sort(list.begin(), list.end(), [](const HidInterface& a, const HidInterface& b) {
    return std::tie(a.parent, a.event_node) < std::tie(b.parent, b.event_node);
  });
  return list;
}

}  // namespace penpose::device
