#include "core/base/byte_writer.h"

#include <gtest/gtest.h>
#include <limits>

namespace penpose::base {
namespace {

using Buffer = std::vector<std::uint8_t>;

TEST(ByteWriter, WritesLeastSignificantByteFirst) {
  ByteWriter writer;
  writer.write(std::uint8_t{0xFE});
  writer.write(std::uint16_t{0x0102});
  writer.write(std::uint32_t{0xA1B2C3D4});
  writer.write_f32(1.5F);
  EXPECT_EQ(writer.bytes(), (Buffer{0xFE, 0x02, 0x01, 0xD4, 0xC3, 0xB2, 0xA1, 0, 0, 0xC0, 0x3F}));
}

TEST(ByteWriter, WhatItWritesReadsBackEqual) {
  ByteWriter writer;
  writer.write(std::uint64_t{0x0123456789ABCDEF});
  writer.write_f64(-0.1);
  writer.write_f64(std::numeric_limits<double>::denorm_min());
  writer.write_f32(std::numeric_limits<float>::infinity());
  writer.append("glTF");
  ByteReader reader(writer.bytes());
  EXPECT_EQ(reader.read<std::uint64_t>(), 0x0123456789ABCDEFU);
  EXPECT_EQ(reader.read_f64(), -0.1);
  EXPECT_EQ(reader.read_f64(), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(reader.read_f32(), std::numeric_limits<float>::infinity());
  const auto text = reader.take(4);
  ASSERT_TRUE(text);
  EXPECT_EQ(as_text(*text), "glTF");
  EXPECT_TRUE(reader.at_end());
}

TEST(ByteWriter, FillsUpToAMultiple) {
  ByteWriter writer;
  writer.align(4);
  EXPECT_EQ(writer.size(), 0U);
  writer.append("abcde");
  writer.align(4, ' ');
  EXPECT_EQ(as_text(writer.bytes()), "abcde   ");
  writer.align(4, ' ');
  EXPECT_EQ(writer.size(), 8U);
}

TEST(ByteWriter, GivesItsBufferAway) {
  ByteWriter writer;
  writer.append(as_bytes("xy"));
  EXPECT_EQ(writer.take(), (Buffer{'x', 'y'}));
}

}  // namespace
}  // namespace penpose::base
