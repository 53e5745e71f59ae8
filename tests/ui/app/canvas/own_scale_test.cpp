#include "ui/app/canvas/own_scale.h"

#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

// How large the interface is, by who says it.

namespace penpose::app {
namespace {

TEST(OwnScale, XResourcesAreReadAsTheServerKeepsThem) {
  EXPECT_EQ(xft_dpi("Xft.antialias:\t1\nXft.dpi:\t192\nXft.hinting:\t1\n"), 192);
  EXPECT_EQ(xft_dpi("Xft.dpi: 96\nXft.dpi: 144"), 144) << "the last one counts";
  for (const char* none : {"", "Xft.dpi", "Xft.dpi:", "Xft.dpi: many", "Xft.dpi: -1", "Xft.dpi: nan", "Xft.dpi: 5000",
                           "xterm.Xft.dpi: 192"})
    EXPECT_EQ(xft_dpi(none), std::nullopt) << none;
}

TEST(OwnScale, ResourcesComeFirstThenTheCompositorThenToolkits) {
  EXPECT_DOUBLE_EQ(own_scale({192, 1.5, 3}), 2);
  EXPECT_DOUBLE_EQ(own_scale({0, 1.5, 3}), 1.5);
  EXPECT_DOUBLE_EQ(own_scale({0, 1, 3}), 3);
  EXPECT_DOUBLE_EQ(own_scale({}), 0) << "the density says it";
  EXPECT_DOUBLE_EQ(own_scale({9600, 0, 0}), 0) << "nothing is a hundred times larger";
  EXPECT_DOUBLE_EQ(toolkit_scale("2", "0.75"), 1.5);
  EXPECT_DOUBLE_EQ(toolkit_scale(nullptr, "1.25"), 1.25);
  EXPECT_DOUBLE_EQ(toolkit_scale("large", nullptr), 0);
}

TEST(OwnScale, WhatTheServerWasStartedWithCountsWhereNobodyElseSaysAnything) {
  EXPECT_DOUBLE_EQ(own_scale({.server_dpi = 192}), 2) << "a server that was started with -dpi 192";
  EXPECT_DOUBLE_EQ(own_scale({.text_dpi = 144, .server_dpi = 192}), 1.5);
  EXPECT_DOUBLE_EQ(own_scale({.px_a_unit = 2, .server_dpi = 144}), 2);
  EXPECT_DOUBLE_EQ(own_scale({.toolkits = 3, .server_dpi = 192}), 3);
  for (const double unchosen : {96.0, 95.9, 97.2, 100.0, 0.0, 5.0, 2000.0})
    EXPECT_DOUBLE_EQ(own_scale({.server_dpi = unchosen}), 0) << unchosen;
  EXPECT_NEAR(dpi_of(3840, 508), 192, 0.5);
  EXPECT_DOUBLE_EQ(dpi_of(1920, 0), 0) << "a screen without a size";
}

TEST(OwnScale, AWindowOpensAsLargeAsItsScaleAsksForAndTheScreenAllows) {
  EXPECT_EQ(opened_px(1280, 2, 3840), 2560);
  EXPECT_EQ(opened_px(1280, 1, 3840), 1280);
  EXPECT_EQ(opened_px(1280, 2, 1920), 1920);
  EXPECT_EQ(opened_px(800, 0, 2160), 800) << "not known";
}

TEST(OwnScale, WhatIsAskedForGoesBeforeSettingsAndThoseCountOnTopOfTheSystem) {
  Desk desk("scale");
  desk.begin();
  Canvas& canvas = desk.app->of<Canvas>();
  Pointer& pointer = desk.app->of<Pointer>();
  pointer.resized({1280, 800}, 120);
  EXPECT_DOUBLE_EQ(canvas.scale(), 1.25) << "by the density";
  pointer.resized({1280, 800}, 120, 2);
  EXPECT_DOUBLE_EQ(canvas.scale(), 2) << "as the system wants it";
  const double letters_2 = canvas.target_px();
  pointer.resized({1280, 800}, 192, 1);
  EXPECT_DOUBLE_EQ(canvas.scale(), 1);
  EXPECT_DOUBLE_EQ(canvas.target_px(), letters_2) << "9 mm stay 9 mm on the glass";
  desk.press('=', true);
  EXPECT_DOUBLE_EQ(canvas.scale(), 1.25);
  canvas.ask_scale(2);
  EXPECT_DOUBLE_EQ(canvas.scale(), 2);
  EXPECT_DOUBLE_EQ(desk.app->of<Preferences>().settings().scale, 1.25) << "what was chosen is kept for the next time";
  desk.press('=', true);
  EXPECT_DOUBLE_EQ(canvas.scale(), 2 * 1.5 / 1.25) << "Larger makes it larger all the same";
}

}  // namespace
}  // namespace penpose::app
