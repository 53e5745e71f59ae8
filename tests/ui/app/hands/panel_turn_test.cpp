#include "ui/app/hands/panel_turn.h"

#include <gtest/gtest.h>

#include "replay/session/pen_input.h"
#include "replay/session/virtual_pen.h"
#include "tests/support/app_desk.h"
#include "ui/app/view/present/output/rotation.h"

// A pen that is built into a panel reports places of the panel, however it is mounted.

namespace penpose::app {
namespace {

constexpr std::uint16_t k_bus_i2c = 0x18;

decode::DeviceIdentity pen_on(std::uint16_t bus) {
  auto identity = replay::virtual_pen_identity();
  identity.bus = bus;
  return identity;
}

/// Where a pen draws that reports a place of the panel, in shares of its sides, on a picture of 800 x 480.
PxPoint drawn_at(const PanelTurn& panel, std::uint16_t bus, PxPoint share) {
  constexpr geometry::Viewport k_picture{800, 480};
  Desk desk("panel_turn");
  KnownTablets tablets;
  tablets.seen[1] = pen_on(bus);
  const HandDesk hands;
  const Bindings bindings(desk.app->of<EditingSession>(), desk.app->of<Preferences>(), hands, tablets, panel);
  replay::PenInput pens;
  document::View view;
  view.viewport = k_picture;
  pens.set_view(view);
  pens.connect(1, pen_on(bus));
  EXPECT_TRUE(pens.set_tablet(1, bindings.setting_of(1)));
  const PxPoint reported{share.x * k_picture.width, share.y * k_picture.height};
  const auto moments =
      pens.report(1, 1000, replay::virtual_pen_report({reported, 0.5, true, true, false, false}, k_picture));
  EXPECT_FALSE(moments.empty());
  return moments.empty() ? PxPoint{} : moments.back().position;
}

TEST(PanelTurn, ABuiltInPenDrawsWhereThePanelShowsItsPlace) {
  for (const int degrees : {0, 90, 180, 270}) {
    const Rotation rotation = *rotation_of(degrees);
    const geometry::Viewport size = turned_size({800, 480}, rotation);
    for (const PxPoint share : {PxPoint{0.1, 0.2}, PxPoint{0.9, 0.3}, PxPoint{0.5, 0.75}}) {
      const PxPoint seen = on_picture({share.x * size.width, share.y * size.height}, size, rotation);
      const PxPoint drawn = drawn_at({degrees, TurnedInput::built_in}, k_bus_i2c, share);
      EXPECT_NEAR(drawn.x, seen.x, 0.1) << degrees;
      EXPECT_NEAR(drawn.y, seen.y, 0.1) << degrees;
    }
  }
}

TEST(PanelTurn, ATabletOnTheDeskStaysAsItLies) {
  for (const std::uint16_t bus : {decode::k_bus_usb, decode::k_bus_bluetooth, decode::k_bus_virtual}) {
    const PxPoint drawn = drawn_at({90, TurnedInput::built_in}, bus, {0.25, 0.5});
    EXPECT_NEAR(drawn.x, 200, 0.1);
    EXPECT_NEAR(drawn.y, 240, 0.1);
  }
}

TEST(PanelTurn, TheUserSaysOtherwise) {
  const PxPoint display = drawn_at({180, TurnedInput::all}, decode::k_bus_usb, {0.25, 0.25});
  EXPECT_NEAR(display.x, 600, 0.1) << "a pen display by USB turns, too";
  EXPECT_NEAR(display.y, 360, 0.1);
  const PxPoint turned_already = drawn_at({180, TurnedInput::none}, k_bus_i2c, {0.25, 0.25});
  EXPECT_NEAR(turned_already.x, 200, 0.1);
  EXPECT_EQ(turned_input("all"), TurnedInput::all);
  EXPECT_EQ(turned_input("none"), TurnedInput::none);
  EXPECT_EQ(turned_input(""), TurnedInput::built_in);
}

}  // namespace
}  // namespace penpose::app
