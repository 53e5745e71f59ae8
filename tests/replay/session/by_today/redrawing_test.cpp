#include <gtest/gtest.h>

#include "core/base/edition.h"
#include "replay/session/session_player.h"
#include "tests/support/models/sheet_model.h"

// Sessions of older editions by today's reading: what their commands are, and which steps undo takes back.

namespace penpose::replay {
namespace {

using document::KeyKind;

document::Document sheet() { return document::make_document(tests::sheet_model()); }

/// A session of the sheet in an edition whose timelines have one kind of key.
std::string session(std::initializer_list<std::string> lines, std::uint32_t edition = 4) {
  document::HashForm form;
  if (edition <= 4) form = {KeyKind::smooth, false};
  std::string text = "# penpose session edition=" + std::to_string(edition) + " program=test\n# penpose model " +
                     document::DocumentHasher(form)(sheet()).whole.hex() + " path=sheet\n";
  for (const std::string& line : lines) text += "# penpose " + line + "\n";
  return text;
}

ReplayResult played(const std::string& text) {
  PlayerOptions options;
  options.open = tests::open_sheet;
  options.by_today = true;
  auto result = play_session(read_from(base::as_bytes(text)), options);
  EXPECT_TRUE(result) << result.error().line();
  return std::move(result).value();
}

const document::Timeline& timeline_of(const ReplayResult& result) {
  return *result.session->editor().document().timeline;
}
double lift_of(const ReplayResult& result) { return result.session->editor().document().pose[0]; }

/// "0 linear, 1 linear": the moments of keys and the kind of all controls there.
std::string keys_of(const ReplayResult& result) {
  std::string out;
  for (const document::PoseKey& key : timeline_of(result).keys) {
    const KeyKind kind = key.controls[0].kind;
    for (std::size_t p = 0; p < key.pose.size(); ++p) EXPECT_EQ(key.controls[p].kind, kind);
    if (!out.empty()) out += ", ";
    out += std::to_string(key.time_s).substr(0, 4) + (kind == KeyKind::linear ? " linear" : " smooth");
  }
  return out;
}

TEST(Redrawing, AKeyThatWasDeletedIsDeletedWithAllItsControls) {
  EXPECT_EQ(keys_of(played(session({"do set_key", "do set_key time_s=1", "do delete_key"}))), "1.00 smooth");
}

TEST(Redrawing, AKeyThatWasMovedComesToItsMomentToTheBit) {
  const std::pair<std::string, std::string> moves[] = {{"10", "0.1"}, {"0.1", "0.3"}, {"7.7", "0"}, {"0", "1e-7"}};
  for (const auto& [from, to] : moves) {
    const ReplayResult result =
        played(session({"do set_key time_s=" + from + " name=smile", "do move_key from_s=" + from + " to_s=" + to}));
    ASSERT_EQ(timeline_of(result).keys.size(), 1U);
    EXPECT_EQ(timeline_of(result).keys[0].time_s, std::stod(to)) << "from " << from;
    EXPECT_EQ(timeline_of(result).keys[0].name, "smile");
  }
}

TEST(Redrawing, AKeyThatWasNotMovedOntoAnotherIsNotMovedToday) {
  const ReplayResult result =
      played(session({"do set_key", "do set_key time_s=1", "do move_key to_s=1", "do set_key time_s=2"}));
  EXPECT_EQ(keys_of(result), "0.00 smooth, 1.00 smooth, 2.00 smooth");
  ASSERT_EQ(result.redrawn->steps.size(), 4U);
  EXPECT_EQ(result.redrawn->steps[2].what, "move_key");
  EXPECT_EQ(result.redrawn->steps[2].line, 5U);
  EXPECT_NE(result.redrawn->steps[2].reason.find("another key is at that moment"), std::string::npos);
}

TEST(Redrawing, TheInterpolationOfATimelineIsThatOfItsKeysAndOfThoseToCome) {
  EXPECT_EQ(
      keys_of(played(session({"do set_key", "do set_key_interpolation interpolation=linear", "do set_key time_s=1"}))),
      "0.00 linear, 1.00 linear");
  EXPECT_EQ(keys_of(played(session({"do set_key_interpolation interpolation=linear", "do set_key",
                                    "do set_key_interpolation", "do set_key time_s=1"}))),
            "0.00 smooth, 1.00 smooth");
}

TEST(Redrawing, UndoTakesBackWhatItTookBackThenHoweverManyStepsThatIsToday) {
  const std::string linear = "do set_key_interpolation interpolation=linear";
  EXPECT_EQ(keys_of(played(session({linear, "do set_key", "do set_key time_s=1", "undo"}))), "0.00 linear");
  EXPECT_EQ(keys_of(played(session({linear, "do set_key", "do set_key time_s=1", "undo", "undo", "redo", "redo"}))),
            "0.00 linear, 1.00 linear");
  // The interpolation was set when there was no key, which is no step today.
  EXPECT_EQ(keys_of(played(session({"do set_key", "undo", linear, "undo", "do set_key time_s=1"}))), "1.00 smooth");
  EXPECT_EQ(keys_of(played(session({linear, "undo", "redo", "do set_key time_s=1"}))), "1.00 linear");
}

std::string state(char digit) {
  return "state " + std::string(32, digit) + " model=00000000 deformers=00000000 parameters=00000000 curves=00000000" +
         " keys=00000000";
}

TEST(Redrawing, UndoOfAStepThatIsNoneTodayTakesBackNothing) {
  const ReplayResult result = played(session({"do set_parameters values=lift,0.25", state('1'),
                                              "do set_parameters values=gone,1", state('2'), "undo", state('1')}));
  EXPECT_EQ(lift_of(result), 0.25);
  EXPECT_EQ(result.redrawn->count(CameOut::not_drawn), 1U);
  EXPECT_EQ(result.redrawn->steps[1].line, 5U);
  EXPECT_NE(text_of(result.redrawn->steps[1]).find("set_parameters (line 5): could not be drawn"), std::string::npos);
}

TEST(Redrawing, UndoAfterAStepThatWasNoneThenTakesBackTheOneBeforeToo) {
  const ReplayResult result = played(session({"do set_parameters values=lift,0.25", state('1'),
                                              "do set_parameters values=lift,0.5", state('1'), "undo", state('0')}));
  EXPECT_EQ(lift_of(result), 0);
}

TEST(Redrawing, WhatCannotBeExpressedIsNamedAndTheRestIsDrawn) {
  const ReplayResult result = played(session(
      {"do set_key_interpolation interpolation=stepped", "do dance", "do delete_key at=1", "do set_key time_s=1"}));
  EXPECT_EQ(keys_of(result), "1.00 smooth");
  EXPECT_EQ(result.redrawn->count(CameOut::not_drawn), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(result.redrawn->steps[i].line, 3 + i);
    EXPECT_FALSE(result.redrawn->steps[i].reason.empty());
  }
  EXPECT_NE(summary_of(*result.redrawn).find("3 could not be drawn, 1 cannot be compared"), std::string::npos);
}

TEST(Redrawing, CommandsThatWentAreNoneOfLaterEditions) {
  const ReplayResult result = played(session({"do set_key", "do delete_key"}, 5));
  EXPECT_EQ(keys_of(result), "0.00 smooth");
  EXPECT_EQ(result.redrawn->count(CameOut::not_drawn), 1U);
}

TEST(Redrawing, SaysWhichPartsDifferAndSinceWhen) {
  document::DocumentHasher hasher(document::HashForm{KeyKind::smooth, false});
  document::DocumentState first = hasher(sheet());
  first.whole.low ^= 1;
  first.parts[static_cast<std::size_t>(document::StatePart::keys)] ^= 1;
  const std::string differs = to_text(StateReached{first}).substr(std::string("penpose ").size());
  const ReplayResult result =
      played(session({"do set_parameters values=lift,0.25", differs, "do reset_parameters", differs}));
  ASSERT_EQ(result.redrawn->count(CameOut::differently), 2U);
  const std::vector<std::string_view> both{"parameters", "keys"};
  EXPECT_EQ(result.redrawn->steps[0].parts, both);
  EXPECT_EQ(result.redrawn->steps[0].since, both);
  EXPECT_EQ(result.redrawn->steps[1].parts, std::vector<std::string_view>{"keys"});
  EXPECT_TRUE(result.redrawn->steps[1].since.empty());
}

TEST(Redrawing, AnotherStateOfTheModelIsRefusedUnlessItMayDiffer) {
  std::string text = session({"do set_key"});
  text[text.find("model ") + 6] ^= 1;
  PlayerOptions options;
  options.open = tests::open_sheet;
  options.by_today = true;
  const auto refused = play_session(read_from(base::as_bytes(text)), options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().place, "line 2");
  options.may_differ = [](const std::string& path) { return path == "sheet"; };
  const auto drawn = play_session(read_from(base::as_bytes(text)), options);
  ASSERT_TRUE(drawn) << drawn.error().line();
  EXPECT_TRUE(drawn->redrawn->other_model);
  EXPECT_EQ(keys_of(*drawn), "0.00 smooth");
}

TEST(Redrawing, NewerEditionsAndNoneAreRefusedWithOneLine) {
  for (const std::string& edition : {"edition=" + std::to_string(base::k_edition + 1), std::string("1")}) {
    std::string text = session({"do set_key"});
    text.replace(text.find("edition=4"), 9, edition);
    PlayerOptions options;
    options.open = tests::open_sheet;
    options.by_today = true;
    const auto refused = play_session(read_from(base::as_bytes(text)), options);
    ASSERT_FALSE(refused) << edition;
    EXPECT_EQ(refused.error().place, "line 1");
    EXPECT_NE(refused.error().what.find("another edition"), std::string::npos);
    EXPECT_EQ(refused.error().line().find('\n'), std::string::npos);
    EXPECT_EQ(refused.error().line().find("--by-today"), std::string::npos) << "it would not help";
  }
}

TEST(Redrawing, SessionsOfTwoEditionsThatWereJoinedAreRefused) {
  std::string text = session({"do set_key"});
  const auto joined = [&](std::uint32_t edition) {
    PlayerOptions options;
    options.open = tests::open_sheet;
    options.by_today = true;
    const std::string whole = text + session({"do set_key time_s=1"}, edition);
    return play_session(read_from(base::as_bytes(whole)), options);
  };
  EXPECT_TRUE(joined(4));
  ASSERT_FALSE(joined(5));
  EXPECT_EQ(joined(5).error().place, "line 4");
}

}  // namespace
}  // namespace penpose::replay
