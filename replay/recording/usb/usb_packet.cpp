#include "replay/recording/usb/usb_packet.h"

#include <algorithm>

#include "replay/recording/usb/wire_number.h"

namespace penpose::replay {
namespace {

/// Link types of USB (tcpdump.org/linktypes.html).
enum Link : std::uint16_t { k_usb_linux = 189, k_usb_linux_mmapped = 220, k_usbpcap = 249 };

constexpr std::size_t k_setup = 8;
constexpr std::size_t k_usbpcap_header = 27;  // of a control transfer one more, its stage
constexpr std::uint8_t k_setup_stage = 0;

std::array<std::uint8_t, k_setup> setup_of(base::Bytes bytes) {
  std::array<std::uint8_t, k_setup> setup{};
  std::copy_n(bytes.begin(), k_setup, setup.begin());
  return setup;
}

/// 48 bytes, with mmapped buffers 64, whose last 16 say nothing of the transfers that are read here.
std::optional<UsbPacket> read_usbmon(const CapturedPacket& captured, std::size_t header) {
  const base::Bytes bytes = captured.bytes;
  if (bytes.size() < header) return std::nullopt;
  const auto field = [&](std::size_t at, std::size_t size) {
    return wire_number(bytes, at, size, captured.high_first);
  };
  const std::uint8_t event = bytes[8];
  const std::uint8_t transfer = bytes[9];
  if ((event != 'S' && event != 'C') || transfer > 3) return std::nullopt;
  UsbPacket packet;
  packet.id = field(0, 8);
  packet.is_answer = event == 'C';
  packet.succeeded = packet.is_answer && field(28, 4) == 0;
  packet.transfer = static_cast<UsbTransfer>(transfer);
  packet.endpoint = bytes[10];
  packet.device = bytes[11];
  packet.is_root_hub = packet.device == 1;
  packet.bus = static_cast<std::uint16_t>(field(12, 2));
  if (!packet.is_answer && packet.transfer == UsbTransfer::control && bytes[14] == 0)
    packet.setup = setup_of(bytes.subspan(40));
  packet.length = static_cast<std::size_t>(field(32, 4));
  // The kernel writes 0 where data follow, QEMU the sign of usbmon's text; anything else says why there are none.
  if (bytes[15] == 0 || bytes[15] == '=') {
    packet.data = bytes.subspan(header);
    packet.data = packet.data.first(std::min(packet.data.size(), static_cast<std::size_t>(field(36, 4))));
  }
  return packet;
}

std::optional<UsbPacket> read_usbpcap(const CapturedPacket& captured) {
  const base::Bytes bytes = captured.bytes;
  if (bytes.size() < k_usbpcap_header) return std::nullopt;
  // Always that of Windows' processors.
  const auto field = [&](std::size_t at, std::size_t size) { return wire_number(bytes, at, size, false); };
  const auto header = static_cast<std::size_t>(field(0, 2));
  const std::uint8_t transfer = bytes[22];
  if (header < k_usbpcap_header || header > bytes.size() || transfer > 3) return std::nullopt;
  UsbPacket packet;
  packet.id = field(2, 8);
  packet.is_answer = (bytes[16] & 1) != 0;
  packet.succeeded = packet.is_answer && field(10, 4) == 0;
  packet.transfer = static_cast<UsbTransfer>(transfer);
  packet.bus = static_cast<std::uint16_t>(field(17, 2));
  packet.device = static_cast<std::uint16_t>(field(19, 2));
  packet.endpoint = bytes[21];
  packet.data = bytes.subspan(header);
  packet.length = static_cast<std::size_t>(field(23, 4));
  const bool is_setup = header > k_usbpcap_header && bytes[k_usbpcap_header] == k_setup_stage;
  if (!packet.is_answer && packet.transfer == UsbTransfer::control && is_setup && packet.data.size() >= k_setup) {
    packet.setup = setup_of(packet.data);
  }
  return packet;
}

}  // namespace

bool is_usb_link(std::uint16_t link_type) {
  return link_type == k_usb_linux || link_type == k_usb_linux_mmapped || link_type == k_usbpcap;
}

std::optional<UsbPacket> read_usb_packet(const CapturedPacket& packet) {
  switch (packet.link_type) {
    case k_usb_linux:
      return read_usbmon(packet, 48);
    case k_usb_linux_mmapped:
      return read_usbmon(packet, 64);
    case k_usbpcap:
      return read_usbpcap(packet);
    default:
      return std::nullopt;
  }
}

}  // namespace penpose::replay
