#include "ui/app/view/present/cpu_presenter.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "tests/support/app_desk.h"
#include "ui/app/view/draw_frame.h"

// While the view moves and pictures take too long they are coarse, and whole again when it rests.

namespace penpose::app {
namespace {

class LastPicture final : public PictureOutput {
 public:
  [[nodiscard]] std::optional<geometry::Viewport> size() const override { return geometry::Viewport{640, 480}; }
  [[nodiscard]] double dpi() const override { return 0; }
  void show(const render::Image& picture, const std::vector<render::PxRect>& /*parts*/) override { shown = picture; }
  render::Image shown;
};

/// A window whose pictures take as long as the test says.
class SlowlyDrawn : public testing::Test {
 protected:
  SlowlyDrawn() : desk_("slowly_drawn") {
    desk_.begin();
    desk_.app->of<Pointer>().resized({640, 480}, 0);
    desk_.frames();
    presenter_ = make_cpu_presenter(output_, Rotation::none, false, [this] { return now_us_ += takes_us_; });
    EXPECT_TRUE(presenter_->begin());
  }
  ~SlowlyDrawn() override { presenter_->end(); }
  SlowlyDrawn(const SlowlyDrawn&) = delete;
  SlowlyDrawn& operator=(const SlowlyDrawn&) = delete;

  void draw() {
    desk_.frames(1);
    EXPECT_TRUE(presenter_->draw(frames_.make(), *ImGui::GetDrawData()));
    presenter_->show();
  }
  void turn() {
    desk_.app->of<Canvas>().turn(4, 0);
    draw();
  }
  /// The same frame drawn by one that has all the time.
  render::Image whole() {
    LastPicture output;
    const auto other = make_cpu_presenter(output, Rotation::none, false, [] { return std::int64_t{0}; });
    EXPECT_TRUE(other->begin());
    EXPECT_TRUE(other->draw(frames_.make(), *ImGui::GetDrawData()));
    other->show();
    other->end();
    return output.shown;
  }

  Desk desk_;
  App& app_ = *desk_.app;
  FrameMaker frames_{{app_.of<EditingSession>(), app_.of<Canvas>(), app_.of<CanvasLook>(), app_.of<CanvasDrawing>(),
                      app_.of<Controls>(), app_.of<Preferences>(), app_.of<Cast>()}};
  LastPicture output_;
  std::unique_ptr<Presenter> presenter_;
  std::int64_t now_us_ = 0;
  std::int64_t takes_us_ = 5'000;
};

TEST_F(SlowlyDrawn, QuickPicturesAreAlwaysWhole) {
  draw();
  for (int i = 0; i < 6; ++i) {
    turn();
    EXPECT_EQ(output_.shown, whole()) << i;
  }
}

TEST_F(SlowlyDrawn, AfterSlowPicturesTheViewMovesCoarselyAndIsWholeWhenItRests) {
  takes_us_ = 50'000;
  draw();
  turn();
  turn();
  EXPECT_EQ(output_.shown, whole()) << "it is known only now that they are slow";
  takes_us_ = 10'000;
  for (int i = 0; i < 5; ++i) {
    turn();
    EXPECT_NE(output_.shown, whole()) << i;
    EXPECT_TRUE(presenter_->refining()) << "one more is due without any event";
  }
  now_us_ += 20'000;
  draw();
  EXPECT_NE(output_.shown, whole()) << "a short stop is part of the movement";
  now_us_ += 80'000;
  takes_us_ = 50'000;
  draw();
  EXPECT_EQ(output_.shown, whole());
  takes_us_ = 10'000;
  turn();
  EXPECT_NE(output_.shown, whole()) << "the next movement is coarse from its beginning";
}

TEST_F(SlowlyDrawn, WhatBecameQuickEnoughIsWholeAgain) {
  takes_us_ = 50'000;
  draw();
  turn();
  turn();
  takes_us_ = 10'000;
  turn();
  EXPECT_NE(output_.shown, whole());
  now_us_ += 200'000;
  draw();
  EXPECT_EQ(output_.shown, whole());
  turn();
  EXPECT_EQ(output_.shown, whole()) << "the picture at rest told that it is quick enough now";
}

}  // namespace
}  // namespace penpose::app
