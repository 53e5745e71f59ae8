#include "replay/recording/usb/usb_device.h"

#include <algorithm>

#include "core/base/text/letters.h"
#include "core/base/text/utf16.h"
#include "core/base/text/utf8.h"
#include "firmware_io/decode/table/told_ranges.h"
#include "replay/recording/usb/wire_number.h"

namespace penpose::replay {
namespace {

enum DescriptorType : std::uint8_t { k_device = 1, k_configuration, k_string, k_interface, k_endpoint };

constexpr std::uint8_t k_hid_class = 3;
constexpr std::uint8_t k_interrupt = 3;
constexpr std::uint16_t k_american = 0x0409;

/// Real devices have one or two, and a few interfaces.
constexpr std::size_t k_most_configurations = 8;
constexpr int k_most_interfaces = 32;

std::uint16_t number(base::Bytes bytes, std::size_t at) {
  return static_cast<std::uint16_t>(wire_number(bytes, at, 2, false));
}

std::string utf8_of_utf16(base::Bytes text) {
  std::string out;
  for (std::size_t at = 0; at + 1 < text.size();) {
    const auto [code, units] = base::utf16_point(number(text, at), at + 3 < text.size() ? number(text, at + 2) : 0);
    if (code == 0) break;
    out += base::utf8_of(code);
    at += 2 * units;
  }
  return out;
}

}  // namespace

bool UsbDevice::take_device(base::Bytes descriptor, bool& is_other) {
  is_other = false;
  // Drivers ask for the first eight bytes alone, too.
  if (descriptor.size() < 18 || descriptor[1] != k_device) return false;
  const std::uint16_t vendor = number(descriptor, 8);
  const std::uint16_t product = number(descriptor, 10);
  if (has_ids_ && vendor == vendor_ && product == product_) return false;
  is_other = has_ids_;
  if (is_other) *this = {};
  has_ids_ = true;
  vendor_ = vendor;
  product_ = product;
  manufacturer_string_ = descriptor[14];
  product_string_ = descriptor[15];
  return true;
}

bool UsbDevice::take_configuration(base::Bytes descriptor) {
  if (descriptor.size() < 9 || descriptor[1] != k_configuration) return false;
  const int value = descriptor[5];
  Configuration made;
  made.interfaces.fill(-1);
  bool has_interfaces = false;
  int interface = -1;
  for (base::Bytes rest = descriptor; rest.size() >= 2;) {
    const std::size_t length = rest[0];
    if (length < 2 || length > rest.size()) break;
    if (rest[1] == k_interface && length >= 9) {
      interface = rest[2] < k_most_interfaces ? rest[2] : -1;
      has_interfaces = true;
      if (rest[5] == k_hid_class && interface >= 0) made.hid.insert(interface);
    } else if (rest[1] == k_endpoint && length >= 7 && (rest[2] & 0x80) != 0 && (rest[3] & 3) == k_interrupt) {
      made.interfaces[rest[2] & 15] = static_cast<std::int16_t>(interface);
    }
    rest = rest.subspan(length);
  }
  // Drivers ask for the first nine bytes alone, too.
  if (!has_interfaces) return false;
  const auto found = configurations_.find(value);
  if (found == configurations_.end() && configurations_.size() >= k_most_configurations) return false;
  if (found != configurations_.end() && found->second.interfaces == made.interfaces && found->second.hid == made.hid) {
    return false;
  }
  configurations_[value] = made;
  return true;
}

bool UsbDevice::take_string(int index, std::uint16_t language, base::Bytes descriptor) {
  if (index == 0 || descriptor.size() < 2 || descriptor[1] != k_string) return false;
  const std::size_t length = descriptor[0];
  // Drivers ask for the first two bytes alone, too.
  if (length < 2 || length > descriptor.size()) return false;
  std::vector<std::uint8_t> text(descriptor.begin() + 2, descriptor.begin() + static_cast<std::ptrdiff_t>(length));
  const auto found = strings_.find(index);
  if (found != strings_.end() && (language != k_american || found->second == text)) return false;
  strings_[index] = std::move(text);
  return true;
}

bool UsbDevice::take_report_descriptor(int interface, base::Bytes descriptor, std::size_t room) {
  if (descriptor.empty() || interface < 0 || interface >= k_most_interfaces) return false;
  const std::vector<std::uint8_t>& kept = report_descriptor(interface);
  // The begin of what is known already.
  if (descriptor.size() <= kept.size() && std::equal(descriptor.begin(), descriptor.end(), kept.begin())) return false;
  if (descriptor.size() > kept.size() + room) return false;
  report_descriptors_[interface].assign(descriptor.begin(), descriptor.end());
  return true;
}

const UsbDevice::Configuration* UsbDevice::configuration() const {
  if (configurations_.empty()) return nullptr;
  const auto found = chosen_ ? configurations_.find(*chosen_) : configurations_.begin();
  return &(found == configurations_.end() ? configurations_.begin() : found)->second;
}

std::optional<int> UsbDevice::interface_of(std::uint8_t endpoint) const {
  const Configuration* chosen = configuration();
  const int interface = chosen == nullptr ? -1 : chosen->interfaces[endpoint & 15];
  return interface < 0 ? std::nullopt : std::optional(interface);
}

bool UsbDevice::is_hid(int interface) const {
  const Configuration* chosen = configuration();
  return (chosen != nullptr && chosen->hid.contains(interface)) || report_descriptors_.contains(interface);
}

std::set<int> UsbDevice::hid_interfaces() const {
  const Configuration* chosen = configuration();
  std::set<int> all = chosen == nullptr ? std::set<int>() : chosen->hid;
  for (const auto& [interface, descriptor] : report_descriptors_) all.insert(interface);
  return all;
}

const std::vector<std::uint8_t>& UsbDevice::report_descriptor(int interface) const {
  static const std::vector<std::uint8_t> k_none;
  const auto found = report_descriptors_.find(interface);
  return found == report_descriptors_.end() ? k_none : found->second;
}

std::size_t UsbDevice::kept() const {
  std::size_t sum = 0;
  for (const auto& [interface, descriptor] : report_descriptors_) sum += descriptor.size();
  return sum;
}

std::string UsbDevice::name() const {
  const auto text = [&](int index) {
    const auto found = strings_.find(index);
    return found == strings_.end() ? std::string() : utf8_of_utf16(found->second);
  };
  const std::string manufacturer = text(manufacturer_string_);
  const std::string product = text(product_string_);
  if (manufacturer.empty() || product.empty()) {
    if (!manufacturer.empty() || !product.empty()) return manufacturer + product;
    if (!has_ids_) return "USB device without descriptors";
    std::string ids = "HID ";
    base::append_hex(ids, vendor_, 4);
    ids += ':';
    base::append_hex(ids, product_, 4);
    return ids;
  }
  return manufacturer + ' ' + product;
}

std::string UsbDevice::string(int index) const {
  std::string out;
  const auto found = strings_.find(index);
  if (found == strings_.end()) return out;
  if (index == decode::k_ranges_string) return decode::ranges_text(found->second);
  for (std::size_t at = 0; at + 1 < found->second.size(); at += 2) {
    const std::uint16_t code = number(found->second, at);
    out += code < 0x80 ? static_cast<char>(code) : '?';
  }
  return out;
}

}  // namespace penpose::replay
