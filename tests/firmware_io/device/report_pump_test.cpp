#include "firmware_io/device/report_pump.h"

#include <chrono>
#include <gtest/gtest.h>
#include <thread>

#include "firmware_io/device/queue_gauge.h"
#include "tests/support/hands/fake_source.h"

namespace penpose::device {
namespace {

constexpr int k_patience_ms = 10000;

class ReportPumpTest : public testing::Test {
 protected:
  std::unique_ptr<ReportPump> start(ReportPump::Options options = {}) {
    return std::make_unique<ReportPump>(std::make_unique<tests::FakeSource>(tablet_), std::move(options));
  }
  /// The next record; a note "none" when none comes.
  static Record next(ReportPump& pump) {
    Record record;
    while (!pump.take(record)) {
      const bool gone = pump.gone();
      if (pump.take(record)) break;
      if (gone || !pump.wait(k_patience_ms)) return {RecordKind::note, 0, 0, {'n', 'o', 'n', 'e'}};
    }
    return record;
  }
  static std::string text(const Record& record) { return std::string(base::as_text(record.bytes)); }

  std::shared_ptr<tests::FakeTablet> tablet_ = std::make_shared<tests::FakeTablet>();
};

WakeUp huion_like() { return {{200}, {{0x02, 0x02}, {0x04, 0x00}}, {{0x02, 0xb0, 0x04}}, 30}; }

TEST_F(ReportPumpTest, PassesReportsWithTheirTimes) {
  auto pump = start();
  const std::int64_t before = monotonic_us();
  for (std::uint8_t i = 0; i < 100; ++i) tablet_->send({7, i});
  std::int64_t last = before;
  for (std::uint8_t i = 0; i < 100; ++i) {
    const Record record = next(*pump);
    ASSERT_EQ(record.kind, RecordKind::report);
    EXPECT_EQ(record.bytes, (std::vector<std::uint8_t>{7, i}));
    EXPECT_GE(record.time_us, last);
    last = record.time_us;
  }
  EXPECT_LE(last, monotonic_us());
  EXPECT_EQ(pump->received(), 100u);
  EXPECT_FALSE(pump->wait(0));
}

TEST_F(ReportPumpTest, WakesTheTabletInOrderAndTellsIt) {
  std::vector<int> waits;
  ReportPump::Options options;
  options.wake_up = huion_like();
  options.wait = [&waits](int ms) { waits.push_back(ms); };
  auto pump = start(std::move(options));
  EXPECT_EQ(text(next(*pump)), "wake string 200: \"answer\"");
  EXPECT_EQ(text(next(*pump)), "wake feature 02 02: sent");
  EXPECT_EQ(text(next(*pump)), "wake feature 04 00: sent");
  EXPECT_EQ(text(next(*pump)), "wake output 02 b0 04: sent");
  EXPECT_EQ(tablet_->all_asked(),
            (std::vector<std::string>{"string 200", "feature 0202", "feature 0400", "output 02b004"}));
  pump.reset();
  EXPECT_EQ(waits, (std::vector<int>{30, 30})) << "before each feature report";
}

TEST_F(ReportPumpTest, ATabletThatIsAskedFirstIsNotToldWhatItSaysItself) {
  ReportPump::Options options;
  options.wake_up.send_features = {{0x02, 0x02}};
  options.wake_up.ask_first = true;
  tablet_->feature = {0x00, 0x02};
  auto pump = start(options);
  EXPECT_EQ(text(next(*pump)), "wake feature 02 02: is set");
  pump.reset();
  for (const auto& answer : {std::vector<std::uint8_t>{}, {0x02, 0x01}, {0x02}}) {
    tablet_->feature = answer;
    tablet_->closed = false;
    pump = start(options);
    EXPECT_EQ(text(next(*pump)), "wake feature 02 02: sent");
    pump.reset();
  }
  const auto asked = tablet_->all_asked();
  EXPECT_EQ(std::count(asked.begin(), asked.end(), "get feature 2"), 4);
  EXPECT_EQ(std::count(asked.begin(), asked.end(), "feature 0202"), 3);
}

TEST_F(ReportPumpTest, ATabletThatRefusesIsReadAllTheSame) {
  tablet_->refuses = true;
  ReportPump::Options options;
  options.wake_up = huion_like();
  options.wait = [](int) {};
  auto pump = start(std::move(options));
  tablet_->send({1});
  EXPECT_EQ(text(next(*pump)), "wake string 200: no answer: stalled");
  EXPECT_EQ(text(next(*pump)), "wake feature 02 02: refused: stalled");
  next(*pump);
  next(*pump);
  EXPECT_EQ(next(*pump).kind, RecordKind::report);
  EXPECT_EQ(pump->refused(), 3);
}

TEST_F(ReportPumpTest, WakesItAgainAfterTheSystemSlept) {
  std::atomic<std::int64_t> slept{0};
  ReportPump::Options options;
  options.wake_up.send_features = {{0x02, 0x02}};
  options.slept_us = [&slept] { return slept.load(); };
  auto pump = start(std::move(options));
  EXPECT_EQ(text(next(*pump)), "wake feature 02 02: sent");
  slept = 3'000'000;
  EXPECT_EQ(text(next(*pump)), "the system slept for 3000 ms");
  EXPECT_EQ(text(next(*pump)), "wake feature 02 02: sent");
  tablet_->send({9});
  EXPECT_EQ(next(*pump).bytes, std::vector<std::uint8_t>{9});
  EXPECT_EQ(tablet_->all_asked().size(), 2u);
}

TEST_F(ReportPumpTest, AFullQueueOfTheSystemIsTold) {
  tablet_->queue_was_full = true;
  auto pump = start();
  tablet_->send({7});
  EXPECT_EQ(text(next(*pump)), "the system's queue was full, reports may be missing around here");
  EXPECT_EQ(next(*pump).bytes, std::vector<std::uint8_t>{7});
  EXPECT_EQ(pump->full_queues(), 1u);
}

TEST(QueueGauge, AllAtOnceIsAFullQueue) {
  QueueGauge gauge;
  EXPECT_FALSE(gauge.was_full(false, 0));
  for (int i = 2; i <= QueueGauge::k_capacity - 1; ++i) EXPECT_FALSE(gauge.was_full(true, i));
  EXPECT_TRUE(gauge.was_full(true, 100));
  EXPECT_FALSE(gauge.was_full(true, 101)) << "told once";
}

TEST(QueueGauge, AnEmptyOneInBetweenOrASlowReaderIsNone) {
  QueueGauge gauge;
  for (int i = 0; i < 200; ++i) EXPECT_FALSE(gauge.was_full(i % 60 != 0, i)) << i;
  for (int i = 0; i < 200; ++i) EXPECT_FALSE(gauge.was_full(true, 1000 + 1000 * i)) << "1000 reports a second";
}

TEST_F(ReportPumpTest, ReportsBeforeTheUnpluggingAreAllThere) {
  auto pump = start();
  for (std::uint8_t i = 0; i < 50; ++i) tablet_->send({i});
  tablet_->unplug();
  for (std::uint8_t i = 0; i < 50; ++i) EXPECT_EQ(next(*pump).bytes, std::vector<std::uint8_t>{i});
  EXPECT_EQ(text(next(*pump)), "the device is gone");
  EXPECT_TRUE(pump->wait(k_patience_ms)) << "does not wait for a tablet that is gone";
  EXPECT_TRUE(pump->gone());
}

TEST_F(ReportPumpTest, NeverWaitsForAConsumerThatSleeps) {
  ReportPump::Options options;
  options.ring_bytes = 1024;
  auto pump = start(std::move(options));
  for (int i = 0; i < 1000; ++i) tablet_->send(std::vector<std::uint8_t>(12));
  for (int i = 0; i < k_patience_ms && pump->received() < 1000; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(pump->received(), 1000u);
  const std::uint64_t lost = pump->overruns();
  EXPECT_GT(lost, 900u);
  Record record;
  std::uint64_t taken = 0;
  while (pump->take(record)) taken += record.kind == RecordKind::report ? 1 : 0;
  EXPECT_EQ(taken + lost, 1000u);
}

TEST_F(ReportPumpTest, ClosesTheTabletWhenItEnds) {
  auto pump = start();
  EXPECT_FALSE(tablet_->closed);
  pump.reset();
  EXPECT_TRUE(tablet_->closed);
}

TEST_F(ReportPumpTest, IsExclusiveFromTheBeginningOrAsItIsAskedLater) {
  const auto becomes = [&](bool wanted) {
    for (int i = 0; i < 2000 && tablet_->exclusive != wanted; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return tablet_->exclusive == wanted;
  };
  ReportPump::Options options;
  options.exclusive = true;
  auto pump = start(std::move(options));
  EXPECT_TRUE(becomes(true));
  pump->set_exclusive(false);
  EXPECT_TRUE(becomes(false));
  pump->set_exclusive(true);
  EXPECT_TRUE(becomes(true));
}

TEST_F(ReportPumpTest, ThatAnotherProgramHasTheTabletIsToldAndItsEndToo) {
  auto pump = start();
  EXPECT_FALSE(pump->is_taken());
  tablet_->taken = true;
  EXPECT_EQ(text(next(*pump)), "another program has the device for itself");
  EXPECT_TRUE(pump->is_taken());
  tablet_->taken = false;
  EXPECT_EQ(text(next(*pump)), "the other program let go of the device");
  EXPECT_FALSE(pump->is_taken());
}

TEST_F(ReportPumpTest, SendsAFeatureReportFromItsOwnThreadTheLastOfSeveral) {
  auto pump = start();
  pump->send_feature({0x20, 0x01});
  const auto wait_for = [&](std::size_t count) {
    for (int i = 0; i < 2000 && tablet_->all_asked().size() < count; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
  };
  wait_for(1);
  EXPECT_EQ(tablet_->all_asked(), (std::vector<std::string>{"feature 2001"}));
  {
    // While the thread cannot come to it.
    const std::lock_guard lock(tablet_->mutex);
    pump->send_feature({0x20, 0x02});
    pump->send_feature({0x20, 0x03});
  }
  wait_for(2);
  const auto asked = tablet_->all_asked();
  EXPECT_EQ(asked.back(), "feature 2003");
  tablet_->send({7, 1});
  EXPECT_EQ(next(*pump).bytes, (std::vector<std::uint8_t>{7, 1})) << "and reports come as before";
}

TEST_F(ReportPumpTest, OfAReportThatIsTheTabletsOwnOneByteIsChanged) {
  const auto sent_with = [&](std::vector<std::uint8_t> now) {
    tablet_->feature = std::move(now);
    tablet_->closed = false;
    const std::size_t before = tablet_->all_asked().size();
    auto pump = start();
    pump->send_feature({0x03, 0, 0x02}, 2);
    for (int i = 0; i < 2000 && tablet_->all_asked().size() < before + 2; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    pump.reset();
    return tablet_->all_asked().back();
  };
  EXPECT_EQ(sent_with({0x03, 0x77, 0x01}), "feature 037702");
  EXPECT_EQ(sent_with({}), "feature 030002") << "it does not say what it has";
  EXPECT_EQ(sent_with({0x03, 0x77}), "feature 030002") << "a report of another length";
  EXPECT_EQ(sent_with({0x04, 0x77, 0x01}), "feature 030002") << "another report";
}

TEST_F(ReportPumpTest, AFeatureReportThatIsRefusedIsCountedAndNotTriedAgain) {
  tablet_->refuses = true;
  auto pump = start();
  pump->send_feature({0x20, 0x01});
  for (int i = 0; i < 2000 && pump->refused() == 0; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::this_thread::sleep_for(std::chrono::milliseconds(150));
  EXPECT_EQ(pump->refused(), 1);
  EXPECT_EQ(tablet_->all_asked().size(), 1U);
}

}  // namespace
}  // namespace penpose::device
