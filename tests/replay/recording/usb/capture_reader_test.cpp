#include "replay/recording/usb/capture_reader.h"

#include <gtest/gtest.h>
#include <set>

#include "tests/support/hands/usb_capture.h"

namespace penpose::replay {
namespace {

using tests::Buffer;
using tests::UsbCapture;

/// The packets of the tests, and times of days that no 32 bits of microseconds hold.
UsbCapture some_packets(bool high_first = false) {
  UsbCapture capture(tests::CaptureForm::usbmon_mmapped, high_first);
  const tests::UsbTablet tablet{1, 5, 0x1b96, 0x1000, {{5, 13}}, {}};
  capture.report(tablet, 0, {7, 1, 2}).wait_us(61'000'017).report(tablet, 0, {7, 3, 4, 5, 6});
  return capture;
}

struct Captured {
  std::vector<std::pair<std::int64_t, Buffer>> packets;
  std::set<std::uint16_t> links;
  std::string error;  ///< empty: read to the end
  bool cut = false;
};

Captured read_all(const Buffer& file) {
  Captured all;
  CaptureReader reader(read_from(file));
  for (;;) {
    const auto packet = reader.next();
    if (!packet) {
      all.error = packet.error().line();
      return all;
    }
    if (!packet->has_value()) break;
    all.packets.emplace_back((*packet)->time_us, Buffer((*packet)->bytes.begin(), (*packet)->bytes.end()));
    all.links.insert((*packet)->link_type);
  }
  all.cut = reader.is_cut();
  return all;
}

void expect_packets(const Buffer& file, const UsbCapture& capture) {
  EXPECT_TRUE(CaptureReader::recognises(file));
  const Captured all = read_all(file);
  EXPECT_EQ(all.error, "");
  EXPECT_FALSE(all.cut);
  EXPECT_EQ(all.packets, capture.packets());
  EXPECT_EQ(all.links, std::set<std::uint16_t>{220});
}

TEST(CaptureReader, ReadsPcapOfEitherOrderInMicrosecondsAndNanoseconds) {
  for (const bool high_first : {false, true}) {
    const UsbCapture capture = some_packets(high_first);
    expect_packets(capture.pcap(), capture);
    expect_packets(capture.pcap(true), capture);
  }
}

TEST(CaptureReader, ReadsPcapngInEveryResolutionOfTime) {
  for (const bool high_first : {false, true}) {
    const UsbCapture capture = some_packets(high_first);
    for (const std::uint8_t resolution : Buffer{6, 9, 8}) expect_packets(capture.pcapng(resolution), capture);
    expect_packets(capture.pcapng(6, UsbCapture::Blocks::obsolete), capture);
    const Captured coarse = read_all(capture.pcapng(3));
    const Captured binary = read_all(capture.pcapng(0x80 + 20));
    ASSERT_EQ(coarse.packets.size(), capture.packets().size());
    ASSERT_EQ(binary.packets.size(), capture.packets().size());
    for (std::size_t i = 0; i < coarse.packets.size(); ++i) {
      const std::int64_t time = capture.packets()[i].first;
      EXPECT_EQ(coarse.packets[i].first, time / 1000 * 1000);
      EXPECT_NEAR(static_cast<double>(binary.packets[i].first - time), 0, 1);
    }
  }
}

TEST(CaptureReader, TimesBeyondAllMeasureStayInOrder) {
  const UsbCapture parts;
  tests::WireBytes body(false);
  body.number(0, 4).number(0xffffffff, 4).number(0xffffffff, 4).number(4, 4).number(4, 4).zeros(4);
  for (const std::uint8_t resolution : Buffer{0, 3, 6, 19, 127, 0x80, 0x80 + 32, 0x80 + 63, 0x80 + 64, 0xff}) {
    Buffer file = parts.section();
    UsbCapture::append(file, parts.described(220, resolution));
    UsbCapture::append(file, parts.block(6, body.out));
    const Captured all = read_all(file);
    ASSERT_EQ(all.packets.size(), 1u) << all.error;
    EXPECT_GE(all.packets[0].first, 0);
  }
}

TEST(CaptureReader, TakesSimplePacketsSeveralInterfacesAndSectionsAndSkipsOtherBlocks) {
  const UsbCapture low;
  const UsbCapture high(tests::CaptureForm::usbmon, true);
  Buffer file = low.section();
  UsbCapture::append(file, low.block(0xbad, Buffer(40)));
  UsbCapture::append(file, low.described(1));
  UsbCapture::append(file, low.described(220, 9));
  UsbCapture::append(file, low.block(5, Buffer(16)));
  tests::WireBytes second(false);
  second.number(1, 4).number(0, 4).number(5000, 4).number(3, 4).number(3, 4).bytes(Buffer{1, 2, 3, 0});
  UsbCapture::append(file, low.block(6, second.out));
  UsbCapture::append(file, low.block(3, tests::WireBytes(false).number(2, 4).bytes(Buffer{8, 9, 0, 0}).out));
  UsbCapture::append(file, high.section());
  UsbCapture::append(file, high.described(189));
  UsbCapture::append(file, high.block(3, tests::WireBytes(true).number(4, 4).bytes(Buffer{4, 5, 6, 7}).out));
  const Captured all = read_all(file);
  EXPECT_EQ(all.error, "");
  const std::vector<std::pair<std::int64_t, Buffer>> wanted{{5, {1, 2, 3}}, {5, {8, 9}}, {5, {4, 5, 6, 7}}};
  EXPECT_EQ(all.packets, wanted);
  EXPECT_EQ(all.links, (std::set<std::uint16_t>{1, 189, 220}));
}

TEST(CaptureReader, OfAHugePacketTheFrontIsKept) {
  const UsbCapture capture = some_packets();
  Buffer file = capture.pcap();
  const std::size_t huge = CaptureReader::k_most_of_a_packet + 300'001;
  tests::WireBytes record(false);
  record.number(1'700'000'099, 4).number(7, 4).number(huge, 4).number(huge, 4).zeros(huge);
  file.insert(file.begin() + 24, record.out.begin(), record.out.end());
  const Captured all = read_all(file);
  EXPECT_EQ(all.error, "");
  ASSERT_EQ(all.packets.size(), capture.packets().size() + 1);
  EXPECT_EQ(all.packets[0].second.size(), CaptureReader::k_most_of_a_packet);
  EXPECT_EQ(all.packets[1], capture.packets()[0]);
}

TEST(CaptureReader, AFileThatIsCutGivesItsWholePackets) {
  const UsbCapture capture = some_packets(true);
  for (const Buffer& file : {capture.pcap(), capture.pcapng(), capture.pcapng(6, UsbCapture::Blocks::obsolete)}) {
    std::size_t before = 0;
    for (std::size_t size = 12; size < file.size(); ++size) {
      const Captured all = read_all(Buffer(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)));
      EXPECT_EQ(all.error, "") << size;
      EXPECT_GE(all.packets.size(), before);
      for (std::size_t i = 0; i < all.packets.size(); ++i) EXPECT_EQ(all.packets[i], capture.packets()[i]);
      before = all.packets.size();
    }
    // The last one is whole only with the file's last byte, or with the length behind its block.
    EXPECT_GE(before + 1, capture.packets().size());
  }
}

TEST(CaptureReader, DamageIsNamedWithItsPlace) {
  const UsbCapture parts;
  const auto error_of = [](const Buffer& file) { return read_all(file).error; };
  const auto with = [&](const Buffer& block) {
    Buffer file = parts.section();
    UsbCapture::append(file, parts.described(220));
    UsbCapture::append(file, block);
    return file;
  };
  const std::string place = "byte " + std::to_string(with({}).size());
  const std::string remedy = "; capture it again";
  tests::WireBytes large(false);
  large.number(0, 4).zeros(8).number(400, 4).number(400, 4).zeros(8);
  EXPECT_EQ(error_of(with(parts.block(6, large.out))),
            place + ": the capture is damaged: a packet larger than its block" + remedy);
  EXPECT_EQ(error_of(with(parts.block(6, Buffer(16)))),
            place + ": the capture is damaged: a packet's block of 28 bytes" + remedy);
  tests::WireBytes other(false);
  other.number(1, 4).zeros(16);
  EXPECT_EQ(error_of(with(parts.block(6, other.out))),
            place + ": the capture is damaged: a packet of an interface that is not described" + remedy);
  Buffer two = parts.block(5, Buffer(8));
  two.back() = 1;
  EXPECT_EQ(error_of(with(two)), place + ": the capture is damaged: a block with two lengths" + remedy);
  Buffer odd = parts.block(5, Buffer(8));
  odd[4] = 9;
  EXPECT_EQ(error_of(with(odd)), place + ": the capture is damaged: a block of 9 bytes" + remedy);
  Buffer newer = parts.section();
  newer[12] = 2;
  EXPECT_EQ(error_of(newer), "byte 0: is a capture of pcapng's version 2; save it in version 1");
  Buffer pcap = parts.pcap();
  tests::WireBytes record(false);
  UsbCapture::append(pcap, record.zeros(8).number(0x10000000, 4).zeros(4).out);
  EXPECT_EQ(error_of(pcap), "byte 24: the capture is damaged: a packet of 268435456 bytes" + remedy);
  EXPECT_FALSE(CaptureReader::recognises(base::as_bytes("D: 0\nR: 0\n")));
  EXPECT_FALSE(CaptureReader::recognises({}));
  EXPECT_EQ(error_of({1, 2, 3}), "is no capture file; give a file of type pcap or pcapng");
}

TEST(CaptureReader, ErrorsOfReadingComeOut) {
  CaptureReader reader([](std::span<std::uint8_t>) -> base::Result<std::size_t> {
    return base::Error{"broke", "", ""};
  });
  const auto packet = reader.next();
  ASSERT_FALSE(packet);
  EXPECT_EQ(packet.error().what, "broke");
}

}  // namespace
}  // namespace penpose::replay
