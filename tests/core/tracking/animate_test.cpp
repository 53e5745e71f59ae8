#include "core/tracking/animate.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/document/time/animation_sampling.h"
#include "tests/support/models/sheet_model.h"

namespace penpose::tracking {
namespace {

constexpr std::string_view k_take =
    "Timecode,BlendShapeCount,Lift,TongueOut,HeadYaw\n0:0:0:0,3,0.25,0,0\n0:0:0:1,3,0.5,0,0.2\n";

/// A take of values on the bent sheet.
class Animate : public testing::Test {
 protected:
  base::Result<Animated> animate(const AnimateOptions& options = {}, std::string_view take = k_take) {
    auto read = io::read_track(base::as_bytes(take), nullptr, {}).value();
    const auto map = io::read_bundled_map(*read.format).value();
    return tracking::animate(document, std::move(read.track), map, options, {}, &blamed);
  }
  [[nodiscard]] double lift_at(const document::Document& of, std::size_t animation, double time_s) const {
    const auto& model = *of.model;
    return document::model_at(model, document::sample(model, model.animations[animation], time_s)).value().pose[0];
  }

  document::Document document = document::make_document(tests::sheet_model());
  AnimateInput blamed{};
};

TEST_F(Animate, MakesTheFirstAnimationOfADocumentAndLeavesTheOther) {
  rig::Pose open = document.pose;
  open[0] = 1;
  document.timeline =
      std::make_shared<const document::Timeline>(document::Timeline{{{0, document.pose, "a"}, {1, open, "b"}}});
  const auto animated = animate();
  ASSERT_TRUE(animated) << animated.error().line();
  ASSERT_EQ(animated->document.model->animations.size(), 2U);
  EXPECT_EQ(animated->document.model->animations[0].name, "tracked");
  EXPECT_DOUBLE_EQ(lift_at(animated->document, 0, 10), 0.5);
  EXPECT_DOUBLE_EQ(lift_at(animated->document, 1, 10), 1);
  EXPECT_TRUE(animated->document.timeline->keys.empty());
  EXPECT_EQ(animated->document.pose[0], 0.25) << "the first frame is shown";
  EXPECT_TRUE(document.model->animations.empty());
  EXPECT_EQ(animated->unmatched, (std::vector<std::string>{"TongueOut", "HeadYaw"}));
  ASSERT_EQ(animated->poses.size(), 2U);
  EXPECT_EQ(animated->poses[1][0], 0.5);
}

TEST_F(Animate, TurnsTheHeadWhereAsked) {
  AnimateOptions options;
  options.apply_head = true;
  const auto turned = animate(options);
  ASSERT_TRUE(turned) << turned.error().line();
  EXPECT_EQ(turned->unmatched, std::vector<std::string>{"TongueOut"});
  EXPECT_GT(turned->document.model->animations[0].channels.size(),
            animate()->document.model->animations[0].channels.size());
}

TEST_F(Animate, TakesAFrameRateInsteadOfTheTracksTimes) {
  AnimateOptions options;
  options.fps = 10;
  const auto animated = animate(options);
  ASSERT_TRUE(animated) << animated.error().line();
  EXPECT_TRUE(animated->whole_frames);
  EXPECT_DOUBLE_EQ(animated->fps, 10);
  EXPECT_DOUBLE_EQ(animated->times_s[1], 0.1);
}

TEST_F(Animate, SaysWhatIsWrongAndWhichInputIsToBlame) {
  EXPECT_FALSE(animate({}, "Timecode,BlendShapeCount,TongueOut\n0:0:0:0,1,0.5\n"));
  EXPECT_EQ(blamed, AnimateInput::track);
  const auto refuses = [&](auto member, double value, const char* place) {
    AnimateOptions options;
    options.*member = value;
    const auto animated = animate(options);
    ASSERT_FALSE(animated) << place << value;
    EXPECT_EQ(animated.error().place, place);
  };
  for (const double wrong : {-1.0, 1e9, std::nan("")}) {
    refuses(&AnimateOptions::smooth_s, wrong, "smooth");
    refuses(&AnimateOptions::least_confidence, wrong, "confidence");
    refuses(&AnimateOptions::fps, wrong, "fps");
    refuses(&AnimateOptions::tremor_px, wrong, "tremor");
  }
  auto bare = tests::sheet_model();
  document = document::make_document(document::make_model(bare.mesh, nullptr, nullptr).value());
  EXPECT_FALSE(animate());
  EXPECT_EQ(blamed, AnimateInput::model);
}

TEST_F(Animate, AFormatIsToldByItsTextOrNamed) {
  EXPECT_EQ(io::read_track(base::as_bytes(k_take), nullptr, {})->format->name, "arkit");
  EXPECT_FALSE(io::read_track(base::as_bytes(k_take), io::track_format_named("openface"), {}));
  for (const std::string_view text : {"", "\xff\xfeT", "good morning"})
    EXPECT_FALSE(io::read_track(base::as_bytes(text), nullptr, {})) << text;
}

}  // namespace
}  // namespace penpose::tracking
