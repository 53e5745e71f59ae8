#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "replay/recording/byte_stream.h"

namespace penpose::replay {

/// A packet as a capture file holds it.
struct CapturedPacket {
  std::uint16_t link_type = 0;  ///< what its bytes are (tcpdump.org/linktypes.html)
  bool high_first = false;      ///< whether the capturing machine's numbers have their highest byte first
  std::int64_t time_us = 0;     ///< by the clock of that machine; where the file has none, that of the packet before
  base::Bytes bytes;            ///< the first k_most_of_a_packet of what the file has; valid until the next is read
  std::uint64_t offset = 0;     ///< of its record in the file
};

/// Reads capture files packet by packet in memory that does not grow with the file: pcap
/// (draft-ietf-opsawg-pcap: microseconds or nanoseconds, either byte order) and pcapng (draft-ietf-opsawg-pcapng:
/// sections, interfaces with if_tsresol, enhanced, simple and obsolete packet blocks; other blocks and options are
/// skipped).
class CaptureReader {
 public:
  /// More than the largest HID report or descriptor with its headers; what a packet has beyond is skipped.
  static constexpr std::size_t k_most_of_a_packet = std::size_t{1} << 17;

  explicit CaptureReader(ReadBytes read) : stream_(std::move(read)) {}

  /// Whether a file that begins with these bytes is such a capture.
  [[nodiscard]] static bool recognises(base::Bytes front);

  /// The next packet, nothing at the end. Errors: those of reading, and a damaged file, with the place ("byte 1234").
  base::Result<std::optional<CapturedPacket>> next();

  /// Once the end is reached: whether the file ends in the middle of a packet or block.
  [[nodiscard]] bool is_cut() const { return cut_; }

 private:
  enum class Form : std::uint8_t { unknown, pcap, pcapng };

  /// What pcapng says of one interface.
  struct Interface {
    std::uint16_t link_type = 0;
    std::uint32_t most = 0;       ///< bytes kept of a packet, 0: all
    std::uint8_t resolution = 6;  ///< if_tsresol
  };

  using Next = base::Result<std::optional<CapturedPacket>>;

  base::Status begin();
  Next next_of_pcap();
  Next next_of_pcapng();
  base::Status begin_section();
  base::Status add_interface(std::size_t length);
  Next packet_of_block(std::uint32_t type, std::uint32_t length);
  Next take_packet(CapturedPacket packet, std::size_t header, std::uint64_t captured);
  base::Result<bool> end_block(std::uint64_t unread, std::uint32_t length);
  base::Result<bool> skip(std::uint64_t count);
  [[nodiscard]] base::Error damaged(const std::string& what) const;

  ByteStream stream_;
  Form form_ = Form::unknown;
  bool high_first_ = false;
  bool nanoseconds_ = false;     ///< of pcap
  std::uint16_t link_type_ = 0;  ///< of pcap
  std::vector<Interface> interfaces_;
  std::vector<std::uint8_t> packet_;
  std::int64_t time_us_ = 0;
  std::uint64_t record_ = 0;  ///< offset of the record or block that is read
  bool cut_ = false;
};

}  // namespace penpose::replay
