#include <algorithm>
#include <gtest/gtest.h>

#include "tests/support/hands/pen_path.h"
#include "tests/support/hands/stroke_recorder.h"

namespace penpose::decode {
namespace {

TEST(StrokeRecorder, LosesNothingAndDoublesNothing) {
  const auto path = tests::pen_path({10000, 8000, 1023, true, -1}, 5, 40);
  tests::StrokeRecorder recorder;
  std::int64_t time_us = 0;
  for (const PenSample& sample : path) recorder.add(sample, time_us += 5000);
  recorder.finish(time_us);

  std::vector<std::pair<std::int64_t, PenSample>> recorded;
  for (const PenEvent& event : recorder.events()) {
    if (event.kind == PenEventKind::hover) recorded.emplace_back(event.time_us, event.sample);
  }
  for (const tests::PenStroke& stroke : recorder.strokes()) {
    for (const tests::StrokePoint& point : stroke.points) recorded.emplace_back(point.time_us, point.sample);
  }
  std::stable_sort(recorded.begin(), recorded.end(), [](const auto& a, const auto& b) { return a.first < b.first; });

  std::size_t next = 0;
  time_us = 0;
  for (const PenSample& sample : path) {
    time_us += 5000;
    if (!sample.in_range) continue;
    ASSERT_LT(next, recorded.size());
    EXPECT_EQ(recorded[next].first, time_us);
    EXPECT_EQ(recorded[next].second, sample);
    ++next;
  }
  EXPECT_EQ(next, recorded.size());
}

TEST(StrokeRecorder, OneStrokeForEachContactWithItsTool) {
  tests::StrokeRecorder recorder;
  std::int64_t time_us = 0;
  for (const PenSample& sample : tests::pen_path({}, 3, 20)) recorder.add(sample, ++time_us);
  ASSERT_EQ(recorder.strokes().size(), 3u);
  EXPECT_EQ(recorder.strokes()[0].points.size(), 14u);
  EXPECT_EQ(recorder.strokes()[1].tool, Tool::pen);
  EXPECT_EQ(recorder.strokes()[2].tool, Tool::eraser);
  EXPECT_FALSE(recorder.is_drawing());
}

TEST(StrokeRecorder, FinishEndsAnOpenStroke) {
  tests::StrokeRecorder recorder;
  PenSample sample;
  sample.in_range = sample.tip = true;
  sample.tool = Tool::pen;
  recorder.add(sample, 1);
  EXPECT_TRUE(recorder.is_drawing());
  recorder.finish(2);
  EXPECT_FALSE(recorder.is_drawing());
  EXPECT_EQ(recorder.events().back().kind, PenEventKind::away);
}

}  // namespace
}  // namespace penpose::decode
