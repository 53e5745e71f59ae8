#include "core/base/byte_reader.h"

#include <array>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

namespace penpose::base {
namespace {

TEST(ByteReader, ReadsLeastSignificantByteFirst) {
  const std::array<std::uint8_t, 15> bytes{0x11, 0x22, 0x33, 0x78, 0x56, 0x34, 0x12, 1, 2, 3, 4, 5, 6, 7, 0x88};
  ByteReader reader(bytes);
  EXPECT_EQ(reader.read<std::uint8_t>(), 0x11);
  EXPECT_EQ(reader.read<std::uint16_t>(), 0x3322);
  EXPECT_EQ(reader.read<std::uint32_t>(), 0x12345678U);
  EXPECT_EQ(reader.read<std::uint64_t>(), 0x8807060504030201U);
  EXPECT_TRUE(reader.at_end());
}

TEST(ByteReader, ReadsFloats) {
  // IEEE 754: 1.5 is 3FC00000, -2.25 is C002000000000000.
  const std::array<std::uint8_t, 12> bytes{0, 0, 0xC0, 0x3F, 0, 0, 0, 0, 0, 0, 0x02, 0xC0};
  ByteReader reader(bytes);
  EXPECT_EQ(reader.read_f32(), 1.5F);
  EXPECT_EQ(reader.read_f64(), -2.25);
}

TEST(ByteReader, AReadPastTheEndGivesNothingAndMovesNothing) {
  const std::array<std::uint8_t, 3> bytes{1, 2, 3};
  ByteReader reader(bytes);
  EXPECT_FALSE(reader.read<std::uint32_t>());
  EXPECT_FALSE(reader.read_f32());
  EXPECT_FALSE(reader.read_f64());
  EXPECT_FALSE(reader.take(4));
  EXPECT_FALSE(reader.take(std::numeric_limits<std::size_t>::max()));
  EXPECT_EQ(reader.offset(), 0U);
  EXPECT_EQ(reader.read<std::uint16_t>(), 0x0201);
  EXPECT_FALSE(reader.take(std::numeric_limits<std::size_t>::max()));
  EXPECT_EQ(reader.remaining(), 1U);
}

TEST(ByteReader, SeeksWithinItsBytes) {
  const std::array<std::uint8_t, 4> bytes{9, 8, 7, 6};
  ByteReader reader(bytes);
  EXPECT_TRUE(reader.seek(2));
  EXPECT_EQ(reader.read<std::uint8_t>(), 7);
  EXPECT_FALSE(reader.seek(5));
  EXPECT_EQ(reader.offset(), 3U);
  EXPECT_TRUE(reader.seek(4));
  EXPECT_TRUE(reader.at_end());
  EXPECT_TRUE(reader.take(0));
}

TEST(ByteReader, NeverLeavesItsBytes) {
  std::mt19937 random(1);
  const std::vector<std::uint8_t> bytes(64, 0xAB);
  for (int run = 0; run < 200; ++run) {
    const std::size_t size = random() % 64;
    ByteReader reader(Bytes(bytes).first(size));
    for (int i = 0; i < 40; ++i) {
      const std::size_t before = reader.offset();
      const std::size_t count = random() % 16;
      const auto piece = reader.take(count);
      EXPECT_EQ(piece.has_value(), before + count <= size);
      EXPECT_EQ(reader.offset(), piece ? before + count : before);
      EXPECT_LE(reader.offset(), size);
    }
  }
}

TEST(ByteReader, TextAndBytesAreTheSame) {
  EXPECT_EQ(as_text(as_bytes("penpose")), "penpose");
  EXPECT_TRUE(as_bytes("").empty());
}

}  // namespace
}  // namespace penpose::base
