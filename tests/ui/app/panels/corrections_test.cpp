#include "core/articulation/corrections.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

// What is drawn at a pose that several controls make together, and the buttons that it has.

namespace penpose::app {
namespace {

class Corrected {
 public:
  explicit Corrected(const std::string& name) : desk(name) {
    desk.begin();
    set("mouth_corner_L", 1);
    set("jaw", 0.5);
    desk.click("Controls");
  }
  void set(const std::string& control, double value) {
    const auto index = rig::find_parameter(desk.document().model->rig->parameters(), control);
    ASSERT_TRUE(index) << control;
    desk.app->of<Controls>().set_parameter(*index, value);
    desk.frames();
  }
  /// Where the corner of the mouth is seen now.
  [[nodiscard]] PxPoint corner() const { return desk.named_curve("lip_upper_inner").back(); }
  void sketch() {
    desk.click("Correct this pose");
    at = corner();
    desk.stroke(around(at, 60, 45));
    desk.stroke(around(at, 22, 16));
    desk.stroke({at + PxPoint{-14, -6}, at + PxPoint{0, -8}, at + PxPoint{14, -6}});
  }
  [[nodiscard]] const articulation::Correction* only() const {
    const auto& all = desk.document().model->corrections;
    return all && all->all().size() == 1 ? all->all().front().get() : nullptr;
  }
  [[nodiscard]] double value(const std::string& control) const {
    return desk.document().pose[*rig::find_parameter(desk.document().model->rig->parameters(), control)];
  }

  Desk desk;
  PxPoint at;
};

TEST(Corrections, FourStrokesAtAPoseCorrectItWhereItsControlsMeetAndNowhereElse) {
  Corrected face("correct");
  const auto before = face.corner();
  face.sketch();
  ASSERT_NE(face.only(), nullptr);
  EXPECT_EQ(face.only()->drawn.drivers.size(), 2U);
  EXPECT_GT(geometry::distance(face.corner(), before), 1) << "it is in at its pose";
  const auto corrected = face.corner();
  face.set("jaw", 0);
  const auto without = face.corner();
  face.desk.click("Remove##correction");
  EXPECT_EQ(face.only(), nullptr);
  EXPECT_NEAR(geometry::distance(face.corner(), without), 0, 1e-6) << "where a control rests there is none of it";
  face.set("jaw", 0.5);
  EXPECT_NEAR(geometry::distance(face.corner(), before), 0, 1e-3);
  EXPECT_GT(geometry::distance(face.corner(), corrected), 1);
}

TEST(Corrections, DrawAgainStandsInItsPoseAndTakesOneStroke) {
  Corrected face("correct-again");
  face.sketch();
  ASSERT_NE(face.only(), nullptr);
  const auto drawn = face.only()->drawn.sketch.target;
  face.set("jaw", 0);
  face.set("brow_outer_L", 1);
  face.desk.click("Draw again##correction");
  EXPECT_NEAR(face.value("jaw"), 0.5, 1e-12);
  EXPECT_NEAR(face.value("mouth_corner_L"), 1, 1e-12);
  EXPECT_EQ(face.value("brow_outer_L"), 0) << "its controls alone";
  face.desk.stroke({face.at + PxPoint{-14, 6}, face.at + PxPoint{0, 9}, face.at + PxPoint{14, 6}});
  ASSERT_NE(face.only(), nullptr);
  EXPECT_NE(face.only()->drawn.sketch.target, drawn);
}

TEST(Corrections, OneIsRenamedMirroredAndRemovedByItsButtons) {
  Corrected face("correct-buttons");
  face.sketch();
  ASSERT_NE(face.only(), nullptr);
  face.desk.click("##correction_name");
  face.desk.type("left dimple");
  face.desk.click("Rename##correction");
  ASSERT_NE(face.only(), nullptr);
  EXPECT_EQ(face.only()->drawn.sketch.name, "left dimple");
  face.desk.click("Mirror##correction");
  const auto all = face.desk.document().model->corrections->all();
  ASSERT_EQ(all.size(), 2U);
  const auto& drivers = all.back()->drawn.drivers;
  EXPECT_TRUE(std::any_of(drivers.begin(), drivers.end(), [](const articulation::Driver& one) {
    return one.control == "mouth_corner_R";
  })) << "its controls are those of the other side";
  face.desk.click("Remove##correction");
  EXPECT_EQ(face.desk.document().model->corrections->all().size(), 1U);
}

}  // namespace
}  // namespace penpose::app
