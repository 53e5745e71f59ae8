#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "replay/recording/usb/capture_reader.h"
#include "replay/recording/usb/usb_device.h"
#include "replay/recording/usb/usb_packet.h"
#include "replay/trace/trace_writer.h"

namespace penpose::replay {

/// Makes a trace of a capture of USB requests. Each HID interface becomes a device of the trace: its ids, name, strings
/// and report descriptor are those that the driver asked the device for, its reports what came on its interrupt
/// endpoint, with times since the first report, which never decrease.
///
/// A device that was there before the capture began was asked for nothing any more: each of its endpoints becomes a
/// device without ids. A capture that ends in the middle of a packet becomes a trace that ends in the middle of a line.
class UsbRecording {
 public:
  explicit UsbRecording(ReadBytes read) : capture_(std::move(read)) {}

  /// Appends the text of the next packets; false at the end. Errors: those of the capture, one without USB and one
  /// without reports.
  base::Result<bool> next(std::string& out);

 private:
  using Place = std::pair<std::uint16_t, std::uint16_t>;  ///< bus and address
  using Setup = std::array<std::uint8_t, 8>;

  /// A device of the trace.
  struct Shown {
    int number = 0;
    bool declared = false;  ///< as it is known now
    int declarations = 0;
  };
  struct Known {
    UsbDevice usb;
    std::map<int, Shown> shown;  ///< by interface; k_unknown_interface and the endpoint's number where that is unknown
    std::set<int> new_strings;   ///< that came after a declaration
  };

  void take(const UsbPacket& packet);
  void take_control(const UsbPacket& packet);
  void take_answer(const Place& place, const Setup& setup, base::Bytes data);
  void take_report(const UsbPacket& packet);
  Known* known_at(const Place& place);
  std::optional<int> shown_interface(Known& known, const UsbPacket& packet);
  void declare_news();
  void declare(const Place& place, Known& known, int interface, Shown& shown);
  void tell_string(const Known& known, int number, int index);
  [[nodiscard]] base::Status check_end() const;

  CaptureReader capture_;
  TraceWriter writer_;
  std::map<Place, Known> known_;
  std::set<Place> news_;  ///< where something is to be declared
  /// Without an answer so far. QEMU gives all of a device the same id.
  std::map<std::pair<Place, std::uint64_t>, Setup> requests_;
  std::size_t descriptor_bytes_ = 0;
  int numbers_ = 0;
  std::uint64_t packets_ = 0;
  std::optional<std::uint16_t> other_link_;  ///< of a packet that is none of USB
  std::uint64_t reports_ = 0;
  std::int64_t time_us_ = 0;  ///< of the packet that is read
  std::int64_t first_us_ = 0;
  std::int64_t span_us_ = 0;
  bool ended_ = false;
};

}  // namespace penpose::replay
