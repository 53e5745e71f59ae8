#include "replay/recording/usb/capture_reader.h"

#include <algorithm>
#include <string>

#include "replay/recording/usb/wire_number.h"

namespace penpose::replay {
namespace {

/// What a pcap file begins with, by the unit of its fractions of a second.
enum PcapMagic : std::uint32_t { k_pcap_micros = 0xa1b2c3d4, k_pcap_nanos = 0xa1b23c4d };
constexpr std::size_t k_pcap_header = 24;
constexpr std::size_t k_pcap_record = 16;

enum BlockType : std::uint32_t {
  k_interface_block = 1,
  k_obsolete_block = 2,
  k_simple_block = 3,
  k_enhanced_block = 6,
  k_section_block = 0x0a0d0d0a  ///< reads the same in both byte orders
};
constexpr std::uint32_t k_byte_order = 0x1a2b3c4d;
constexpr std::uint64_t k_block_frame = 12;  // type and length in front, length behind
constexpr std::uint16_t k_option_resolution = 9;

/// More than any program writes for one packet: libpcap's own limit for USB.
constexpr std::uint64_t k_most_captured = std::uint64_t{1} << 27;
/// More interfaces are in no capture; a hostile one must not fill the memory.
constexpr std::size_t k_most_sources = 4096;
/// Options behind them are not looked at.
constexpr std::size_t k_most_of_options = 4096;
constexpr std::int64_t k_capture_micros = 1'000'000;
/// Later times count as this one: some 200,000 years.
constexpr std::uint64_t k_latest_us = std::uint64_t{1} << 62;

std::uint64_t times(std::uint64_t a, std::uint64_t b) { return b != 0 && a > k_latest_us / b ? k_latest_us : a * b; }

/// A time stamp of pcapng in microseconds: `resolution` is a power of ten, or of two with its highest bit set.
std::int64_t micros_of(std::uint64_t stamp, std::uint8_t resolution) {
  const unsigned power = resolution & 0x7f;
  std::uint64_t micros = 0;
  if ((resolution & 0x80) != 0) {
    const std::uint64_t seconds = power < 64 ? stamp >> power : 0;
    std::uint64_t rest = power < 64 ? stamp & ((std::uint64_t{1} << power) - 1) : stamp;
    // The product has to fit: 20 bits are left for the million.
    const unsigned dropped = power > 43 ? power - 43 : 0;
    rest = dropped < 64 ? rest >> dropped : 0;
    micros = times(seconds, k_capture_micros) + (rest * k_capture_micros >> (power - dropped));
  } else {
    micros = stamp;
    for (unsigned i = power; i < 6; ++i) micros = times(micros, 10);
    for (unsigned i = 6; i < power && micros > 0; ++i) micros /= 10;
  }
  return static_cast<std::int64_t>(std::min(micros, k_latest_us));
}

std::size_t padded(std::size_t length) { return (length + 3) / 4 * 4; }

}  // namespace

bool CaptureReader::recognises(base::Bytes front) {
  const std::uint64_t magic = wire_number(front, 0, 4, false);
  const std::uint64_t turned = wire_number(front, 0, 4, true);
  if (magic == k_section_block) {
    return wire_number(front, 8, 4, false) == k_byte_order || wire_number(front, 8, 4, true) == k_byte_order;
  }
  return magic == k_pcap_micros || magic == k_pcap_nanos || turned == k_pcap_micros || turned == k_pcap_nanos;
}

base::Error CaptureReader::damaged(const std::string& what) const {
  return {"the capture is damaged: " + what, "byte " + std::to_string(record_), "capture it again"};
}

base::Status CaptureReader::begin() {
  const auto front = stream_.peek(k_pcap_header);
  if (!front) return front.error();
  if (!recognises(*front)) return base::Error{"is no capture file", "", "give a file of type pcap or pcapng"};
  if (wire_number(*front, 0, 4, false) == k_section_block) {
    form_ = Form::pcapng;
    return base::Done{};
  }
  form_ = Form::pcap;
  const std::uint64_t magic = wire_number(*front, 0, 4, false);
  high_first_ = magic != k_pcap_micros && magic != k_pcap_nanos;
  nanoseconds_ = wire_number(*front, 0, 4, high_first_) == k_pcap_nanos;
  // The upper half tells of frame check sequences.
  link_type_ = static_cast<std::uint16_t>(wire_number(*front, 20, 4, high_first_));
  cut_ = front->size() < k_pcap_header;
  stream_.skip(front->size());
  return base::Done{};
}

CaptureReader::Next CaptureReader::next() {
  if (form_ == Form::unknown) {
    if (const auto begun = begin(); !begun) return begun.error();
  }
  if (cut_) return std::optional<CapturedPacket>();
  return form_ == Form::pcap ? next_of_pcap() : next_of_pcapng();
}

/// False where the file ends before.
base::Result<bool> CaptureReader::skip(std::uint64_t count) {
  while (count > 0) {
    const auto got = stream_.peek(static_cast<std::size_t>(std::min<std::uint64_t>(count, k_most_of_a_packet)));
    if (!got) return got.error();
    if (got->empty()) return false;
    const std::size_t taken = got->size();
    stream_.skip(taken);
    count -= taken;
  }
  return true;
}

/// Copies a packet that begins `header` bytes from here, and skips what it has beyond.
CaptureReader::Next CaptureReader::take_packet(CapturedPacket packet, std::size_t header, std::uint64_t captured) {
  const auto kept = static_cast<std::size_t>(std::min<std::uint64_t>(captured, k_most_of_a_packet));
  const auto bytes = stream_.peek(header + kept);
  if (!bytes) return bytes.error();
  cut_ = bytes->size() < header + kept;
  if (cut_) return std::optional<CapturedPacket>();
  packet_.assign(bytes->begin() + static_cast<std::ptrdiff_t>(header), bytes->end());
  stream_.skip(header + kept);
  const auto whole = skip(captured - kept);
  if (!whole) return whole.error();
  cut_ = !*whole;
  packet.bytes = packet_;
  packet.high_first = high_first_;
  packet.offset = record_;
  time_us_ = packet.time_us;
  return std::optional(packet);
}

CaptureReader::Next CaptureReader::next_of_pcap() {
  record_ = stream_.offset();
  const auto head = stream_.peek(k_pcap_record);
  if (!head) return head.error();
  cut_ = !head->empty() && head->size() < k_pcap_record;
  if (head->empty() || cut_) return std::optional<CapturedPacket>();
  const std::uint64_t seconds = wire_number(*head, 0, 4, high_first_);
  const std::uint64_t fraction = wire_number(*head, 4, 4, high_first_);
  const std::uint64_t captured = wire_number(*head, 8, 4, high_first_);
  if (captured > k_most_captured) return damaged("a packet of " + std::to_string(captured) + " bytes");
  CapturedPacket packet;
  packet.link_type = link_type_;
  packet.time_us = static_cast<std::int64_t>(seconds * k_capture_micros + fraction / (nanoseconds_ ? 1000 : 1));
  return take_packet(packet, k_pcap_record, captured);
}

CaptureReader::Next CaptureReader::next_of_pcapng() {
  for (;;) {
    record_ = stream_.offset();
    auto head = stream_.peek(12);
    if (!head) return head.error();
    cut_ = !head->empty() && head->size() < 12;
    if (head->empty() || cut_) return std::optional<CapturedPacket>();
    const auto type = static_cast<std::uint32_t>(wire_number(*head, 0, 4, high_first_));
    if (type == k_section_block) {
      high_first_ = wire_number(*head, 8, 4, true) == k_byte_order;
      if (wire_number(*head, 8, 4, high_first_) != k_byte_order) return damaged("a section without its byte order");
    }
    const auto length = static_cast<std::uint32_t>(wire_number(*head, 4, 4, high_first_));
    if (length < k_block_frame || length % 4 != 0) return damaged("a block of " + std::to_string(length) + " bytes");
    if (type == k_enhanced_block || type == k_simple_block || type == k_obsolete_block) {
      auto packet = packet_of_block(type, length);
      if (!packet || packet->has_value() || cut_) return packet;
      continue;
    }
    if (type == k_section_block) {
      if (const auto begun = begin_section(); !begun) return begun.error();
    } else if (type == k_interface_block) {
      if (const auto added = add_interface(length); !added) return added.error();
    }
    const auto whole = end_block(length, length);
    if (!whole) return whole.error();
    if (!*whole) return std::optional<CapturedPacket>();
  }
}

/// Skips what is unread of a block; false where the file ends in it.
base::Result<bool> CaptureReader::end_block(std::uint64_t unread, std::uint32_t length) {
  auto whole = skip(unread - 4);
  if (!whole) return whole;
  const auto behind = stream_.peek(4);
  if (!behind) return behind.error();
  cut_ = !*whole || behind->size() < 4;
  if (cut_) return false;
  if (wire_number(*behind, 0, 4, high_first_) != length) return damaged("a block with two lengths");
  stream_.skip(4);
  return true;
}

base::Status CaptureReader::begin_section() {
  interfaces_.clear();
  const auto head = stream_.peek(14);
  if (!head) return head.error();
  const std::uint64_t version = wire_number(*head, 12, 2, high_first_);
  if (head->size() == 14 && version != 1) {
    return base::Error{"is a capture of pcapng's version " + std::to_string(version), "byte " + std::to_string(record_),
                       "save it in version 1"};
  }
  return base::Done{};
}

base::Status CaptureReader::add_interface(std::size_t length) {
  if (length < 20) return damaged("an interface of " + std::to_string(length) + " bytes");
  if (interfaces_.size() >= k_most_sources) return damaged("more than 4096 interfaces");
  const auto peeked = stream_.peek(std::min(length - 4, 16 + k_most_of_options));
  if (!peeked) return peeked.error();
  const base::Bytes block = *peeked;
  Interface interface;
  interface.link_type = static_cast<std::uint16_t>(wire_number(block, 8, 2, high_first_));
  interface.most = static_cast<std::uint32_t>(wire_number(block, 12, 4, high_first_));
  for (std::size_t at = 16; at + 4 < block.size();) {
    const std::uint64_t option = wire_number(block, at, 2, high_first_);
    const auto size = static_cast<std::size_t>(wire_number(block, at + 2, 2, high_first_));
    if (option == 0) break;
    if (option == k_option_resolution && size == 1) interface.resolution = block[at + 4];
    at += 4 + padded(size);
  }
  interfaces_.push_back(interface);
  return base::Done{};
}

/// Nothing where the packet is left out, or the file ends in it.
CaptureReader::Next CaptureReader::packet_of_block(std::uint32_t type, std::uint32_t length) {
  const std::size_t header = type == k_simple_block ? 12 : 28;
  if (length < header + 4) return damaged("a packet's block of " + std::to_string(length) + " bytes");
  const auto peeked = stream_.peek(header);
  if (!peeked) return peeked.error();
  cut_ = peeked->size() < header;
  if (cut_) return std::optional<CapturedPacket>();
  const base::Bytes block = *peeked;
  const auto field = [&](std::size_t at, std::size_t size) { return wire_number(block, at, size, high_first_); };
  const std::uint64_t number = type == k_simple_block ? 0 : field(8, type == k_enhanced_block ? 4 : 2);
  if (number >= interfaces_.size()) return damaged("a packet of an interface that is not described");
  const Interface& interface = interfaces_[static_cast<std::size_t>(number)];
  const std::uint64_t room = length - header - 4;
  CapturedPacket packet;
  packet.link_type = interface.link_type;
  packet.time_us = time_us_;
  std::uint64_t captured = field(20, 4);
  if (type == k_simple_block) {
    captured = std::min(field(8, 4), room);
    if (interface.most != 0) captured = std::min<std::uint64_t>(captured, interface.most);
  } else {
    packet.time_us = micros_of(field(12, 4) << 32 | field(16, 4), interface.resolution);
  }
  if (captured > room) return damaged("a packet larger than its block");
  auto taken = take_packet(packet, header, captured);
  if (!taken || !taken->has_value() || cut_) return taken;
  const auto whole = end_block(length - header - captured, length);
  if (!whole) return whole.error();
  return taken;
}

}  // namespace penpose::replay
