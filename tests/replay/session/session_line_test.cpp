#include "replay/session/session_line.h"

#include <gtest/gtest.h>
#include <set>

namespace penpose::replay {
namespace {

std::vector<SessionLine> full_lines() {
  const document::View view{{{0.1, 0.2, 3}, {0, 0, 0}, {0, 1, 0}, 27.5}, {1920, 1080}};
  TabletSetting setting;
  setting.keep_aspect = setting.left_handed = true;
  setting.quarter_turns = 3;
  setting.area = {0.1, 0.2, 0.9, 1};
  setting.pressure = {{0, 0}, {0.3, 0.7}};
  drawing::Tool tool{drawing::ToolKind::redraw, document::CurveId{4}, true, "a b", articulation::CurveRole::general};
  document::DocumentState state;
  state.whole = {0x0123456789abcdefULL, 0xfedcba9876543210ULL};
  state.parts = {0, 1, 0xffffffffU, 0x80000000U, 0xabcdef01U};
  return {SessionBegins{"penpose 1.0 (test)"},
          SessionBegins{},
          ModelNamed{{1, 0xffffffffffffffffULL},
                     "/home/a b/h\xc3\xa9"
                     "ad.glb"},
          ModelNamed{},
          ViewChanged{view},
          ToolChosen{tool},
          ToolChosen{},
          TabletSet{3, setting},
          TabletSet{},
          TabletGone{9999},
          LightsSeen{7, {3, 1}},
          LightsSeen{},
          PenPlace{true},
          PenPlace{false},
          Performed{document::SetKey{0.5, "x y"}},
          Performed{document::SolvePose{}},
          Undone{},
          Redone{},
          StateReached{state}};
}

TEST(SessionLine, EveryLineReadsBackAsItWas) {
  std::set<std::size_t> seen;
  for (const SessionLine& line : full_lines()) {
    seen.insert(line.index());
    const std::string text = to_text(line);
    EXPECT_EQ(text.find('\n'), std::string::npos);
    const auto again = parse_session_line("# " + text);
    ASSERT_TRUE(again.ok()) << text << ": " << again.error().line();
    ASSERT_TRUE(again->has_value()) << text;
    EXPECT_EQ(**again, line) << text;
  }
  EXPECT_EQ(seen.size(), std::variant_size_v<SessionLine>) << "a line without an example here";
}

TEST(SessionLine, ThereAreNoMoreThanFourLights) {
  EXPECT_TRUE(parse_session_line("# penpose lights 1 left=3").ok());
  EXPECT_FALSE(parse_session_line("# penpose lights 1 left=4").ok());
  EXPECT_FALSE(parse_session_line("# penpose lights left=1").ok());
}

TEST(SessionLine, IsWrittenAsTheFormatSays) {
  EXPECT_EQ(to_text(LightsSeen{7, {2, 0}}), "penpose lights 7 left=2");
  EXPECT_EQ(to_text(SessionBegins{"penpose"}), "penpose session edition=11 program=penpose");
  EXPECT_EQ(to_text(ModelNamed{{1, 2}, "head.glb"}), "penpose model 00000000000000010000000000000002 path=head.glb");
  EXPECT_EQ(to_text(Performed{document::DeleteKeys{{{1.5}, {}}}}), "penpose do delete_keys times_s=1.5");
  EXPECT_EQ(to_text(PenPlace{false}), "penpose panel");
  document::DocumentState state;
  state.parts[4] = 0xbeef;
  EXPECT_EQ(to_text(StateReached{state}),
            "penpose state 00000000000000000000000000000000 model=00000000 deformers=00000000 parameters=00000000 "
            "curves=00000000 keys=0000beef");
}

TEST(SessionLine, OtherCommentsAreNoneOfOurs) {
  for (const char* comment : {"#", "# ", "", "# a note", "#penpose undo", "# penposed undo", "penpose undo",
                              "#  penpose undo", "# PENPOSE undo"}) {
    const auto line = parse_session_line(comment);
    ASSERT_TRUE(line.ok()) << comment;
    EXPECT_FALSE(line->has_value()) << comment;
  }
}

TEST(SessionLine, AnotherEditionIsRefusedByItsProgramsName) {
  for (const char* edition : {"1", "edition=1", "edition=0", "edition=1.5", "edition=x", "edition=", "x", "",
                              "edition=18446744073709551617", "edition=-1"}) {
    const auto line = parse_session_line(std::string("# penpose session ") + edition + " program=penpose-0.2.0");
    ASSERT_FALSE(line.ok()) << edition;
    EXPECT_NE(line.error().what.find("penpose-0.2.0"), std::string::npos) << line.error().line();
    EXPECT_EQ(line.error().line().find('\n'), std::string::npos);
    EXPECT_FALSE(line.error().remedy.empty());
  }
}

TEST(SessionLine, WhatHasAnotherFormIsRefused) {
  const std::string hash(32, 'a');
  for (const std::string& text :
       {std::string(""),
        std::string("dance"),
        std::string("undo now"),
        std::string("canvas 1"),
        std::string("view"),
        std::string("view 1/2"),
        std::string("model"),
        std::string("model path=a"),
        "model " + hash.substr(1),
        "model " + hash + "a",
        "model +" + hash.substr(1),
        "model " + hash.substr(1) + "g",
        "model " + hash + " size=3",
        std::string("tablet"),
        std::string("tablet -1"),
        std::string("tablet 10000"),
        std::string("tablet 0 area=a"),
        std::string("tablet 0 turns=1"),
        std::string("gone"),
        std::string("gone x"),
        std::string("tool kind=brush"),
        std::string("tool pose"),
        std::string("do"),
        std::string("do dance"),
        std::string("do set_key time_s=x"),
        "state " + hash,
        "state " + hash + " model=00000000",
        "state " + hash + " model=00000000 deformers=0000000 parameters=00000000 curves=00000000 keys=00000000",
        "state " + hash + " model=+0000000 deformers=00000000 parameters=00000000 curves=00000000 keys=00000000",
        "state " + hash + " deformers=00000000 model=00000000 parameters=00000000 curves=00000000 keys=00000000"}) {
    const auto line = parse_session_line("# penpose " + text);
    EXPECT_FALSE(line.ok()) << text;
    if (line.ok()) continue;
    EXPECT_EQ(line.error().line().find('\n'), std::string::npos);
  }
}

TEST(SessionLine, WhatIsCutOrChangedIsRefusedOrReadsBackAsItIsWritten) {
  std::size_t accepted = 0;
  for (const SessionLine& line : full_lines()) {
    const std::string text = "# " + to_text(line);
    for (std::size_t i = 0; i < text.size(); ++i) {
      for (const std::string& changed :
           {text.substr(0, i), text.substr(0, i) + '\xff' + text.substr(i + 1),
            text.substr(0, i) + '0' + text.substr(i + 1), text.substr(0, i) + ' ' + text.substr(i)}) {
        const auto parsed = parse_session_line(changed);
        if (!parsed || !parsed->has_value()) continue;
        ++accepted;
        EXPECT_EQ(*parse_session_line("# " + to_text(**parsed)).value(), **parsed) << changed;
      }
    }
  }
  EXPECT_GT(accepted, 100U);
}

}  // namespace
}  // namespace penpose::replay
