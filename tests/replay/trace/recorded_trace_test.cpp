#include <cmath>
#include <gtest/gtest.h>

#include "firmware_io/decode/decoder_factory.h"
#include "replay/trace/trace_source.h"
#include "tests/support/hands/stroke_recorder.h"
#include "tests/support/shared_data.h"

namespace penpose::replay {
namespace {

/// The strokes of a trace of tests/data that has one device.
std::vector<tests::PenStroke> strokes_of(const std::string& name) {
  const auto bytes = tests::read_file(std::filesystem::path(PENPOSE_TEST_DATA) / "traces" / name);
  TraceSource source(read_from(bytes));
  EXPECT_TRUE(source.read_header());
  if (source.devices().empty()) return {};
  auto made = decode::make_decoder(source.devices().at(0));
  EXPECT_TRUE(made);
  if (!made) return {};
  tests::StrokeRecorder strokes;
  std::int64_t last_us = 0;
  for (auto report = source.next(); report && report->has_value(); report = source.next()) {
    last_us = (*report)->time_us;
    if (made->decoder->decode((*report)->bytes) == decode::ReportKind::pen)
      strokes.add(made->decoder->sample(), last_us);
  }
  strokes.finish(last_us);
  EXPECT_TRUE(source.problems().empty());
  return strokes.strokes();
}

TEST(RecordedTrace, ThePenThatQemuEmulatesDrewThreeEllipses) {
  const auto strokes = strokes_of("qemu_penpartner.hid");
  ASSERT_EQ(strokes.size(), 3u);
  for (std::size_t n = 0; n < strokes.size(); ++n) {
    const auto& points = strokes[n].points;
    ASSERT_EQ(points.size(), 31u) << "the press and thirty movements, the last stroke too, which unplugging ended";
    // What was injected, of 32767 units each way, on a tablet of 5040 by 3780.
    const double unit_x = 5040.0 / 32767;
    const double unit_y = 3780.0 / 32767;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const double x = (points[i].sample.x / unit_x - (9000 + 5000.0 * static_cast<double>(n))) / 3000;
      const double y = (points[i].sample.y / unit_y - 12000) / 4000;
      EXPECT_NEAR(std::hypot(x, y), 1, 0.005) << "stroke " << n << " point " << i;
      EXPECT_EQ(points[i].sample.pressure, 127);
      EXPECT_GT(points[i].time_us, points[i - 1].time_us);
    }
  }
}

}  // namespace
}  // namespace penpose::replay
