#include "core/tracking/animate.h"

#include <algorithm>
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

TEST_F(Animate, StretchedItsFramesFollowEachOtherAtTheRateThatIsAskedFor) {
  AnimateOptions options;
  options.stretch = 10;
  const auto animated = animate(options);
  ASSERT_TRUE(animated) << animated.error().line();
  EXPECT_TRUE(animated->whole_frames);
  EXPECT_DOUBLE_EQ(animated->fps, 10);
  EXPECT_DOUBLE_EQ(animated->times_s[1], 0.1);
}

TEST_F(Animate, AtAnotherRateTheTakeKeepsItsLength) {
  const std::string_view take =
      "Timecode,BlendShapeCount,Lift\n00:00:00:00.000,1,0\n00:00:00:30.000,1,0.5\n00:00:01:00.000,1,1\n";
  const auto own = animate({}, take);
  ASSERT_TRUE(own) << own.error().line();
  AnimateOptions options;
  options.fps = 10 / own->times_s.back();
  const auto animated = animate(options, take);
  ASSERT_TRUE(animated) << animated.error().line();
  ASSERT_EQ(animated->times_s.size(), 11U);
  EXPECT_NEAR(animated->times_s.back(), own->times_s.back(), 1e-9);
  for (std::size_t k = 0; k < 11; ++k) EXPECT_NEAR(animated->poses[k][0], 0.1 * static_cast<double>(k), 1e-9) << k;
}

TEST_F(Animate, TheValuesOfTheNeutralFrameAreRest) {
  AnimateOptions options;
  options.neutral = 0;
  const auto animated = animate(options);
  ASSERT_TRUE(animated) << animated.error().line();
  EXPECT_DOUBLE_EQ(animated->poses[0][0], 0);
  EXPECT_DOUBLE_EQ(animated->poses[1][0], 0.25);
  options.neutral = 2;
  EXPECT_EQ(animate(options).error().place, "neutral");
}

TEST_F(Animate, SaysWhichOptionsDoNothingForValues) {
  AnimateOptions options;
  options.tremor_px = 2;
  options.least_confidence = 0.5;
  options.units = true;
  const auto animated = animate(options);
  ASSERT_TRUE(animated) << animated.error().line();
  for (const char* option : {"--tremor", "--confidence", "--units"}) {
    EXPECT_TRUE(std::any_of(animated->notes.begin(), animated->notes.end(), [&](const std::string& note) {
      return note.starts_with(std::string(option) + " has no effect");
    })) << option;
  }
}

TEST_F(Animate, AMapGivesAColumnGainOffsetResponseAndSeveralControls) {
  const std::string_view text = R"({"format": "arkit", "names": {"TongueOut": [
      {"control": "lift", "gain": 0.5, "offset": 0.1}, {"control": "lean", "response": [[0, 0], [0.5, 0.8], [1, 1]]}]}})";
  auto map = io::read_map_file(base::as_bytes(text));
  ASSERT_TRUE(map) << map.error().line();
  auto read = io::read_track(base::as_bytes(std::string_view("Timecode,BlendShapeCount,TongueOut\n0:0:0:0,1,0.25\n"
                                                             "0:0:0:1,1,0.75\n")),
                             nullptr, {})
                  .value();
  const auto animated = tracking::animate(document, std::move(read.track), *map);
  ASSERT_TRUE(animated) << animated.error().line();
  EXPECT_NEAR(animated->poses[0][0], 0.225, 1e-12);
  EXPECT_NEAR(animated->poses[1][0], 0.475, 1e-12);
  const std::size_t lean = rig::find_parameter(document.model->rig->parameters(), "lean").value();
  EXPECT_NEAR(animated->poses[0][lean], 0.4, 1e-12);
  EXPECT_NEAR(animated->poses[1][lean], 0.9, 1e-12);
}

TEST_F(Animate, NamesWithoutAControlComeWithTheNearestOne) {
  const auto animated = animate({}, "Timecode,BlendShapeCount,Lift,Leam\n0:0:0:0,2,0.25,1\n0:0:0:1,2,0.5,1\n");
  ASSERT_TRUE(animated) << animated.error().line();
  EXPECT_EQ(animated->unmatched, std::vector<std::string>{"Leam"});
  EXPECT_EQ(animated->nearest, std::vector<std::string>{"lean"});
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
