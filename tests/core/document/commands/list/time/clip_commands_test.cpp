#include "core/document/commands/list/time/clip_commands.h"

#include <gtest/gtest.h>

#include "core/document/time/animation_sampling.h"
#include "tests/support/document_hand.h"
#include "tests/support/timelines.h"

namespace penpose::document {
namespace {

using tests::DocumentHand;

/// The sheet with an animation of its two shapes, one of a joint's place alone, and one more of the shapes.
Model animated_sheet() {
  Model model = tests::sheet_model();
  Channel lifted{ChannelTarget::weights, 0, Interpolation::linear, {0, 1, 2}, {0, 0, 0.5, 0, 0.25, 0}};
  Channel placed{ChannelTarget::translation, 0, Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0}};
  Channel leant{ChannelTarget::weights, 0, Interpolation::cubic_spline, {0, 2}, {0, 0, 0, 0, 0, 0.5, 0, 0, 0, 1, 0, 0}};
  model.animations = {{"lift", {lifted, placed}}, {"slide", {placed}}, {"lean", {leant}}};
  return model;
}

double keyed(const Document& document, double time_s, const char* control) {
  return pose_at(document, time_s)[*rig::find_parameter(document.model->rig->parameters(), control)];
}

std::vector<std::string> names_of(const Document& document) {
  std::vector<std::string> names;
  for (const auto& clip : document.clips) names.push_back(clip->name);
  return names;
}

TEST(ClipCommands, AnAnimationOfTheFileOpensWithItsKeys) {
  DocumentHand hand(make_document(animated_sheet()));
  hand.does(OpenClip{0});
  EXPECT_EQ(names_of(hand.document()), std::vector<std::string>{"lift"});
  EXPECT_EQ(keyed(hand.document(), 1, "lift"), 0.5);
  EXPECT_EQ(keyed(hand.document(), 1.5, "lift"), 0.375);
  EXPECT_EQ(keyed(hand.document(), 2, "lift"), 0.25);
  for (const PoseKey& key : hand.document().timeline->keys)
    EXPECT_FALSE(key.controls.has(1)) << "a control that rests has no keys";
  hand.does(OpenClip{2});
  EXPECT_EQ(names_of(hand.document()), (std::vector<std::string>{"lift", "lean"}));
  EXPECT_EQ(hand.document().clip, 1U);
  for (double t = 0; t <= 2; t += 0.125) {
    const auto seen = sample(*hand.document().model, hand.document().model->animations[2], t);
    EXPECT_NEAR(keyed(hand.document(), t, "lean"), seen.weights[1], 1e-12) << t << ": its spline";
  }
}

TEST(ClipCommands, WhatIsNotChangedIsWrittenAsItWas) {
  DocumentHand hand(make_document(animated_sheet()));
  hand.does(OpenClip{0});
  const Model original = animated_sheet();
  const auto same = [&](std::size_t animation) {
    const Model model = model_of(hand.document());
    const Animation& is = model.animations[animation];
    const Animation& was = original.animations[animation];
    if (is.channels.size() != was.channels.size()) return false;
    for (std::size_t c = 0; c < is.channels.size(); ++c) {
      if (is.channels[c].values != was.channels[c].values || is.channels[c].times_s != was.channels[c].times_s)
        return false;
    }
    return is.name == was.name;
  };
  EXPECT_TRUE(same(0) && same(1) && same(2));
  hand.does(SetKeyValues{{{1}, {"lift"}}, {0.75}});
  EXPECT_TRUE(same(1) && same(2));
  const Model model = model_of(hand.document());
  ASSERT_EQ(model.animations.size(), 3U);
  EXPECT_EQ(model.animations[0].name, "lift");
  EXPECT_EQ(sample(model, model.animations[0], 1).weights[0], 0.75);
  const auto& channels = model.animations[0].channels;
  EXPECT_TRUE(std::any_of(channels.begin(), channels.end(), [](const Channel& one) {
    return one.target == ChannelTarget::translation;
  })) << "what the rig has no control for stays";
}

TEST(ClipCommands, TheTimelineThatWasThereIsAClipBesideIt) {
  DocumentHand hand(make_document(animated_sheet()));
  hand.does(SetParameters{{{"lift", 0.9}}});
  hand.does(SetKey{0.5, "own"});
  hand.does(OpenClip{0});
  EXPECT_EQ(names_of(hand.document()), (std::vector<std::string>{"timeline", "lift"}));
  const Model model = model_of(hand.document());
  ASSERT_EQ(model.animations.size(), 4U);
  EXPECT_EQ(model.animations[0].name, "timeline");
  EXPECT_EQ(made_animations(hand.document()), std::vector<std::string>{"timeline"});
  hand.does(ShowClip{0});
  EXPECT_EQ(hand.document().timeline->keys.size(), 1U);
  EXPECT_EQ(hand.document().timeline->keys[0].name, "own");
  EXPECT_EQ(hand.value("lift"), 0.9) << "the pose is the shown clip's";
}

TEST(ClipCommands, ClipsAreAddedDoubledNamedAndDeleted) {
  DocumentHand hand;
  hand.does(SetParameters{{{"lift", 0.5}}});
  hand.does(SetKey{1, ""});
  hand.does(AddClip{"second", true});
  EXPECT_EQ(hand.document().timeline->keys.size(), 1U);
  hand.does(SetParameters{{{"lift", 0.1}}});
  hand.does(SetKey{2, ""});
  hand.does(AddClip{"third", false});
  EXPECT_TRUE(hand.document().timeline->keys.empty());
  hand.does(NameClip{{"3"}});
  EXPECT_EQ(names_of(hand.document()), (std::vector<std::string>{"timeline", "second", "3"}));
  hand.does(ShowClip{0});
  EXPECT_EQ(hand.document().timeline->keys.size(), 1U) << "what was doubled is another one";
  hand.does(ShowClip{1});
  EXPECT_EQ(hand.document().timeline->keys.size(), 2U);
  hand.does(DeleteClip{});
  EXPECT_EQ(names_of(hand.document()), (std::vector<std::string>{"timeline", "3"}));
  EXPECT_EQ(hand.document().timeline->keys.size(), 1U);
  ASSERT_TRUE(hand.undo().ok());
  EXPECT_EQ(hand.document().timeline->keys.size(), 2U);
}

TEST(ClipCommands, ADeletedClipOfTheFileIsGoneFromIt) {
  DocumentHand hand(make_document(animated_sheet()));
  hand.does(OpenClip{0});
  hand.does(OpenClip{2});
  hand.does(ShowClip{0});
  hand.does(DeleteClip{});
  const Model model = model_of(hand.document());
  ASSERT_EQ(model.animations.size(), 2U);
  EXPECT_EQ(model.animations[0].name, "slide");
  EXPECT_EQ(model.animations[1].name, "lean");
  EXPECT_EQ(hand.document().clips[0]->animation, 1U);
}

TEST(ClipCommands, TrimmingKeepsTheCurves) {
  for (const KeyKind kind : tests::k_kinds) {
    DocumentHand hand;
    for (const auto& [time_s, value] : {std::pair{0.0, 0.1}, {1.0, 0.8}, {2.0, 0.3}, {3.0, 0.6}}) {
      hand.does(SetParameters{{{"lift", value}}});
      hand.does(SetKey{time_s, ""});
    }
    hand.does(SetKeyKind{{{0, 1, 2, 3}, {}}, kind});
    const Document before = hand.document();
    hand.does(TrimClip{0.5, 2.5});
    EXPECT_EQ(hand.document().timeline->keys.front().time_s, 0);
    EXPECT_EQ(hand.document().timeline->keys.back().time_s, 2);
    for (double t = 0; t < 2; t += 0.0625)
      EXPECT_NEAR(keyed(hand.document(), t, "lift"), keyed(before, t + 0.5, "lift"), 1e-9)
          << static_cast<int>(kind) << " " << t;
  }
}

TEST(ClipCommands, WhatIsNoClipIsRefused) {
  DocumentHand hand(make_document(animated_sheet()));
  EXPECT_EQ(hand.refuses(OpenClip{3}).what, "there is no such animation");
  EXPECT_EQ(hand.refuses(OpenClip{1}).what, "it moves nothing that the model has a control for");
  EXPECT_EQ(hand.refuses(ShowClip{0}).what, "there is no such clip");
  EXPECT_EQ(hand.refuses(DeleteClip{}).what, "there is one clip only");
  EXPECT_EQ(hand.refuses(AddClip{"lean", false}).what, "\"lean\" is taken");
  EXPECT_EQ(hand.refuses(AddClip{}).what, "a clip needs a name");
  EXPECT_EQ(hand.refuses(TrimClip{1, 1}).place, "to_s");
  EXPECT_EQ(hand.refuses(TrimClip{0, 1}).what, "the clip has no keys");
  hand.does(OpenClip{0});
  EXPECT_EQ(hand.refuses(OpenClip{0}).what, "it is open already");
}

}  // namespace
}  // namespace penpose::document
