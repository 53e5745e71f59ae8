#include "replay/session/virtual_pen.h"

#include <cmath>
#include <gtest/gtest.h>

#include "firmware_io/decode/decoder_factory.h"
#include "firmware_io/decode/hand/pen_mapping.h"
#include "firmware_io/hid/report_descriptor.h"

namespace penpose::replay {
namespace {

/// What a decoder that knows nothing but the descriptor reads.
class VirtualPenReader {
 public:
  explicit VirtualPenReader(geometry::Viewport viewport)
      : viewport_(viewport),
        decoder_(decode::make_decoder(virtual_pen_identity()).value().decoder),
        mapping_(decode::PenMapping::make(decoder_->axes(), {.width_px = static_cast<double>(viewport.width),
                                                             .height_px = static_cast<double>(viewport.height)})
                     .value()) {}

  decode::MappedSample operator()(const VirtualPenState& state) {
    const auto report = virtual_pen_report(state, viewport_);
    EXPECT_EQ(decoder_->decode(report), decode::ReportKind::pen);
    EXPECT_EQ(decoder_->frames().size(), 1U);
    return mapping_.map(decoder_->frames()[0]);
  }

 private:
  geometry::Viewport viewport_;
  std::unique_ptr<decode::PenDecoder> decoder_;
  decode::PenMapping mapping_;
};

TEST(VirtualPen, ItsDescriptorIsLegal) {
  const auto parsed = hid::parse_report_descriptor(virtual_pen_device().report_descriptor, hid::Strictness::exact);
  ASSERT_TRUE(parsed.ok()) << parsed.error().line();
  EXPECT_EQ(parsed->longest_report(hid::ReportType::input), k_virtual_pen_report_size);
  EXPECT_EQ(parsed->longest_report(hid::ReportType::output), 0U);
}

TEST(VirtualPen, IsRecognisedAsAPen) {
  const auto recognised = decode::make_decoder(virtual_pen_identity());
  ASSERT_TRUE(recognised.ok()) << recognised.error().line();
  EXPECT_EQ(recognised->method, "descriptor");
  EXPECT_FALSE(recognised->is_pad);
  EXPECT_EQ(virtual_pen_identity().bus, 6) << "no tablet of the world is mistaken for it";
}

TEST(VirtualPen, PositionsComeBackWithinA32ndPx) {
  for (const geometry::Viewport viewport : {geometry::Viewport{1, 1}, {640, 480}, {1000, 1000}, {2000, 1999}}) {
    VirtualPenReader read(viewport);
    for (int i = 0; i <= 500; ++i) {
      const double share = (i * 7 % 501) / 500.0;
      const geometry::PxPoint at{viewport.width * share, viewport.height * (i / 500.0)};
      const auto sample = read({.position = at, .tip = true});
      ASSERT_NEAR(sample.x_px, at.x, 1.0 / 32) << viewport.width;
      ASSERT_NEAR(sample.y_px, at.y, 1.0 / 32) << viewport.height;
    }
  }
}

TEST(VirtualPen, WhatIsOutsideGoesToTheEdge) {
  VirtualPenReader read({640, 480});
  const auto low = read({.position = {-50, -1e300}});
  EXPECT_EQ(low.x_px, 0);
  EXPECT_EQ(low.y_px, 0);
  const auto high = read({.position = {1e300, 481}});
  EXPECT_EQ(high.x_px, 640);
  EXPECT_EQ(high.y_px, 480);
  const double none = std::nan("");
  const auto nothing = read({.position = {none, none}, .pressure = none, .tip = true});
  EXPECT_EQ(nothing.x_px, 0) << "a position that is no number is a place all the same";
}

TEST(VirtualPen, PressureCountsWhileTheTipTouches) {
  VirtualPenReader read({640, 480});
  EXPECT_NEAR(read({.pressure = 0.37, .tip = true}).pressure, 0.37, 1.0 / 4095);
  EXPECT_EQ(read({.pressure = 1, .tip = true}).pressure, 1);
  EXPECT_EQ(read({.pressure = 7, .tip = true}).pressure, 1);
  EXPECT_EQ(read({.pressure = 0.37, .tip = false}).pressure, 0);
}

TEST(VirtualPen, TipEraserAndBarrel) {
  VirtualPenReader read({640, 480});
  const auto hover = read({});
  EXPECT_TRUE(hover.in_range);
  EXPECT_FALSE(hover.tip);
  EXPECT_EQ(hover.tool, decode::Tool::pen);
  EXPECT_EQ(hover.buttons, 0U);
  const auto tip = read({.tip = true});
  EXPECT_TRUE(tip.tip);
  EXPECT_EQ(tip.tool, decode::Tool::pen);
  const auto barrel = read({.tip = true, .barrel = true});
  EXPECT_EQ(barrel.buttons, 1U);
  EXPECT_TRUE(barrel.tip);
  const auto near = read({.eraser = true});
  EXPECT_EQ(near.tool, decode::Tool::eraser);
  EXPECT_FALSE(near.tip);
  const auto erasing = read({.tip = true, .eraser = true});
  EXPECT_EQ(erasing.tool, decode::Tool::eraser);
  EXPECT_TRUE(erasing.tip);
  EXPECT_EQ(erasing.buttons, 0U);
}

TEST(VirtualPen, OutOfRangeNothingTouches) {
  VirtualPenReader read({640, 480});
  EXPECT_TRUE(read({.tip = true}).tip);
  const auto away = read({.position = {10, 10}, .in_range = false, .tip = true, .eraser = true, .barrel = true});
  EXPECT_FALSE(away.in_range);
  EXPECT_FALSE(away.tip);
  EXPECT_EQ(away.buttons, 0U);
  EXPECT_EQ(away.pressure, 0);
}

}  // namespace
}  // namespace penpose::replay
