// A known pen path written as every maker's reports and decoded again. The writers are the size of this file: one for
// each way of laying out a report, and none of them knows the program's layouts.

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <initializer_list>
#include <string>
#include <vector>

#include "firmware_io/decode/layout/protocol.h"

namespace penpose::decode {
namespace {

using Report = std::vector<std::uint8_t>;

/// What a pen does at one moment, and what of it a protocol can say.
struct Pen {
  std::int32_t x = 0, y = 0;
  std::int32_t pressure = 0;
  std::int32_t tilt_x = 0, tilt_y = 0;
  std::uint32_t buttons = 0;
  bool eraser = false;
};

/// Bytes of a report, written field by field as the makers' reports are described, without the layouts of the program.
class Writer {
 public:
  Writer(std::size_t length, std::initializer_list<int> head) : bytes_(length, 0) {
    std::size_t at = 0;
    for (const int byte : head) bytes_[at++] = static_cast<std::uint8_t>(byte);
  }
  Writer& u8(std::size_t at, std::int64_t value) {
    bytes_[at] = static_cast<std::uint8_t>(bytes_[at] | (value & 0xff));
    return *this;
  }
  Writer& u16(std::size_t at, std::int64_t value) { return u8(at, value).u8(at + 1, value >> 8); }
  Writer& u24(std::size_t at, std::int64_t value) { return u16(at, value).u8(at + 2, value >> 16); }
  Writer& bit(std::size_t at, int bit, bool set) { return u8(at, set ? 1 << bit : 0); }
  Writer& buttons(std::size_t at, int bit, const Pen& pen) {
    return u8(at, static_cast<std::int64_t>(pen.buttons) << bit);
  }
  /// Place and pressure, two bytes each.
  Writer& place(std::size_t at, const Pen& pen) { return u16(at, pen.x).u16(at + 2, pen.y).u16(at + 4, pen.pressure); }
  Writer& tilts(std::size_t at, const Pen& pen) { return u8(at, pen.tilt_x).u8(at + 1, pen.tilt_y); }
  [[nodiscard]] Report done() const { return bytes_; }

 private:
  Report bytes_;
};

struct Maker {
  const char* protocol;
  int coordinate_bits;
  std::int32_t most_pressure;
  int button_count;
  bool tilt;
  bool eraser;
  std::function<Report(const Pen&)> write;
};

Report flat(std::size_t length, int id, int state, const Pen& pen) {
  return Writer(length, {id, state}).place(2, pen).buttons(1, 1, pen).bit(1, 0, pen.pressure > 0).done();
}
Report flat_tilt(int id, int state, const Pen& pen, int sign_x, int sign_y) {
  return Writer(12, {id, state})
      .place(2, pen)
      .buttons(1, 1, pen)
      .bit(1, 0, pen.pressure > 0)
      .u8(10, sign_x * pen.tilt_x)
      .u8(11, sign_y * pen.tilt_y)
      .done();
}
Report xp(std::size_t length, int pressure_extra, const Pen& pen) {
  Writer report(length, {0x02, 0xa0});
  report.place(2, pen).u8(7, pressure_extra).buttons(1, 1, pen);
  report.bit(1, 0, pen.pressure > 0).bit(1, 3, pen.eraser).tilts(8, pen);
  if (length >= 12) report.u8(10, pen.x >> 16).u8(11, pen.y >> 16);
  return report.done();
}
Report big_endian(int id, const Pen& pen) {
  return Writer(10, {id, 0xe0})
      .u8(2, pen.x >> 9)
      .u8(3, pen.x >> 1)
      .u8(4, pen.y >> 9)
      .u8(5, pen.y >> 1)
      .u8(9, (pen.x & 1) << 1 | (pen.y & 1))
      .u8(1, pen.pressure & 1)
      .u8(7, (pen.pressure >> 1 & 3) << 6)
      .u8(6, pen.pressure >> 3)
      .u8(7, (pen.tilt_x + 64) >> 1)
      .u8(8, ((pen.tilt_x + 64) & 1) << 7 | (pen.tilt_y + 64))
      .buttons(1, 1, pen)
      .done();
}
Report bamboo(const Pen& pen) {
  return Writer(9, {0x02, 0x80})
      .place(2, pen)
      .bit(1, 0, pen.pressure > 0)
      .buttons(1, 1, pen)
      .bit(1, 5, pen.eraser)
      .done();
}
Report wacom_1e(const Pen& pen) {
  return Writer(32, {0x1e, 0x01, 0xc0})
      .u24(3, pen.x)
      .u24(6, pen.y)
      .u16(9, pen.pressure)
      .u16(11, pen.tilt_x)
      .u16(13, pen.tilt_y)
      .bit(2, 0, pen.pressure > 0)
      .buttons(2, 1, pen)
      .bit(2, 5, pen.eraser)
      .done();
}
Report wacom_pl(const Pen& pen) {
  const int raw = pen.pressure ^ 0x100;
  return Writer(8, {0x02, 0xe0})
      .u8(1, pen.x >> 14)
      .u8(2, pen.x >> 7 & 0x7f)
      .u8(3, pen.x & 0x7f)
      .u8(4, pen.y >> 14)
      .u8(5, pen.y >> 7 & 0x7f)
      .u8(6, pen.y & 0x7f)
      .u8(7, raw >> 2)
      .bit(4, 6, (raw & 2) != 0)
      .bit(4, 2, (raw & 1) != 0)
      .bit(4, 3, pen.pressure > 0)
      .bit(4, 4, (pen.buttons & 1) != 0)
      .done();
}

const std::vector<Maker>& makers() {
  static const std::vector<Maker> list{
      {"generic", 16, 8191, 3, false, false, [](const Pen& pen) { return flat(8, 8, 0x80, pen); }},
      {"generic_skip1", 16, 8191, 3, false, false,
       [](const Pen& pen) {
         auto report = flat(8, 8, 0x80, pen);
         report.insert(report.begin(), 0x55);
         return report;
       }},
      {"uclogic", 16, 8191, 3, false, false, [](const Pen& pen) { return flat(8, 7, 0x80, pen); }},
      {"uclogic_tilt", 16, 16383, 3, true, false, [](const Pen& pen) { return flat_tilt(8, 0x80, pen, 1, -1); }},
      {"uclogic_v1", 16, 2047, 3, false, false, [](const Pen& pen) { return flat(8, 7, 0x40, pen); }},
      {"uclogic_v2", 16, 16383, 3, true, false, [](const Pen& pen) { return flat_tilt(8, 0x80, pen, 1, 1); }},
      {"huion_ring", 16, 8191, 3, true, false, [](const Pen& pen) { return flat_tilt(8, 0x80, pen, 1, 1); }},
      {"huion_inspiroy", 16, 16383, 3, true, false, [](const Pen& pen) { return flat_tilt(8, 0x80, pen, 1, 1); }},
      {"huion_giano", 17, 16383, 3, true, false,
       [](const Pen& pen) {
         auto report = flat_tilt(8, 0x80, pen, -1, -1);
         report[8] = static_cast<std::uint8_t>(pen.x >> 16);
         report[9] = static_cast<std::uint8_t>(pen.y >> 16);
         return report;
       }},
      {"xp_pen", 24, 16383, 2, true, true, [](const Pen& pen) { return xp(12, 0, pen); }},
      {"xp_pen_offset_aux", 16, 2047, 2, true, true,
       [](const Pen& pen) {
         auto report = xp(10, 0, pen);
         report[1] = static_cast<std::uint8_t>(report[1] & ~0x20);
         return report;
       }},
      {"xp_pen_offset_pressure", 24, 8191, 2, true, true, [](const Pen& pen) { return xp(12, 0xa0, pen); }},
      {"xp_pen_gen2", 24, 16383, 2, true, true,
       [](const Pen& pen) {
         Pen low = pen;
         low.pressure &= 0x1fff;
         auto report = xp(14, 0, low);
         report[1] = static_cast<std::uint8_t>((report[1] & ~1) | (pen.pressure > 0 ? 1 : 0));
         report[13] = static_cast<std::uint8_t>(pen.pressure >> 13);
         return report;
       }},
      {"veikk", 24, 8191, 2, false, false,
       [](const Pen& pen) {
         return Writer(11, {9, 0x41, 0xa0}).u24(3, pen.x).u24(6, pen.y).u16(9, pen.pressure).buttons(2, 1, pen).done();
       }},
      {"veikk_a15", 16, 8191, 2, false, false,
       [](const Pen& pen) {
         return Writer(9, {9, 0x41, 0xa0}).place(3, pen).buttons(2, 1, pen).done();
       }},
      {"veikk_tilt", 24, 8191, 2, true, false,
       [](const Pen& pen) {
         return Writer(13, {9, 0x41, 0xa0})
             .u24(3, pen.x)
             .u24(6, pen.y)
             .u16(9, pen.pressure)
             .buttons(2, 1, pen)
             .tilts(11, pen)
             .done();
       }},
      {"veikk_v1", 16, 8191, 3, false, false,
       [](const Pen& pen) {
         return Writer(9, {9, 0x41, 0xa0}).place(3, pen).buttons(2, 1, pen).done();
       }},
      {"acepen", 16, 8191, 2, false, false,
       [](const Pen& pen) {
         return Writer(11, {9, 0x41, 0xa0}).place(3, pen).buttons(2, 1, pen).done();
       }},
      {"floogoo_fma", 16, 32767, 2, true, true,
       [](const Pen& pen) {
         return Writer(12, {1, 0x20})
             .place(2, pen)
             .buttons(1, 1, pen)
             .bit(1, 3, pen.eraser)
             .u16(8, pen.tilt_x)
             .u16(10, pen.tilt_y)
             .done();
       }},
      {"genius", 16, 2047, 3, false, false, [](const Pen& pen) { return flat(8, 0x10, 0x80, pen); }},
      {"genius_v2", 16, 1023, 2, false, false,
       [](const Pen& pen) {
         return Writer(8, {2})
             .u16(1, pen.x)
             .u16(3, pen.y)
             .u16(6, pen.pressure)
             .bit(5, 2, pen.pressure > 0)
             .buttons(5, 3, pen)
             .done();
       }},
      {"lifetec", 16, 1023, 2, false, false,
       [](const Pen& pen) {
         return Writer(8, {2}).u16(1, pen.x).u16(3, pen.y).u16(6, pen.pressure).buttons(5, 3, pen).done();
       }},
      {"robotpen", 16, 511, 0, false, false,
       [](const Pen& pen) {
         return Writer(12, {2, 0x42}).place(6, pen).done();
       }},
      {"viewsonic_woodpad", 16, 4095, 2, false, false,
       [](const Pen& pen) {
         return Writer(14, {2})
             .u16(1, pen.x)
             .u16(5, pen.y)
             .u8(9, 3)
             .bit(9, 2, pen.pressure > 0)
             .u16(10, pen.pressure)
             .buttons(9, 3, pen)
             .done();
       }},
      {"xenx", 16, 8191, 2, false, true,
       [](const Pen& pen) {
         return Writer(8, {1, 0x80}).place(2, pen).buttons(1, 1, pen).bit(1, 6, pen.eraser).done();
       }},
      {"xencelabs", 16, 8191, 3, true, true,
       [](const Pen& pen) {
         return Writer(10, {2, 0x20}).place(2, pen).buttons(1, 1, pen).bit(1, 6, pen.eraser).tilts(8, pen).done();
       }},
      {"wacom_intuos", 16, 2047, 2, false, true,
       [](const Pen& pen) {
         auto report = flat(9, 2, 0xe0, pen);
         report[1] = static_cast<std::uint8_t>(report[1] | (pen.eraser ? 8 : 0));
         return report;
       }},
      {"wacom_bamboo", 16, 511, 2, false, true, bamboo},
      {"wacom_graphire", 16, 511, 2, false, true, bamboo},
      {"wacom_bamboo_pad", 16, 511, 1, false, true,
       [](const Pen& pen) {
         return Writer(32, {0x10, 1}).place(3, pen).buttons(2, 1, pen).bit(2, 3, pen.eraser).done();
       }},
      {"wacom_ptu", 16, 511, 1, false, true,
       [](const Pen& pen) {
         return Writer(8, {2, 0x20}).place(2, pen).buttons(1, 1, pen).bit(1, 2, pen.eraser).done();
       }},
      {"wacom_pl", 16, 511, 1, false, false, wacom_pl},
      {"wacom_intuos_v1", 17, 2047, 2, true, false, [](const Pen& pen) { return big_endian(0x02, pen); }},
      {"wacom_intuos_pro", 17, 2047, 2, true, false, [](const Pen& pen) { return big_endian(0x10, pen); }},
      {"wacom_cintiq_v1", 17, 2047, 2, true, false, [](const Pen& pen) { return big_endian(0x02, pen); }},
      {"wacom_intuos4", 17, 2047, 2, true, false, [](const Pen& pen) { return big_endian(0x02, pen); }},
      {"wacom_intuos3", 17, 2047, 2, true, false, [](const Pen& pen) { return big_endian(0x02, pen); }},
      {"wacom_intuos3_extra", 17, 2047, 2, true, false, [](const Pen& pen) { return big_endian(0x02, pen); }},
      {"wacom_intuos_v2", 24, 8191, 2, true, true,
       [](const Pen& pen) {
         return Writer(27, {0x10, 0x60})
             .u24(2, pen.x)
             .u24(5, pen.y)
             .u16(8, pen.pressure)
             .tilts(10, pen)
             .bit(1, 0, pen.pressure > 0)
             .buttons(1, 1, pen)
             .bit(1, 4, pen.eraser)
             .done();
       }},
      {"wacom_intuos_v3", 24, 8191, 3, true, true, wacom_1e},
  };
  return list;
}

/// A spiral over the whole range of a protocol, pressed in its middle third, with buttons and eraser in turn.
Pen pen_at(const Maker& maker, int step) {
  const double turn = step * 0.07;
  const double span = std::ldexp(0.5, maker.coordinate_bits) * (step / 500.0);
  const double middle = std::ldexp(0.5, maker.coordinate_bits);
  Pen pen;
  pen.x = static_cast<std::int32_t>(middle + span * std::cos(turn));
  pen.y = static_cast<std::int32_t>(middle + span * std::sin(turn));
  pen.pressure = step % 9 < 3 ? 0 : step * maker.most_pressure / 499;
  if (maker.tilt) {
    pen.tilt_x = static_cast<std::int32_t>(60 * std::cos(turn));
    pen.tilt_y = static_cast<std::int32_t>(60 * std::sin(turn));
  }
  pen.buttons = static_cast<std::uint32_t>(step) % (1U << maker.button_count);
  pen.eraser = maker.eraser && step / 50 % 2 == 1;
  return pen;
}

TEST(ProtocolRoundTrip, DecodesWhatWasWritten) {
  for (const auto& maker : makers()) {
    SCOPED_TRACE(maker.protocol);
    const auto decoder = make_protocol_decoder(maker.protocol);
    ASSERT_NE(decoder, nullptr);
    EXPECT_EQ(decoder->axes().tilt_x.present, maker.tilt || std::string(maker.protocol) == "acepen" ||
                                                  std::string(maker.protocol) == "viewsonic_woodpad");
    for (int step = 0; step < 500; ++step) {
      const Pen pen = pen_at(maker, step);
      ASSERT_EQ(decoder->decode(maker.write(pen)), ReportKind::pen) << step;
      const auto& sample = decoder->sample();
      ASSERT_TRUE(sample.in_range) << step;
      ASSERT_EQ(sample.x, pen.x) << step;
      ASSERT_EQ(sample.y, pen.y) << step;
      ASSERT_EQ(sample.pressure, pen.pressure) << step;
      ASSERT_EQ(sample.tilt_x, pen.tilt_x) << step;
      ASSERT_EQ(sample.tilt_y, pen.tilt_y) << step;
      ASSERT_EQ(sample.buttons, pen.buttons) << step;
      ASSERT_EQ(sample.tool, pen.eraser ? Tool::eraser : Tool::pen) << step;
      // Pressure up to 21 is a touch or not, whatever the protocol's threshold says.
      ASSERT_FALSE(sample.tip && pen.pressure == 0) << step;
      ASSERT_TRUE(sample.tip || pen.pressure <= 21) << step;
    }
  }
}

}  // namespace
}  // namespace penpose::decode
