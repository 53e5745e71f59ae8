#include "replay/recording/recording.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "tests/support/hands/trace_text.h"
#include "tests/support/trace_reports.h"

namespace penpose::replay {
namespace {

/// What comes out, or the line of the error.
std::string read_all(std::string_view file, std::size_t piece = 4096) {
  const ReadBytes read = read_recording(tests::in_pieces(base::as_bytes(file), piece));
  std::string out;
  std::vector<std::uint8_t> buffer(700);
  for (;;) {
    const auto got = read(buffer);
    if (!got) return got.error().line();
    if (*got == 0) return out;
    out += base::as_text(base::Bytes(buffer).first(*got));
  }
}

std::string packed(std::string_view text) {
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::vector<std::uint8_t> in(text.begin(), text.end());
  std::vector<std::uint8_t> out(deflateBound(&stream, static_cast<uLong>(text.size())) + 64);
  stream.next_in = in.data();
  stream.avail_in = static_cast<uInt>(in.size());
  stream.next_out = out.data();
  stream.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return {out.begin(), out.end()};
}

std::string utf16(std::string_view text, bool little) {
  std::string out = little ? "\xff\xfe" : "\xfe\xff";
  for (const char c : text) {
    if (!little) out += '\0';
    out += c;
    if (little) out += '\0';
  }
  return out;
}

/// Each line between two texts.
std::string around(const std::string& text, const std::string& before, const std::string& after) {
  std::string out;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    out += before + std::string(rest.substr(0, end)) + after + '\n';
    rest.remove_prefix(end + 1);
  }
  return out;
}

std::string trace() {
  return tests::TraceText().device(0, {0x05, 0x0d, 0xc0}, "3 256c 006e").report(0, {1, 2}).report(5, {1, 3}).text();
}

TEST(Recording, ATracePassesByteByByte) {
  const std::string traces[] = {trace(),
                                "",
                                "\n",
                                "E: 0.000000 1 00",
                                "\r\n# x\r\nE: 0.000000 1 00\r\n",
                                "hello",
                                std::string(100000, 'x'),
                                "# penpose session edition=1\n  E: 0.000000 1 00\n> E: 0.000001 1 00\n" + trace(),
                                "# > E: 0.000000 1 00\n" + trace() + std::string("\x1b[31m# red\x1b[0m\n")};
  for (const std::string& text : traces) EXPECT_EQ(read_all(text), text);
  EXPECT_EQ(read_all(trace(), 1), trace());
}

TEST(Recording, ColoursIndentationQuotesAndCarriageReturnsComeOff) {
  EXPECT_EQ(read_all(around(trace(), "\x1b[31m", "\x1b[39m")), trace());
  EXPECT_EQ(read_all(around(trace(), "\x1b[1;38;5;12m", "\x1b[0m\r\r")), trace());
  EXPECT_EQ(read_all(around(trace(), "    ", "")), trace());
  EXPECT_EQ(read_all(around(trace(), "> >\t> ", "\r")), trace());
  EXPECT_EQ(read_all(around(trace(), "\xC2\xA0\xC2\xA0", "")), trace());
  EXPECT_EQ(read_all("\xEF\xBB\xBF" + trace()), trace());
  // A window's title and what a prompt wrote before the line was begun again.
  EXPECT_EQ(read_all(around(trace(), "\x1b]0;me: ~\x07Recording...\r\x1b[K", "")), trace());
}

TEST(Recording, ColourOfTheReportsAloneComesOffToo) {
  const std::string text = "R: 1 c0\nI: 3 256c 006e\n\x1b[31mE: 0.000000 1 07\x1b[39m\n";
  EXPECT_EQ(read_all(text), "R: 1 c0\nI: 3 256c 006e\nE: 0.000000 1 07\n");
}

TEST(Recording, PowerShellsTextIsRead) {
  EXPECT_EQ(read_all(utf16(trace(), true)), trace());
  EXPECT_EQ(read_all(utf16(trace(), false), 3), trace());
  EXPECT_EQ(read_all(utf16(around(trace(), "> ", "\r"), true)), trace());
  // A pair, one half of a pair, and a byte too many.
  const std::string odd("\xff\xfeN\0:\0\x3d\xd8\x0a\xde\x3d\xd8 \0x", 15);
  EXPECT_EQ(read_all(odd), "N:\xF0\x9F\x98\x8A\xEF\xBF\xBD ");
}

TEST(Recording, GzipIsUnpacked) {
  EXPECT_EQ(read_all(packed(trace())), trace());
  EXPECT_EQ(read_all(packed(trace()) + packed("# more\n") + std::string(512, '\0'), 7), trace() + "# more\n");
  EXPECT_EQ(read_all(packed(utf16(around(trace(), "> ", "\r"), true))), trace());
}

TEST(Recording, DamagedGzipSaysWhere) {
  std::string cut = packed(trace());
  cut.resize(cut.size() - 10);
  EXPECT_NE(read_all(cut).find("ends in the middle"), std::string::npos);
  std::string damaged = packed(trace());
  damaged[14] = static_cast<char>(damaged[14] ^ 0x55);
  EXPECT_NE(read_all(damaged).find("byte offset"), std::string::npos) << read_all(damaged);
  EXPECT_NE(read_all(packed(packed(trace()))).find("wrapped in gzip twice"), std::string::npos);
}

TEST(Recording, ABombIsLeftPacked) {
  const std::string bomb = packed(std::string(std::size_t{20} << 20, '\n'));
  EXPECT_LT(bomb.size(), std::size_t{1} << 16);
  EXPECT_NE(read_all(bomb).find("unpacks to more than"), std::string::npos);
}

TEST(Recording, WhatCannotBeReadIsNamedWithARemedy) {
  const std::pair<const char*, const char*> known[] = {
      {"# libinput record\nversion: 1\n", "libinput"},
      {"-event5   DEVICE_ADDED            Wacom Pen   seat0 default group1\n", "libinput"},
      {"Event: time 12.000345, type 3 (EV_ABS), code 0 (ABS_X), value 12\n", "evtest"},
      {"Frame 1: 91 bytes on wire (728 bits), 91 bytes captured\n", "Wireshark"},
      {"ffff8801 12 C Ii:1:003:1 0:1 8 = 0280\n", "usbmon"},
      {"Type,Seq,Time,Elapsed,Duration,Request,Request Details,Raw Data\n", "USBlyzer"},
      {"{\n  \"App Version\": \"OpenTabletDriver v0.6.0.4\",\n", "OpenTabletDriver's diagnostics"},
  };
  for (const auto& [text, name] : known) {
    EXPECT_NE(read_all(text).find(name), std::string::npos) << read_all(text);
    EXPECT_NE(read_all(text).find(';'), std::string::npos) << "no remedy: " << read_all(text);
    // A trace in which somebody quotes such a line is a trace.
    const std::string quoted = trace() + text;
    EXPECT_EQ(read_all(quoted), quoted);
  }
}

TEST(Recording, ErrorsOfReadingComeThrough) {
  const ReadBytes read = read_recording([](std::span<std::uint8_t>) -> base::Result<std::size_t> {
    return base::Error{"cannot be read", "", ""};
  });
  std::vector<std::uint8_t> buffer(10);
  for (int i = 0; i < 2; ++i) {
    const auto got = read(buffer);
    ASSERT_FALSE(got);
    EXPECT_EQ(got.error().what, "cannot be read");
  }
}

}  // namespace
}  // namespace penpose::replay
