#include "replay/trace/trace_line.h"

#include <gtest/gtest.h>

namespace penpose::replay {
namespace {

class Parsed {
 public:
  explicit Parsed(std::string_view text) : line_(parse_trace_line(text, bytes_)) {}
  const TraceLine* operator->() const { return &line_; }

 private:
  std::vector<std::uint8_t> bytes_;
  TraceLine line_;
};

TEST(TraceLine, ReadsEveryKind) {
  EXPECT_EQ(Parsed("D: 3")->device, 3);
  EXPECT_EQ(Parsed("D:12")->device, 12);
  EXPECT_EQ(Parsed("D:12")->kind, TraceLineKind::device);
  const Parsed descriptor("R: 3 05 0D ff");
  ASSERT_EQ(descriptor->kind, TraceLineKind::descriptor);
  EXPECT_EQ(descriptor->bytes[1], 0x0d);
  EXPECT_EQ(Parsed("N: A pen  ")->value, "A pen");
  EXPECT_EQ(Parsed("P: usb-1/input0")->kind, TraceLineKind::physical);
  const Parsed identity("I: 3 056A 0013");
  EXPECT_EQ(identity->vendor, 0x056a);
  EXPECT_EQ(identity->product, 0x0013);
  EXPECT_EQ(identity->bus, 3);
}

TEST(TraceLine, ReadsBothStylesOfNumbers) {
  const Parsed plain("E: 2.352052 2 02 d0");
  ASSERT_EQ(plain->kind, TraceLineKind::report);
  EXPECT_EQ(plain->time_us, 2352052);
  EXPECT_EQ(plain->bytes.size(), 2u);
  EXPECT_EQ(Parsed("E: 000002.352052 2 02 d0")->time_us, 2352052);
  EXPECT_EQ(Parsed("E: 2.5 1 00")->time_us, 2500000);
  EXPECT_EQ(Parsed("E: 7 1 00")->time_us, 7000000);
}

TEST(TraceLine, AnythingElseIsALineOfItsOwn) {
  for (const char* text : {"", "E", "# comment", "   - land a second finger", "X: 1", "Name: x"}) {
    EXPECT_EQ(Parsed(text)->kind, TraceLineKind::other) << text;
    EXPECT_TRUE(Parsed(text)->problem.empty()) << text;
  }
}

TEST(TraceLine, SaysWhatIsWrong) {
  for (const char* text : {"D: x", "D: 1 2", "D: 99999", "R: ", "R: 3 05 0d", "R: 1 05 0d", "R: 1 5", "R: 1 0g",
                           "R: 70000 00", "I: 3 056a", "I: 3 056a 12345678", "E: x 1 00", "E: 1.5x 1 00", "E: 1.0",
                           "E: 1.0 2 00", "E: 99999999999999999 1 00"}) {
    EXPECT_EQ(Parsed(text)->kind, TraceLineKind::other) << text;
    EXPECT_FALSE(Parsed(text)->problem.empty()) << text;
  }
}

TEST(TraceLine, WritesAsHidRecorderDoes) {
  std::string out;
  const std::vector<std::uint8_t> report{0x02, 0xd0};
  append_comment(out, "made\nby a test");
  append_device(out, 0);
  append_descriptor(out, report);
  append_name(out, "A pen\r\nE: 0.0 1 00");
  append_physical(out, "usb-1/input0");
  append_identity(out, 3, 0x056a, 0x13);
  append_report(out, 12000345, report);
  EXPECT_EQ(out,
            "# made by a test\nD: 0\nR: 2 02 d0\nN: A pen\nP: usb-1/input0\nI: 3 056a 0013\nE: 12.000345 2 02 d0\n");
}

TEST(TraceLine, WritesTheOtherStyle) {
  const TraceStyle style{false, true, 6, true};
  std::string out;
  append_device(out, 1, style);
  append_identity(out, 0x18, 0x056a, 0xabcd, style);
  append_report(out, 1000001, std::vector<std::uint8_t>{0xab}, style);
  EXPECT_EQ(out, "D:1\r\nI: 18 056A ABCD\r\nE: 000001.000001 1 ab\r\n");
}

}  // namespace
}  // namespace penpose::replay
