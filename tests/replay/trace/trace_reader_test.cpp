#include "replay/trace/trace_reader.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/shared_data.h"
#include "tests/support/trace_reports.h"

namespace penpose::replay {
namespace {

struct ReadBack {
  std::string text;
  std::vector<TraceLineKind> kinds;
  std::uint64_t last_number = 0;
  std::string cut;
  TraceStyle style;
};

ReadBack read_all(base::Bytes bytes, std::size_t piece = 1 << 20) {
  TraceReader reader(tests::in_pieces(bytes, piece));
  ReadBack back;
  for (;;) {
    const auto line = reader.next();
    EXPECT_TRUE(line.ok());
    if (!line || !line->has_value()) break;
    append_line(back.text, **line);
    back.kinds.push_back((*line)->kind);
    back.last_number = (*line)->number;
  }
  if (reader.cut()) back.cut = reader.cut()->place;
  back.style = reader.style();
  return back;
}

const std::string k_trace =
    "# a comment\r\nD:0\nR: 1 05\nN: Pen\n\n   a remark\nI: 3 056A 0013\nE: 000000.000000 2 01 02\r\nE: broken\n";

TEST(TraceReader, WritesBackEveryByte) {
  for (const std::size_t piece : {1u, 2u, 7u, 1000u}) {
    const ReadBack back = read_all(base::as_bytes(k_trace), piece);
    EXPECT_EQ(back.text, k_trace);
    EXPECT_EQ(back.last_number, 9u);
    EXPECT_TRUE(back.cut.empty());
  }
}

TEST(TraceReader, NotesTheStyle) {
  const ReadBack back = read_all(base::as_bytes(k_trace));
  EXPECT_FALSE(back.style.blank_after_device);
  EXPECT_TRUE(back.style.upper_case_ids);
  EXPECT_TRUE(back.style.carriage_return);
  EXPECT_EQ(back.style.second_digits, 6);
}

TEST(TraceReader, ACutLineIsToldAndTheRestIsRead) {
  const std::string whole = "D: 0\nE: 0.000000 2 01 02\nE: 0.008000 2 01 02";
  EXPECT_TRUE(read_all(base::as_bytes(whole)).cut.empty()) << "only the line end is missing";
  for (std::size_t missing = 1; missing < 17; ++missing) {
    const std::string cut = whole.substr(0, whole.size() - missing);
    const ReadBack back = read_all(base::as_bytes(cut));
    EXPECT_EQ(back.cut, "line 3") << cut;
    EXPECT_EQ(back.text, cut);
    ASSERT_GE(back.kinds.size(), 2u);
    EXPECT_EQ(back.kinds[1], TraceLineKind::report);
  }
}

TEST(TraceReader, LongLinesComeInPieces) {
  for (const std::size_t extra : {0u, 1u, 2u, 3u, 1000000u}) {
    const std::string text = "# " + std::string(TraceReader::k_longest_line - 2 + extra, 'x') + "\nE: 0.000000 1 00\n";
    for (const std::size_t piece : {4096u, 262145u}) {
      const ReadBack back = read_all(base::as_bytes(text), piece);
      EXPECT_EQ(back.text, text);
      EXPECT_EQ(back.last_number, 2u);
      EXPECT_EQ(back.kinds.back(), TraceLineKind::report);
      EXPECT_EQ(std::count(back.kinds.begin(), back.kinds.end(), TraceLineKind::report), 1);
    }
  }
}

TEST(TraceReader, WhatHasNoLinesIsNoTraceAndIsNotReadToItsEnd) {
  std::size_t given = 0;
  TraceReader reader([&](std::span<std::uint8_t> into) -> base::Result<std::size_t> {
    std::fill(into.begin(), into.end(), std::uint8_t{0});
    given += into.size();
    return into.size();
  });
  for (;;) {
    const auto line = reader.next();
    if (line) {
      ASSERT_TRUE(line->has_value());
      ASSERT_LE(given, 2 * TraceReader::k_most_of_a_line);
      continue;
    }
    EXPECT_EQ(line.error().place, "line 1");
    EXPECT_FALSE(line.error().remedy.empty());
    break;
  }
}

TEST(TraceReader, ReadsADescriptorOf64KiB) {
  std::string text = "R: 65536";
  for (int i = 0; i < 65536; ++i) text += " a4";
  const ReadBack back = read_all(base::as_bytes(text + "\n"));
  EXPECT_EQ(back.kinds.front(), TraceLineKind::descriptor);
}

TEST(TraceReader, AnEmptyFileHasNoLines) { EXPECT_TRUE(read_all({}).kinds.empty()); }

TEST(TraceReader, PassesOnErrorsOfReading) {
  TraceReader reader([](std::span<std::uint8_t>) -> base::Result<std::size_t> {
    return base::Error{"cannot be read", "", ""};
  });
  EXPECT_FALSE(reader.next());
}

TEST(SharedTraces, AreWrittenBackEveryByte) {
  if (!tests::has_shared()) GTEST_SKIP() << "no shared data";
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(tests::shared_dir() / "hid")) {
    if (entry.path().extension() != ".hid") continue;
    const auto bytes = tests::read_file(entry.path());
    EXPECT_TRUE(read_all(bytes).text == base::as_text(bytes)) << entry.path();
    ++files;
  }
  EXPECT_GT(files, 0u);
}

TEST(SharedTraces, TheWriterMakesTheSameReportLines) {
  if (!tests::has_shared()) GTEST_SKIP() << "no shared data";
  for (const auto& entry : std::filesystem::directory_iterator(tests::shared_dir() / "hid")) {
    if (entry.path().extension() != ".hid") continue;
    const auto bytes = tests::read_file(entry.path());
    TraceReader reader(read_from(bytes));
    for (auto line = reader.next(); line && line->has_value(); line = reader.next()) {
      std::string again;
      if ((*line)->kind == TraceLineKind::report) {
        append_report(again, (*line)->time_us, (*line)->bytes, reader.style());
      } else if ((*line)->kind == TraceLineKind::descriptor) {
        append_descriptor(again, (*line)->bytes, reader.style());
      } else if ((*line)->kind == TraceLineKind::identity) {
        append_identity(again, (*line)->bus, (*line)->vendor, (*line)->product, reader.style());
      } else {
        continue;
      }
      std::string wanted;
      append_line(wanted, **line);
      // Some recordings have a blank at the end of their descriptor.
      EXPECT_EQ(again, wanted) << entry.path() << " line " << (*line)->number;
    }
  }
}

}  // namespace
}  // namespace penpose::replay
