#include <algorithm>
#include <gtest/gtest.h>

#include "core/document/time/timeline_editing.h"
#include "tests/support/app_desk.h"
#include "ui/app/playback/frames.h"
#include "ui/app/playback/keys.h"
#include "ui/app/playback/sheet/sheet_rows.h"

// The dope sheet and the curve editor: keys of one control, selected, moved, scaled and bent by the pen.

namespace penpose::app {
namespace {

/// A desk with the jaw keyed at 0, 1, 2 and 3 s, smiling at 2 s.
class SheetDesk : public Desk {
 public:
  explicit SheetDesk(const std::string& name) : Desk(name) {
    begin();
    for (const double time : {0.0, 1.0, 2.0, 3.0}) {
      const double open = 0.1 + 0.2 * time;
      const double smile = time == 2 ? 0.5 : 0;
      perform(document::SetParameters{{{"jaw", open}, {"mouth_corner_L", smile}}});
      perform(document::SetKey{time, {}});
    }
    frames();
  }
  void perform(const document::Command& command) { ASSERT_TRUE(app->of<EditingSession>().perform(command)); }
  std::size_t number(const std::string& control) const {
    return *rig::find_parameter(document().model->rig->parameters(), control);
  }
  /// The moments of a control's keys.
  std::vector<double> keys(const std::string& control) const {
    std::vector<double> moments;
    for (const auto& key : document().timeline->keys) {
      if (key.controls.has(number(control))) moments.push_back(key.time_s);
    }
    return moments;
  }
  double value(const std::string& control, double time_s) const {
    return *document::sample(*document().timeline, number(control), time_s);
  }
  double x_of(const std::string& strip, double time_s) const {
    const Area area = *interface->find(strip);
    const double inset = 0.3 * unit();
    return area.left + inset + time_s / shown_s() * (area.width() - 2 * inset);
  }
  PxPoint on_row(const std::string& row, double time_s) const {
    return {x_of("sheet", time_s), interface->find(row)->middle().y};
  }
  void drag(PxPoint from, PxPoint to) {
    app->of<Pointer>().moved(from);
    app->of<Pointer>().button(MouseButton::left, true, from);
    frames();
    for (int i = 1; i <= 4; ++i) {
      app->of<Pointer>().moved(from + (to - from) * (i / 4.0));
      frames(2);
    }
    app->of<Pointer>().button(MouseButton::left, false, to);
    frames();
  }
  void touch(PxPoint at) { drag(at, at); }

 private:
  double unit() const { return interface->find("ruler")->height(); }
  /// The timeline shows a second more than it has keys.
  double shown_s() const { return 4; }
};

TEST(Sheet, RowsAreGroupsByThePartOfTheFaceAndFold) {
  SheetDesk desk("sheet-rows");
  desk.press('t');
  ASSERT_NE(desk.interface->find("group Mouth"), nullptr);
  ASSERT_NE(desk.interface->find("row jaw"), nullptr);
  EXPECT_NEAR(desk.interface->find("sheet")->left, desk.interface->find("ruler")->left, 1) << "below its frames";
  EXPECT_LT(desk.interface->find("row jaw")->right, desk.interface->find("sheet")->left);
  EXPECT_EQ(desk.interface->find("row brow_raise_L"), nullptr) << "it rests in every key";
  desk.click("group Mouth");
  EXPECT_EQ(desk.interface->find("row jaw"), nullptr);
  desk.click("group Mouth");
  EXPECT_NE(desk.interface->find("row jaw"), nullptr);
  desk.click("All rows");
  EXPECT_NE(desk.interface->find("group Brows"), nullptr);
}

TEST(Sheet, AKeyOfOneControlIsDraggedAndTheOthersStay) {
  SheetDesk desk("sheet-drag");
  desk.press('t');
  desk.drag(desk.on_row("row jaw", 1), desk.on_row("row jaw", 1.5));
  EXPECT_EQ(desk.keys("jaw"), (std::vector<double>{0, 1.5, 2, 3}));
  EXPECT_EQ(desk.keys("mouth_corner_L"), (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(desk.value("jaw", 1.5), 0.1 + 0.2);
  EXPECT_EQ(desk.app->of<Keys>().selected().size(), 1U) << "it stays selected";
  desk.press('z', true);
  EXPECT_EQ(desk.keys("jaw"), (std::vector<double>{0, 1, 2, 3}));
}

TEST(Sheet, KeysAreBoxedAndScaledByTheEndOfTheirBar) {
  SheetDesk desk("sheet-scale");
  desk.press('t');
  PxPoint from = desk.on_row("row jaw", 0.8);
  PxPoint to = desk.on_row("row jaw", 3.2);
  from.y -= 8;
  to.y += 8;
  desk.drag(from, to);
  EXPECT_EQ(desk.app->of<Keys>().selected().size(), 3U);
  const PxPoint end = desk.interface->find("last selected key")->middle();
  desk.drag(end, {desk.x_of("sheet", 2), end.y});
  EXPECT_EQ(desk.keys("jaw"), (std::vector<double>{0, 1, 1.5, 2}));
  EXPECT_EQ(desk.keys("mouth_corner_L"), (std::vector<double>{0, 1, 2, 3}));
}

TEST(Sheet, SelectedKeysAreDeletedAndChangedInKind) {
  SheetDesk desk("sheet-kind");
  desk.press('t');
  desk.touch(desk.on_row("row jaw", 1));
  desk.click("Smooth##kind");
  desk.click("Stepped##choose kind");
  EXPECT_EQ(desk.value("jaw", 1.9), 0.1 + 0.2);
  EXPECT_GT(desk.value("mouth_corner_L", 1.9), 0.4) << "one control alone";
  desk.press('i', false, true);
  EXPECT_EQ(desk.keys("jaw"), (std::vector<double>{0, 2, 3}));
  EXPECT_EQ(desk.keys("mouth_corner_L"), (std::vector<double>{0, 1, 2, 3}));
}

TEST(Sheet, DeleteRemovesTheSelectedKeysAndEscapeOrClosingTheSheetDropsThem) {
  SheetDesk desk("sheet-delete");
  const auto touch_key = [&] {
    desk.touch(desk.on_row("row jaw", 1));
    ASSERT_EQ(desk.app->of<Keys>().selected().size(), 1U);
  };
  desk.press('t');
  touch_key();
  desk.hit_escape();
  EXPECT_TRUE(desk.app->of<Keys>().selected().empty());
  touch_key();
  desk.press('t');
  EXPECT_TRUE(desk.app->of<Keys>().selected().empty()) << "nobody sees what would be changed";
  desk.press('t');
  touch_key();
  desk.press(k_key_delete);
  EXPECT_EQ(desk.keys("jaw"), (std::vector<double>{0, 2, 3}));
}

TEST(Sheet, ANameTouchedSelectsAllKeysOfItsControl) {
  SheetDesk desk("sheet-name");
  desk.press('t');
  desk.touch_row("row jaw");
  EXPECT_EQ(desk.app->of<Keys>().selected().size(), 4U);
  desk.touch(desk.on_row("row jaw", 0.5));
  EXPECT_TRUE(desk.app->of<Keys>().selected().empty());
  EXPECT_DOUBLE_EQ(desk.app->of<Playback>().time_s(), 0.5) << "a touch of free ground goes there";
}

TEST(Sheet, ThousandsOfKeysAreShownAndSelected) {
  SheetDesk desk("sheet-many");
  document::KeyPoses many;
  for (const auto& parameter : desk.document().model->rig->parameters()) many.names.push_back(parameter.name);
  for (int k = 0; k < 6000; ++k) {
    many.times_s.push_back(k / 24.0);
    for (std::size_t i = 0; i < many.names.size(); ++i) many.values.push_back(k % 2 == 0 ? 0.25 : 0.5);
  }
  desk.perform(many);
  desk.frames();
  desk.press('t');
  desk.touch_row("row brow_inner_L");
  EXPECT_EQ(desk.app->of<Keys>().selected().size(), 6000U);
  desk.press('t', false, true);
  desk.frames();
  EXPECT_NE(desk.interface->find("curves"), nullptr);
}

TEST(Curves, AKeyIsPulledInTimeAndValueAndItsHandleBendsTheCurve) {
  SheetDesk desk("curves");
  desk.press('t', false, true);
  const Area strip = *desk.interface->find("curves");
  const auto y_of = [&](double share) { return strip.bottom - (0.1 + 0.8 * share) * strip.height(); };
  const PxPoint key{desk.x_of("curves", 1), y_of(desk.value("jaw", 1))};
  desk.drag(key, {desk.x_of("curves", 1.5), y_of(0.4)});
  EXPECT_EQ(desk.keys("jaw"), (std::vector<double>{0, 1.5, 2, 3}));
  EXPECT_NEAR(desk.value("jaw", 1.5), 0.4, 0.02);
  desk.press('z', true);
  EXPECT_EQ(desk.keys("jaw"), (std::vector<double>{0, 1, 2, 3})) << "time and value are one step";
  EXPECT_DOUBLE_EQ(desk.value("jaw", 1), 0.1 + 0.2);

  desk.touch(key);
  ASSERT_NE(desk.interface->find("handle after jaw"), nullptr);
  const PxPoint handle = desk.interface->find("handle after jaw")->middle();
  const double before = desk.value("jaw", 1.3);
  desk.drag(handle, {handle.x, handle.y - 30});
  EXPECT_GT(desk.value("jaw", 1.3), before + 0.02);
  EXPECT_DOUBLE_EQ(desk.value("jaw", 1), 0.1 + 0.2);
  const auto& timeline = *desk.document().timeline;
  EXPECT_EQ(timeline.keys[1].controls[desk.number("jaw")].kind, document::KeyKind::free);
}

TEST(Breakdown, TheSliderKeysAPoseBetweenItsNeighbours) {
  SheetDesk desk("breakdown");
  desk.app->of<Playback>().go_to(2.5);
  desk.frames();
  desk.app->of<Keys>().tween(0.25);
  desk.frames();
  EXPECT_EQ(desk.keys("jaw"), (std::vector<double>{0, 1, 2, 2.5, 3}));
  EXPECT_NEAR(desk.value("jaw", 2.5), 0.5 + 0.25 * 0.2, 1e-9);
  EXPECT_NEAR(desk.value("mouth_corner_L", 2.5), 0.5 * 0.75, 1e-9);
}

}  // namespace
}  // namespace penpose::app
