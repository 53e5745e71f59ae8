#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "replay/recording/usb/capture_reader.h"

namespace penpose::replay {

enum class UsbTransfer : std::uint8_t { isochronous, interrupt, control, bulk };

/// A request to a USB device or its answer, as usbmon of Linux or USBPcap of Windows shows them.
struct UsbPacket {
  std::uint64_t id = 0;  ///< the same for a request and its answer
  bool is_answer = false;
  bool succeeded = false;  ///< of an answer
  UsbTransfer transfer = UsbTransfer::bulk;
  std::uint8_t endpoint = 0;  ///< with 0x80 where data come from the device
  std::uint16_t bus = 0;
  std::uint16_t device = 0;  ///< its address on the bus
  bool is_root_hub = false;  ///< the bus itself, no device on it
  /// Of a control request (USB 2.0, 9.3).
  std::optional<std::array<std::uint8_t, 8>> setup;
  base::Bytes data;        ///< what was captured of them
  std::size_t length = 0;  ///< of all data
};

/// Whether packets of a link type are those of USB that `read_usb_packet` reads: LINKTYPE_USB_LINUX,
/// LINKTYPE_USB_LINUX_MMAPPED and LINKTYPE_USBPCAP.
[[nodiscard]] bool is_usb_link(std::uint16_t link_type);

/// Reads the header in front of a packet's data: those of usbmon (Linux, Documentation/usb/usbmon.rst) and of USBPcap
/// (desowin.org/usbpcap/captureformat.html). Nothing for one of another link type, one that is shorter than its header,
/// and one of no kind of transfer. What it points to is that of `packet`.
[[nodiscard]] std::optional<UsbPacket> read_usb_packet(const CapturedPacket& packet);

}  // namespace penpose::replay
