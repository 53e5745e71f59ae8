#include "core/document/suggestion.h"

#include <gtest/gtest.h>
#include <limits>

#include "tests/support/document_hand.h"
#include "tests/support/models/test_rigs.h"

namespace penpose::document {
namespace {

using tests::DocumentHand;

/// Keys in which the lean and a turn go with the lift.
void key_moods(DocumentHand& hand) {
  double time_s = 0;
  for (const double lift : {0.2, 0.5, 0.9, 0.7}) {
    hand.does(SetParameters{{{"lift", lift}, {"lean", 0.8 * lift}, {"base.rz", -0.3 * lift}}});
    hand.does(SetKey{time_s, ""});
    time_s += 0.5;
  }
  hand.does(ResetParameters{});
}

TEST(SuggestRest, MovesTheRestAsTheKeysGoAndNeverWhatIsHeld) {
  DocumentHand hand;
  key_moods(hand);
  hand.does(SetParameters{{{"lift", 0.6}}});
  const auto before = hand.state();
  DocumentHand whole(hand.document());
  whole.does(SuggestRest{{"lift"}});
  EXPECT_EQ(whole.value("lift"), 0.6);
  EXPECT_NEAR(whole.value("lean"), 0.48, 0.1);
  EXPECT_NEAR(whole.value("base.rz"), -0.18, 0.1);
  EXPECT_EQ(whole.value("base.rx"), 0) << "no key turns it";
  // Half of the way at half strength, and nothing at none.
  DocumentHand half(hand.document());
  half.does(SuggestRest{{"lift"}, 0.5});
  EXPECT_NEAR(half.value("lean"), 0.5 * whole.value("lean"), 1e-12);
  DocumentHand none(hand.document());
  none.does(SuggestRest{{"lift"}, 0});
  EXPECT_EQ(none.state(), before);
  // What is locked is held, whatever the command says.
  hand.does(LockParameters{{"lean"}, true});
  hand.does(SuggestRest{{"lift"}});
  EXPECT_EQ(hand.value("lean"), 0);
  EXPECT_NE(hand.value("base.rz"), 0);
}

TEST(SuggestRest, WhatIsWrongIsSaidAndNothingChanges) {
  DocumentHand hand;
  hand.does(SetParameters{{{"lift", 0.6}}});
  EXPECT_EQ(hand.refuses(SuggestRest{{"lift"}}).what, "no pose is keyed yet");
  hand.does(SetKey{0, ""});
  hand.does(SetParameters{{{"lift", 0.4}}});
  EXPECT_EQ(hand.refuses(SuggestRest{{"lift"}}).what, "only one pose is keyed yet");
  hand.does(SetKey{1, ""});
  EXPECT_EQ(hand.refuses(SuggestRest{{"lift"}}).what, "only one pose is keyed yet, beside the pose as it stands");
  hand.does(SetParameters{{{"lift", 0.1}}});
  EXPECT_EQ(hand.refuses(SuggestRest{{"lift", "nose"}}).place, "held");
  EXPECT_EQ(hand.refuses(SuggestRest{}).what, "nothing is posed yet, so that there is nothing to suggest the rest of");
  EXPECT_EQ(hand.refuses(SuggestRest{{"lift"}, 1.5}).place, "strength");
  EXPECT_EQ(hand.refuses(SuggestRest{{"lift"}, -0.1}).place, "strength");
  EXPECT_EQ(hand.refuses(SuggestRest{{"lift"}, std::numeric_limits<double>::quiet_NaN()}).place, "strength");
  EXPECT_NE(hand.refuses(SuggestRest{{"base.ry"}}).what.find("no key moves what is posed now"), std::string::npos);
  hand.does(SuggestRest{{"lift"}});
}

TEST(PosedParameters, AreNeitherAtRestNorAsTheTimelineHasThem) {
  DocumentHand hand;
  EXPECT_TRUE(posed_parameters(hand.document()).empty());
  hand.does(SetParameters{{{"lift", 0.5}, {"lean", 0.2}}});
  EXPECT_EQ(posed_parameters(hand.document()), (std::vector<std::string>{"lift", "lean"}));
  // On the way to the next pose: what was only carried along from the key is none of it.
  hand.does(SetKey{0, ""});
  EXPECT_EQ(posed_parameters(hand.document()), (std::vector<std::string>{"lift", "lean"})) << "it is the keyed pose";
  hand.does(SetParameters{{{"base.rx", 0.3}}});
  EXPECT_EQ(posed_parameters(hand.document()), std::vector<std::string>{"base.rx"});
  hand.does(ResetParameters{});
  hand.does(SetParameters{{{"base.rx", 0.3}}});
  EXPECT_EQ(posed_parameters(hand.document()), std::vector<std::string>{"base.rx"}) << "nor is what went back to rest";
  hand.does(LockParameters{{"lean"}, true});
  EXPECT_EQ(posed_parameters(hand.document()), (std::vector<std::string>{"lean", "base.rx"}));
}

/// A grid whose left half one shape moves and whose right half another; a third moves all of it.
Document halves() {
  const auto mesh = tests::grid_mesh(12, 12, 2, 2);
  std::vector<rig::BlendShape> shapes(3);
  const char* names[] = {"left", "right", "all"};
  for (std::size_t s = 0; s < 3; ++s) {
    shapes[s].parameter.name = names[s];
    for (std::uint32_t v = 0; v < mesh->vertex_count(); ++v) {
      const bool left = mesh->positions()[v].x < 1;
      if (s == 2 || left == (s == 0)) {
        shapes[s].vertices.push_back(v);
        shapes[s].deltas.emplace_back(0, 0.2, 0);
      }
    }
  }
  return make_document(
      make_model(mesh, rig::BlendShapes::make(std::move(shapes), mesh->vertex_count()).value(), nullptr).value());
}

TEST(PosedParameters, WhatHasASayInADrawnLineIsHeldThoughItIsAtRest) {
  DocumentHand hand(halves());
  const Document& document = hand.document();
  hand.view.camera = {{1, 1, 6}, {1, 1, 0}, {0, 1, 0}, 30};
  const auto camera = geometry::Camera::make(hand.view.camera, hand.view.viewport).value();
  const auto line = [&](double y) {
    std::vector<PxPoint> out;
    for (int i = 0; i <= 20; ++i) out.push_back(*camera.project({0.1 + 0.03 * i, y, 0}));
    return out;
  };
  hand.does(DrawReference{hand.view, line(1)});
  EXPECT_TRUE(posed_parameters(document).empty()) << "a line without a target asks for nothing";
  hand.does(DrawTarget{CurveId{1}, hand.view, line(1), {}});
  EXPECT_EQ(document.pose, rig::rest_pose(*document.model->rig)) << "drawn where it is";
  EXPECT_EQ(posed_parameters(document), (std::vector<std::string>{"left", "all"}));
  // So the suggestion leaves the drawn line where it was drawn.
  const auto drawn = positions_of(document, document.curves.front()->points);
  hand.does(SetKey{0, ""});
  for (const double much : {0.3, 0.6, 0.9}) {
    hand.does(SetParameters{{{"left", 0.5 * much}, {"right", much}, {"all", 0.2 * much}}});
    hand.does(SetKey{1 + much, ""});
  }
  hand.does(ResetParameters{});
  hand.does(LockParameters{{"all"}, true});
  hand.does(LockParameters{{"all"}, false});
  const auto suggestion = suggest_rest(document);
  ASSERT_TRUE(suggestion.ok()) << suggestion.error().line();
  hand.does(suggestion->command);
  EXPECT_EQ(hand.document().pose, suggestion->pose) << "what was shown is what the command does";
  EXPECT_EQ(positions_of(document, document.curves.front()->points), drawn);
}

TEST(Suggestion, TheWindowsOfferIsTheCommandAtTheStrengthThatTheKeysVouchFor) {
  DocumentHand hand;
  EXPECT_EQ(no_suggestion(hand.document())->what, "no pose is keyed yet");
  key_moods(hand);
  EXPECT_FALSE(no_suggestion(hand.document()));
  const auto nothing = suggest_rest(hand.document());
  ASSERT_FALSE(nothing.ok());
  EXPECT_EQ(nothing.error().what, "nothing is posed yet, so that there is nothing to suggest the rest of");
  hand.does(SetParameters{{{"lift", 0.6}}});
  const auto offer = suggest_rest(hand.document());
  ASSERT_TRUE(offer.ok());
  EXPECT_EQ(offer->keys, 4U);
  EXPECT_EQ(offer->command.held, std::vector<std::string>{"lift"});
  EXPECT_GT(offer->command.strength, 0.8) << "the keys go together";
  hand.does(offer->command);
  EXPECT_EQ(hand.document().pose, offer->pose);
}

}  // namespace
}  // namespace penpose::document
