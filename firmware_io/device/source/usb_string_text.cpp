#include "firmware_io/device/source/usb_string_text.h"

#include <algorithm>

#include "firmware_io/decode/table/told_ranges.h"
#include "firmware_io/device/source/usb_strings.h"

namespace penpose::device {
namespace {

constexpr std::uint16_t k_american_english = 0x0409;
constexpr std::uint8_t k_string_descriptor = 0x03;

}  // namespace

base::Result<std::string> read_usb_string(const std::string& usb_node, std::uint8_t index) {
  if (usb_node.empty()) return base::Error{"not a USB device", "", ""};
  const auto strings = UsbStrings::open(usb_node);
  if (!strings) return strings.error();
  return strings->read(index);
}

std::uint16_t language_of_string(std::uint8_t index) { return index == 0 ? 0 : k_american_english; }

base::Result<std::string> text_of_string(base::Bytes descriptor, std::uint8_t index) {
  if (descriptor.size() < 2 || descriptor[1] != k_string_descriptor) {
    return base::Error{"string " + std::to_string(index) + " is none", "", ""};
  }
  const std::size_t end = std::min<std::size_t>(descriptor.size(), descriptor[0]);
  if (index == decode::k_ranges_string && end > 2) return decode::ranges_text(descriptor.subspan(2, end - 2));
  std::string text;
  for (std::size_t i = 2; i + 1 < end; i += 2) {
    const bool ascii = descriptor[i + 1] == 0 && descriptor[i] >= 0x20 && descriptor[i] < 0x7f;
    text += ascii ? static_cast<char>(descriptor[i]) : '?';
  }
  return text;
}

}  // namespace penpose::device
