#include <gtest/gtest.h>

#include "tests/support/app_desk.h"
#include "ui/app/playback/keys.h"

// The values at the axis of the curves.

namespace penpose::app {
namespace {

TEST(CurveAxis, ValuesStandWhereTheCurveHasThemInTheUnitsOfTheControl) {
  Desk desk("axis");
  desk.begin();
  auto& editing = desk.app->of<EditingSession>();
  ASSERT_TRUE(editing.perform(document::SetKey{0, {}}));
  ASSERT_TRUE(editing.perform(document::SetParameters{{{"jaw", 0.5}}}));
  ASSERT_TRUE(editing.perform(document::SetKey{2, {}}));
  desk.press('t', false, true);
  const auto parameters = desk.document().model->rig->parameters();
  const rig::Parameter& jaw = parameters[*rig::find_parameter(parameters, "jaw")];
  ASSERT_EQ(jaw.minimum, 0);
  ASSERT_EQ(jaw.maximum, 1);
  const Area curves = *desk.interface->find("curves");
  const auto* half = desk.interface->find("axis 0.50") != nullptr ? desk.interface->find("axis 0.50")
                                                                  : desk.interface->find("axis 0.5");
  // Steps of 0.2 have no half.
  const auto* low = desk.interface->find("axis 0.2") != nullptr ? desk.interface->find("axis 0.2") : half;
  ASSERT_NE(low, nullptr);
  const double value = low == half ? 0.5 : 0.2;
  EXPECT_NEAR(low->middle().y, curves.bottom - (0.1 + 0.8 * value) * curves.height(), 1.5);
}

}  // namespace
}  // namespace penpose::app
