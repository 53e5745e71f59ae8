#include "core/document/history.h"

#include <gtest/gtest.h>
#include <set>
#include <string>
#include <vector>

#include "core/document/document_hash.h"
#include "tests/support/document_hand.h"
#include "tests/support/hands/knowing_hand.h"

namespace penpose::document {
namespace {

/// Undoes all that a hand has done, and brings it back, through the same states.
void undo_and_redo_all(tests::SessionScript& script, const DocumentState& first, const std::string& what) {
  // What the hand itself undid is brought back, so that everything lies behind.
  while (script.editor().redo()) {
  }
  const DocumentState last = script.editor().state();
  const std::size_t steps = script.editor().history().undo_count();
  std::vector<DocumentState> on_the_way;
  while (script.editor().undo()) on_the_way.push_back(script.editor().state());
  EXPECT_EQ(on_the_way.size(), steps);
  EXPECT_EQ(script.editor().state(), first) << what;
  for (std::size_t i = 0; i + 1 < on_the_way.size(); ++i) {
    ASSERT_TRUE(script.editor().redo());
    ASSERT_EQ(script.editor().state(), on_the_way[on_the_way.size() - 2 - i]) << what << ", step " << i;
  }
  while (script.editor().redo()) {
  }
  EXPECT_EQ(script.editor().state(), last) << what;
}

TEST(History, UndoingAllGivesTheFirstStateAndRedoingAllTheLast) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    tests::SessionScript script(make_document(tests::sheet_model()));
    const DocumentState first = script.editor().state();
    tests::RandomHand(script, seed).run(40);
    undo_and_redo_all(script, first, "seed " + std::to_string(seed));
  }
}

TEST(History, StepsKeepTheirNamesAndPlacesWhetherDoneOrUndone) {
  tests::SessionScript script(make_document(tests::sheet_model()));
  ASSERT_TRUE(script.editor().perform(SetKey{0, {}}));
  ASSERT_TRUE(script.editor().perform(GoToTime{0.5}));
  ASSERT_TRUE(script.editor().perform(SetHand{2}));
  const auto names = [&] {
    const History& history = script.editor().history();
    std::vector<std::string> all;
    for (std::size_t i = 0; i < history.undo_count() + history.redo_count(); ++i) {
      all.emplace_back(history.called_step(i).name);
    }
    return all;
  };
  const std::vector<std::string> expected{"set_key", "go_to_time", "set_hand"};
  EXPECT_EQ(names(), expected);
  while (script.editor().undo()) EXPECT_EQ(names(), expected);
}

TEST(History, EveryCommandOfTheListCanBeUndone) {
  std::set<std::string> undone;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    tests::SessionScript script(make_document(tests::sheet_model()));
    const DocumentState first = script.editor().state();
    tests::KnowingHand(script, seed).run(120);
    undo_and_redo_all(script, first, "seed " + std::to_string(seed));
    for (; script.editor().history().undo_count() > 0; static_cast<void>(script.editor().undo())) {
      undone.emplace(script.editor().history().next_undo());
    }
  }
  // What needs two controls, or a control that is there, a random hand hardly comes to.
  tests::SessionScript script(make_document(tests::sheet_model()));
  const DocumentState first = script.editor().state();
  const tests::DocumentHand place;
  const auto does = [&](const Command& command) { EXPECT_TRUE(script.perform(command).ok()) << name_of(command); };
  does(BeginDeformer{"up", articulation::Mode::translate, {}, 0, 1});
  does(SketchCurve{articulation::CurveRole::general, place.view, place.diamond(0.8)});
  does(SketchCurve{articulation::CurveRole::specific, place.view, place.diamond(0.4)});
  does(SketchCurve{articulation::CurveRole::reference, place.view, place.line(-0.3, 0, 0.3, 0)});
  does(SketchCurve{articulation::CurveRole::target, place.view, place.line(-0.3, 0.3, 0.3, 0.3)});
  does(RedrawCurve{"up", articulation::CurveRole::target, place.view, place.line(-0.3, 0.25, 0.3, 0.25)});
  does(ChangeDeformer{"up", articulation::Mode::translate, {}, {}, 1.5});
  does(MirrorDeformer{"up", "mirrored"});
  does(RenameDeformer{"mirrored", "other"});
  does(MoveDeformer{"other", 0});
  does(DeleteDeformer{"other"});
  does(DrawBetween{"up", 0.5, place.view, place.line(-0.3, -0.2, 0.3, -0.2)});
  does(DeleteBetween{"up", 0.5});
  does(BeginDeformer{"aside", articulation::Mode::translate, {}, 0, 1});
  does(SketchCurve{articulation::CurveRole::general, place.view, place.diamond(0.7)});
  does(TakeRegion{articulation::Reach::front, {}});
  does(SketchCurve{articulation::CurveRole::specific, place.view, place.diamond(0.3)});
  does(SketchCurve{articulation::CurveRole::reference, place.view, place.line(0, -0.2, 0, 0.2)});
  does(SketchCurve{articulation::CurveRole::target, place.view, place.line(0.15, -0.2, 0.15, 0.2)});
  does(SetParameters{{{"up", 1}, {"aside", 1}}});
  does(BeginCorrection{"both", {}});
  does(SketchCurve{articulation::CurveRole::general, place.view, place.diamond(0.8)});
  does(SketchCurve{articulation::CurveRole::specific, place.view, place.diamond(0.5)});
  does(SketchCurve{articulation::CurveRole::reference, place.view, place.line(-0.1, 0.25, 0.4, 0.25)});
  does(SketchCurve{articulation::CurveRole::target, place.view, place.line(-0.1, 0.05, 0.4, 0.05)});
  does(DeleteCorrection{"both"});
  undo_and_redo_all(script, first, "other targets");
  Model moving = tests::sheet_model();
  moving.animations = {{"lift", {{ChannelTarget::weights, 0, Interpolation::linear, {0, 1}, {0, 0, 1, 0}}}}};
  tests::SessionScript animated(make_document(std::move(moving)));
  EXPECT_TRUE(animated.perform(OpenClip{0}).ok());
  EXPECT_TRUE(animated.editor().undo());
  EXPECT_TRUE(animated.editor().redo());
  undone.emplace(animated.editor().history().next_undo());
  for (; script.editor().history().undo_count() > 0; static_cast<void>(script.editor().undo())) {
    undone.emplace(script.editor().history().next_undo());
  }
  EXPECT_EQ(undone.size(), std::variant_size_v<CommandTypes>) << testing::PrintToString(undone);
}

// An hour's worth of strokes that are never cleared: a step keeps what it changed.
TEST(History, AStepKeepsTheCurvesThatItChangedAlone) {
  ApplyWorkspace work;
  Document document = make_document(tests::sheet_model());
  constexpr std::size_t k_curves = 3000;
  for (std::uint32_t i = 1; i <= k_curves; ++i) {
    PoseCurve curve;
    curve.id = CurveId{i};
    curve.points = {{0, {1, 0, 0}}};
    document.curves.push_back(std::make_shared<const PoseCurve>(std::move(curve)));
  }
  document.last_curve = k_curves;
  const auto last = document.curves.back();
  History history(document);
  document = Document{};
  const long owners = last.use_count();
  for (int i = 0; i < 50; ++i)
    ASSERT_TRUE(history.perform(DeleteCurve{CurveId{static_cast<std::uint32_t>(i + 100)}}, work));
  EXPECT_EQ(last.use_count(), owners) << "no list but the latest names the last curve";
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(history.undo());
  ASSERT_EQ(history.document().curves.size(), k_curves);
  for (std::uint32_t i = 0; i < k_curves; ++i) ASSERT_EQ(history.document().curves[i]->id.value, i + 1);
  for (int i = 0; i < 50; ++i) ASSERT_TRUE(history.redo());
  EXPECT_EQ(history.document().curves.size(), k_curves - 50);
}

// A session of a few hundred kilobytes may set thousands of keys; all of them in every step were gigabytes.
TEST(History, AStepKeepsTheKeysThatItChangedAlone) {
  ApplyWorkspace work;
  History history(make_document(tests::sheet_model()));
  constexpr int k_keys = 300;
  for (int i = 0; i < k_keys; ++i) ASSERT_TRUE(history.perform(SetKey{i * 0.5, "key"}, work));
  const auto latest = history.document().timeline;
  ASSERT_TRUE(history.undo());
  const std::weak_ptr<const Timeline> before = history.document().timeline;
  ASSERT_TRUE(history.redo());
  EXPECT_EQ(*history.document().timeline, *latest);
  EXPECT_TRUE(before.expired()) << "no step holds a whole timeline";
  for (int i = 0; i < k_keys; ++i) ASSERT_TRUE(history.undo());
  EXPECT_TRUE(history.document().timeline->keys.empty());
  for (int i = 0; i < k_keys; ++i) ASSERT_TRUE(history.redo());
  EXPECT_EQ(*history.document().timeline, *latest);
}

TEST(History, ACommandAfterUndoGivesUpWhatWasUndone) {
  ApplyWorkspace work;
  History history(make_document(tests::sheet_model()));
  ASSERT_TRUE(history.perform(SetParameters{{{"lift", 0.5}}}, work));
  ASSERT_TRUE(history.perform(SetParameters{{{"lift", 0.75}}}, work));
  ASSERT_TRUE(history.undo());
  EXPECT_EQ(history.document().pose[0], 0.5);
  EXPECT_EQ(history.next_redo(), "set_parameters");
  ASSERT_TRUE(history.perform(SetParameters{{{"lean", 0.25}}}, work));
  EXPECT_EQ(history.redo_count(), 0U);
  const auto nothing = history.redo();
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().what, "there is nothing to redo");
}

TEST(History, AFailedCommandIsNoStep) {
  ApplyWorkspace work;
  History history(make_document(tests::sheet_model()));
  EXPECT_FALSE(history.perform(SetParameters{{{"lift", 7}}}, work));
  EXPECT_EQ(history.undo_count(), 0U);
  EXPECT_FALSE(history.undo());
}

TEST(History, StepsShareTheMesh) {
  ApplyWorkspace work;
  History history(make_document(tests::sheet_model()));
  const auto mesh = history.document().model->mesh;
  const long owners = mesh.use_count();
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(history.perform(SetParameters{{{"lift", i * 0.01}}}, work));
  }
  EXPECT_EQ(history.document().model->mesh, mesh);
  EXPECT_EQ(mesh.use_count(), owners) << "a step holds the model that was there, not a copy";
}

}  // namespace
}  // namespace penpose::document
