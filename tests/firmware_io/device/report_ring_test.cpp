#include "firmware_io/device/report_ring.h"

#include <gtest/gtest.h>
#include <thread>

namespace penpose::device {
namespace {

std::vector<std::uint8_t> numbered(std::size_t number) {
  std::vector<std::uint8_t> bytes(1 + number % 64, static_cast<std::uint8_t>(number));
  return bytes;
}

TEST(ReportRing, GivesBackWhatWasPutInInOrder) {
  ReportRing ring(1024);
  Record record;
  EXPECT_FALSE(ring.pop(record));
  for (std::size_t i = 0; i < 500; ++i) {
    ASSERT_TRUE(ring.push(RecordKind::report, static_cast<std::int64_t>(i), numbered(i)));
    ASSERT_TRUE(ring.push(RecordKind::note, 7, {}));
    EXPECT_FALSE(ring.empty());
    ASSERT_TRUE(ring.pop(record));
    EXPECT_EQ(record.kind, RecordKind::report);
    EXPECT_EQ(record.time_us, static_cast<std::int64_t>(i));
    EXPECT_EQ(record.bytes, numbered(i));
    ASSERT_TRUE(ring.pop(record));
    EXPECT_EQ(record.kind, RecordKind::note);
    EXPECT_TRUE(record.bytes.empty());
  }
  EXPECT_TRUE(ring.empty());
  EXPECT_EQ(ring.overruns(), 0u);
}

TEST(ReportRing, WhatDoesNotFitIsCountedAndToldWhereItIsMissing) {
  ReportRing ring(256);
  std::size_t fitted = 0;
  while (ring.push(RecordKind::report, 1, numbered(30))) ++fitted;
  ring.push(RecordKind::report, 2, numbered(30));
  EXPECT_GT(fitted, 2u);
  EXPECT_EQ(ring.overruns(), 2u);
  Record record;
  for (std::size_t i = 0; i < fitted; ++i) ASSERT_TRUE(ring.pop(record));
  EXPECT_FALSE(ring.pop(record));
  ASSERT_TRUE(ring.push(RecordKind::report, 3, numbered(5)));
  ASSERT_TRUE(ring.pop(record));
  EXPECT_EQ(record.kind, RecordKind::lost);
  EXPECT_EQ(record.lost, 2u);
  ASSERT_TRUE(ring.pop(record));
  EXPECT_EQ(record.kind, RecordKind::report);
  EXPECT_EQ(record.bytes, numbered(5));
}

TEST(ReportRing, AReportLargerThanTheRingIsLostAndNotTornApart) {
  ReportRing ring(256);
  EXPECT_FALSE(ring.push(RecordKind::report, 1, std::vector<std::uint8_t>(300)));
  EXPECT_EQ(ring.overruns(), 1u);
  Record record;
  EXPECT_FALSE(ring.pop(record));
}

TEST(ReportRing, TwoThreadsPassEveryReportOrCountIt) {
  constexpr std::size_t k_reports = 200000;
  ReportRing ring(4096);
  std::thread producer([&] {
    for (std::size_t i = 0; i < k_reports; ++i) {
      const bool fits = ring.push(RecordKind::report, static_cast<std::int64_t>(i), numbered(i));
      if (!fits || i % 1000 == 0) std::this_thread::yield();
    }
    while (!ring.push(RecordKind::note, 0, {})) std::this_thread::yield();
  });
  Record record;
  std::size_t received = 0;
  std::size_t told = 0;
  std::int64_t next = 0;
  bool right = true;
  for (;;) {
    if (!ring.pop(record)) {
      std::this_thread::yield();
      continue;
    }
    if (record.kind == RecordKind::note) break;
    if (record.kind == RecordKind::lost) {
      told += record.lost;
      continue;
    }
    // Whatever was lost, what comes is whole and its number is explained by what came and what was told.
    right = right && record.bytes == numbered(static_cast<std::size_t>(record.time_us)) && record.time_us >= next;
    next = record.time_us + 1;
    ++received;
  }
  producer.join();
  EXPECT_TRUE(right);
  EXPECT_EQ(told, ring.overruns());
  EXPECT_EQ(received + told, k_reports);
}

}  // namespace
}  // namespace penpose::device
