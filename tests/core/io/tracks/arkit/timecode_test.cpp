#include "core/io/tracks/arkit/timecode.h"

#include <gtest/gtest.h>

namespace penpose::io {
namespace {

std::vector<Timecode> codes(double count, double step, std::size_t frames) {
  std::vector<Timecode> all;
  for (std::size_t f = 0; f < frames; ++f) {
    const double at = static_cast<double>(f) * step;
    const double whole = static_cast<double>(static_cast<int>(at / count));
    all.push_back({100 + whole, at - whole * count});
  }
  return all;
}

TEST(Timecode, IsReadAndWritten) {
  const auto code = parse_timecode(" 01:02:03:04.5").value();
  EXPECT_EQ(code.whole_s, 3723);
  EXPECT_EQ(code.frames, 4.5);
  EXPECT_TRUE(parse_timecode("01:02:03;04"));
  for (const char* text : {"", "1:2", "a:b:c:d", "-1:0:0:0", "nan:0:0:0"}) EXPECT_FALSE(parse_timecode(text)) << text;
  EXPECT_EQ(format_timecode(3723 + 4.5 / 60, 60), "01:02:03:04.500");
  EXPECT_EQ(format_timecode(0.9999999, 30), "00:00:01:00.000");
  EXPECT_EQ(format_timecode(100 / 29.97, 30), "00:00:03:10.100");
}

TEST(Timecode, CountsWhatVideoCounts) {
  EXPECT_EQ(timecode_count(23.976), 24);
  EXPECT_EQ(timecode_count(25), 25);
  EXPECT_EQ(timecode_count(29.97), 30);
  EXPECT_EQ(timecode_count(59.94), 60);
  EXPECT_EQ(timecode_count(10), 60);
  EXPECT_EQ(timecode_count(120), 60);
}

TEST(Timecode, TheBeginOfASecondTellsTheRate) {
  for (const double count : {24.0, 25.0, 30.0, 50.0, 60.0}) {
    const auto rate = counted_rate(codes(count, 1, 2 * static_cast<std::size_t>(count)));
    EXPECT_EQ(rate.count, count);
    EXPECT_TRUE(rate.told);
  }
  // Ten frames a second, of which the highest count is 48 or 54.
  EXPECT_EQ(counted_rate(codes(60, 12, 20)).count, 60);
  EXPECT_EQ(counted_rate(codes(60, 6, 20)).count, 60);
}

TEST(Timecode, AShortTakeIsToldByItsStepsOrTakenAs60) {
  const auto plain = counted_rate(codes(60, 1, 20));
  EXPECT_EQ(plain.count, 60);
  EXPECT_FALSE(plain.told);
  const auto halves = counted_rate(codes(30, 0.5, 20));
  EXPECT_EQ(halves.count, 30);
  EXPECT_TRUE(halves.told);
  EXPECT_EQ(counted_rate(codes(24, 0.4, 20)).count, 24);
  EXPECT_TRUE(counted_rate(codes(60, 1, 55)).told);
  EXPECT_EQ(counted_rate({}).count, 60);
  EXPECT_GT(counted_rate(std::vector<Timecode>{{0, 99}, {0, 100}}).count, 100);
}

TEST(Timecode, OfDropFrameNumbersAreLeftOutAndNoFrameIs) {
  // 00:00:59;29 is followed by 00:01:00;02, and at each tenth minute nothing is left out.
  const auto at = [](const char* text, double count) { return seconds_of(parse_timecode(text).value(), count, true); };
  const double frame = 1001 / 30000.0;
  EXPECT_NEAR(at("00:01:00;02", 30) - at("00:00:59;29", 30), frame, 1e-9);
  EXPECT_NEAR(at("00:10:00;00", 30) - at("00:09:59;29", 30), frame, 1e-9);
  EXPECT_NEAR(at("01:00:00;00", 30), 107892 * frame, 1e-6);
  EXPECT_NEAR(at("00:01:00;04", 60) - at("00:00:59;59", 60), frame / 2, 1e-9);
  const std::vector<Timecode> codes{parse_timecode("00:00:59;28").value(), parse_timecode("00:00:59;29").value(),
                                    parse_timecode("00:01:00;02").value(), parse_timecode("00:01:00;03").value()};
  EXPECT_EQ(counted_rate(codes).count, 30);
  EXPECT_TRUE(leaves_out_numbers(codes, 30));
  const std::vector<Timecode> whole{parse_timecode("00:00:59;29").value(), parse_timecode("00:01:00;00").value()};
  EXPECT_FALSE(leaves_out_numbers(whole, 30));
  EXPECT_FALSE(leaves_out_numbers(codes, 25));
}

TEST(Timecode, IsReadWithPointsAndCommas) {
  for (const char* text : {"00:00:58;20", "00:00:58.20", "00.00.58.20", "00;00;58;20"}) {
    const auto code = parse_timecode(text);
    ASSERT_TRUE(code) << text;
    EXPECT_EQ(code->whole_s, 58) << text;
    EXPECT_EQ(code->frames, 20) << text;
    EXPECT_TRUE(code->drops) << text;
  }
  EXPECT_EQ(parse_timecode("01:02:03:04,5")->frames, 4.5);
  EXPECT_NEAR(*parse_timecode("0:00:58.250")->fraction_s, 0.25, 1e-12);
  EXPECT_EQ(parse_timecode("1:02,125")->whole_s, 62);
  for (const char* text : {"0.5", "12", "1:2:3:4:5", "1.2.3", "::.", "1:2:3:", "9999:0:0:0"}) {
    EXPECT_FALSE(parse_timecode(text)) << text;
  }
}

}  // namespace
}  // namespace penpose::io
