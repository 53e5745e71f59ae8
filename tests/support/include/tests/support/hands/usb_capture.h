#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/byte_reader.h"

namespace penpose::tests {

using Buffer = std::vector<std::uint8_t>;

/// Bytes with numbers of either order.
class WireBytes {
 public:
  explicit WireBytes(bool high_first) : high_first_(high_first) {}

  WireBytes& number(std::uint64_t value, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      out.push_back(static_cast<std::uint8_t>(value >> (8 * (high_first_ ? size - 1 - i : i))));
    }
    return *this;
  }
  WireBytes& bytes(base::Bytes more) {
    out.insert(out.end(), more.begin(), more.end());
    return *this;
  }
  WireBytes& zeros(std::size_t count) {
    out.insert(out.end(), count, 0);
    return *this;
  }

  Buffer out;

 private:
  bool high_first_;
};

enum class CaptureForm : std::uint16_t { usbmon = 189, usbmon_mmapped = 220, usbpcap = 249 };

/// A USB device of the tests; interface i sends on endpoint 0x81 + i.
struct UsbTablet {
  std::uint16_t bus = 1;
  std::uint8_t address = 5;
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::vector<Buffer> report_descriptors;
  std::map<int, std::string> strings;  ///< 1 is the manufacturer, 2 the product
  std::uint8_t interface_class = 3;
};

/// A capture of USB requests as usbmon or USBPcap makes it, written without the code that the tests are about.
class UsbCapture {
 public:
  explicit UsbCapture(CaptureForm form = CaptureForm::usbmon_mmapped, bool high_first = false)
      : form_(form), high_first_(high_first) {}

  /// What a host asks a device that was plugged in, and its answers.
  UsbCapture& plug_in(const UsbTablet& tablet) {
    ask(tablet, 0, {0x80, 6, 0, 1, 0, 0, 64, 0}, device_descriptor(tablet));
    const Buffer device = device_descriptor(tablet);
    ask(tablet, tablet.address, {0x80, 6, 0, 1, 0, 0, 8, 0}, {device.begin(), device.begin() + 8});
    ask(tablet, tablet.address, {0x80, 6, 0, 1, 0, 0, 18, 0}, device);
    const Buffer configuration = configuration_descriptor(tablet);
    ask(tablet, tablet.address, {0x80, 6, 0, 2, 0, 0, 9, 0}, {configuration.begin(), configuration.begin() + 9});
    ask(tablet, tablet.address, {0x80, 6, 0, 2, 0, 0, 255, 0}, configuration);
    for (const auto& [index, text] : tablet.strings) tell_string(tablet, index, text);
    ask(tablet, tablet.address, {0, 9, 1, 0, 0, 0, 0, 0}, {});
    for (std::size_t i = 0; i < tablet.report_descriptors.size(); ++i) {
      const auto interface = static_cast<std::uint8_t>(i);
      ask(tablet, tablet.address, {0x81, 6, 0, 0x22, interface, 0, 255, 255}, tablet.report_descriptors[i]);
    }
    return *this;
  }

  UsbCapture& tell_string(const UsbTablet& tablet, int index, std::string_view text) {
    Buffer string{static_cast<std::uint8_t>(2 + 2 * text.size()), 3};
    for (const char c : text) string.insert(string.end(), {static_cast<std::uint8_t>(c), 0});
    return ask(tablet, tablet.address, {0x80, 6, static_cast<std::uint8_t>(index), 3, 9, 4, 255, 0}, string);
  }

  /// `kept`: of the report, the bytes that were captured.
  UsbCapture& report(const UsbTablet& tablet, int interface, const Buffer& report, std::size_t kept = SIZE_MAX) {
    const auto endpoint = static_cast<std::uint8_t>(0x81 + interface);
    ++id_;
    const Buffer first(report.begin(), report.begin() + static_cast<std::ptrdiff_t>(std::min(kept, report.size())));
    packet({false, 1, endpoint, tablet.bus, tablet.address, 0, 64, {}, {}});
    packet({true, 1, endpoint, tablet.bus, tablet.address, 0, report.size(), {}, first});
    return *this;
  }

  /// A control request and its answer; `status` is that of the answer.
  UsbCapture& ask(const UsbTablet& tablet, std::uint8_t address, const Buffer& setup, const Buffer& answer,
                  std::int32_t status = 0) {
    ++id_;
    const auto endpoint = static_cast<std::uint8_t>(setup[0] & 0x80);
    packet({false, 2, endpoint, tablet.bus, address, -115, answer.size(), setup, {}});
    packet({true, 2, endpoint, tablet.bus, address, status, answer.size(), {}, answer});
    return *this;
  }

  /// As QEMU writes them: no ids, and a sign where data follow.
  UsbCapture& as_qemu_writes() {
    for (auto& [time, packet] : packets_) {
      std::fill_n(packet.begin(), 8, std::uint8_t{0});
      if (packet[15] == 0) packet[15] = '=';
    }
    return *this;
  }

  UsbCapture& wait_us(std::int64_t micros) {
    time_us_ += micros;
    return *this;
  }

  [[nodiscard]] Buffer pcap(bool nanoseconds = false) const {
    WireBytes file(high_first_);
    file.number(nanoseconds ? 0xa1b23c4d : 0xa1b2c3d4, 4).number(2, 2).number(4, 2).zeros(8).number(262144, 4);
    file.number(static_cast<std::uint16_t>(form_), 4);
    for (const auto& [time, packet] : packets_) {
      const auto us = static_cast<std::uint64_t>(time);
      file.number(us / 1000000, 4).number(us % 1000000 * (nanoseconds ? 1000 : 1), 4);
      file.number(packet.size(), 4).number(packet.size(), 4).bytes(packet);
    }
    return file.out;
  }

  enum class Blocks { enhanced, obsolete };
  /// `resolution`: that of the times, in the form of if_tsresol.
  [[nodiscard]] Buffer pcapng(std::uint8_t resolution = 6, Blocks blocks = Blocks::enhanced) const {
    Buffer file = section();
    append(file, described(static_cast<std::uint16_t>(form_), resolution));
    for (const auto& [time, packet] : packets_) {
      const bool is_enhanced = blocks == Blocks::enhanced;
      const std::uint64_t stamp = stamp_of(static_cast<std::uint64_t>(time), resolution);
      WireBytes body(high_first_);
      body.number(0, is_enhanced ? 4 : 2).zeros(is_enhanced ? 0 : 2).number(stamp >> 32, 4).number(stamp, 4);
      body.number(packet.size(), 4).number(packet.size(), 4).bytes(packet).zeros((4 - packet.size() % 4) % 4);
      append(file, block(is_enhanced ? 6 : 2, body.out));
    }
    return file;
  }

  // Parts of pcapng.
  [[nodiscard]] Buffer section() const {
    return block(0x0a0d0d0a,
                 WireBytes(high_first_).number(0x1a2b3c4d, 4).number(1, 2).number(0, 2).number(~0ull, 8).out);
  }
  [[nodiscard]] Buffer described(std::uint16_t link_type, std::uint8_t resolution = 6) const {
    WireBytes body(high_first_);
    body.number(link_type, 2).zeros(2).number(262144, 4);
    body.number(2, 2).number(7, 2).bytes(base::as_bytes("usbmon1")).zeros(1);
    body.number(9, 2).number(1, 2).number(resolution, 1).zeros(3).zeros(4);
    return block(1, body.out);
  }
  [[nodiscard]] Buffer block(std::uint32_t type, const Buffer& body) const {
    WireBytes out(high_first_);
    return out.number(type, 4).number(body.size() + 12, 4).bytes(body).number(body.size() + 12, 4).out;
  }
  /// Packets with their headers, by time (microseconds).
  [[nodiscard]] const std::vector<std::pair<std::int64_t, Buffer>>& packets() const { return packets_; }

  static void append(Buffer& file, const Buffer& more) { file.insert(file.end(), more.begin(), more.end()); }

 private:
  struct Packet {
    bool is_answer;
    std::uint8_t transfer;
    std::uint8_t endpoint;
    std::uint16_t bus;
    std::uint16_t address;
    std::int32_t status;
    std::size_t length;
    Buffer setup;
    Buffer data;
  };

  static std::uint64_t stamp_of(std::uint64_t us, std::uint8_t resolution) {
    if (resolution >= 0x80)
      return (us / 1000000 << (resolution - 0x80)) + ((us % 1000000 << (resolution - 0x80)) / 1000000);
    for (int i = 6; i < resolution; ++i) us *= 10;
    for (int i = resolution; i < 6; ++i) us /= 10;
    return us;
  }

  static Buffer device_descriptor(const UsbTablet& tablet) {
    WireBytes out(false);
    out.bytes(Buffer{18, 1, 0, 2, 0, 0, 0, 64}).number(tablet.vendor, 2).number(tablet.product, 2).number(0x0100, 2);
    return out.bytes(Buffer{1, 2, 3, 1}).out;
  }

  static Buffer configuration_descriptor(const UsbTablet& tablet) {
    Buffer body;
    for (std::size_t i = 0; i < tablet.report_descriptors.size(); ++i) {
      const auto number = static_cast<std::uint8_t>(i);
      append(body, {9, 4, number, 0, 1, tablet.interface_class, 0, 0, 0});
      append(body, WireBytes(false)
                       .bytes(Buffer{9, 0x21, 0x11, 1, 0, 1, 0x22})
                       .number(tablet.report_descriptors[i].size(), 2)
                       .out);
      append(body, {7, 5, static_cast<std::uint8_t>(0x81 + i), 3, 64, 0, 2});
    }
    const auto interfaces = static_cast<std::uint8_t>(tablet.report_descriptors.size());
    return WireBytes(false)
        .number(0x0209, 2)
        .number(9 + body.size(), 2)
        .bytes(Buffer{interfaces, 1, 0, 0x80, 50})
        .bytes(body)
        .out;
  }

  void packet(const Packet& p) {
    WireBytes out(form_ != CaptureForm::usbpcap && high_first_);
    if (form_ == CaptureForm::usbpcap) {
      const bool is_control = p.transfer == 2;
      out.number(is_control ? 28 : 27, 2)
          .number(0xffff9000'00000000 + id_, 8)
          .number(static_cast<std::uint32_t>(p.is_answer ? p.status : 0), 4);
      out.number(is_control ? 8 : 9, 2).number(p.is_answer ? 1 : 0, 1).number(p.bus, 2).number(p.address, 2);
      out.number(p.endpoint, 1).number(p.transfer, 1);
      out.number(p.is_answer ? p.length : p.setup.size(), 4);
      if (is_control) out.number(p.is_answer ? 3 : 0, 1);
      out.bytes(p.is_answer ? p.data : p.setup);
    } else {
      out.number(0xffff9000'00000000 + id_, 8)
          .number(p.is_answer ? 'C' : 'S', 1)
          .number(p.transfer, 1)
          .number(p.endpoint, 1);
      out.number(p.address, 1).number(p.bus, 2).number(p.setup.empty() ? '-' : 0, 1);
      out.number(p.is_answer ? 0 : '<', 1);
      out.number(static_cast<std::uint64_t>(time_us_ / 1000000), 8)
          .number(static_cast<std::uint64_t>(time_us_ % 1000000), 4);
      out.number(static_cast<std::uint32_t>(p.status), 4).number(p.length, 4).number(p.data.size(), 4);
      if (p.setup.empty()) out.zeros(8);
      out.bytes(p.setup);
      if (form_ == CaptureForm::usbmon_mmapped) out.zeros(16);
      out.bytes(p.data);
    }
    packets_.emplace_back(time_us_, out.out);
    time_us_ += 125;
  }

  CaptureForm form_;
  bool high_first_;
  std::uint64_t id_ = 0;
  std::int64_t time_us_ = 1'700'000'000'000'000;
  std::vector<std::pair<std::int64_t, Buffer>> packets_;
};

}  // namespace penpose::tests
