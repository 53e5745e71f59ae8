#include "core/document/commands/command_text.h"

#include <gtest/gtest.h>
#include <set>

namespace penpose::document {
namespace {

const std::string k_strange("a b;c,d=e%/x\n\t\"#\xc3\xa9\0z", 20);

View some_view() { return {{{0.1, -2e-7, 1.0 / 3}, {1, 2, 3}, {0, 0, 1}, 27.5}, {1920, 1081}}; }
std::vector<PxPoint> some_line() { return {{412, 300.25}, {-1.0 / 3, 1e6}, {5e-324, -0.1}}; }

/// Every command with none of its members at its default.
std::vector<Command> full_commands() {
  using articulation::CurveRole;
  using articulation::Mode;
  using articulation::PartSurface;
  using articulation::Sphere;
  const View view = some_view();
  return {
      SetParameters{{{k_strange, 0.1}, {"", -1e15}}},
      ResetParameters{{"jawOpen", "", k_strange}},
      LockParameters{{k_strange}, false},
      DrawReference{view, some_line()},
      DrawTarget{CurveId{4294967295U}, view, some_line(), {0, 0.5, 1}},
      OversketchTarget{CurveId{7}, view, some_line()},
      DragTarget{CurveId{7}, {-3.5, 1e-9}},
      DrawConstraint{view, some_line()},
      Pin{view, {0.1, 0.2}},
      KeepCurve{CurveId{1}},
      DeleteCurve{CurveId{2}},
      EraseCurves{view, some_line()},
      ClearCurves{},
      SolvePose{Preset::paper},
      SetPressureWeighting{true},
      SetHand{0.5},
      NameCurve{CurveId{3}, k_strange},
      DeleteNamedCurve{k_strange},
      BeginDeformer{k_strange, Mode::rotate, Sphere{{0.1, 0.2, -0.3}, 1e-3}, -0.5, 1.5},
      BeginDeformer{"eye", Mode::translate, PartSurface{k_strange}, -1, 2},
      BeginDeformer{"free", Mode::automatic, articulation::Free{}, 0, 1},
      SketchCurve{CurveRole::target, view, some_line()},
      CancelDeformer{},
      RedrawCurve{k_strange, CurveRole::specific, view, some_line()},
      ChangeDeformer{k_strange, Mode::automatic, articulation::Surface{}, 0.0, 1.0},
      MirrorDeformer{k_strange},
      RenameDeformer{k_strange, "%"},
      DeleteDeformer{k_strange},
      MoveDeformer{k_strange, 4294967295U},
      SetKey{1.0 / 3, k_strange, {"jawOpen", k_strange}},
      DeleteKeys{{{1e-300}, {k_strange}}},
      MoveKeys{{{0.1, 0.2}, {}}, -0.5, 1, 2.5, true, 24},
      SetKeyKind{{{0.1}, {"jawOpen"}}, KeyKind::ease_out},
      SetKeyValues{{{0.1}, {"jawOpen"}}, {0.25}},
      SetKeySlopes{0.1, "jawOpen", -2, 1e-9},
      Tween{0.5, 1.25, {"jawOpen"}},
      RedrawArc{{7, {0.5, 0.25, 0.25}}, view, 0.5, 2, 25, {{1, 2}, {3.5, 1e-9}}, {0, 1}},
      GoToTime{36000},
      SaveView{k_strange, view, 9},
      KeyCamera{1.0 / 3, view, KeyKind::stepped},
      DeleteCameraKeys{{0, 1.0 / 3}},
      MoveCameraKey{1.0 / 3, 2},
      NameView{k_strange, "%"},
      SetReference{{k_strange, {0x123456789abcdef0U, 0xfU}, -0.25, 1.0 / 3, true, {0.1, -2, 1e-9}, 2, {0.5, 0}, 0.2}},
      RemoveReference{},
      DeleteView{k_strange},
      SuggestRest{{"jawOpen", k_strange}, 0.1},
      TakeReading{CurveId{3}, 1},
      PullTarget{CurveId{9}, view, {1.5, -2}, {0.25, 1e-9}, 0.5},
      TakeRegion{articulation::Reach::front, 4294967295U},
      DrawBetween{k_strange, 0.25, view, some_line()},
      DeleteBetween{k_strange, -0.5},
      PullBetween{k_strange, 2, view, {1, 2}, {-3, 4}, 0},
      BeginCorrection{k_strange, {{"jawOpen", 0.5}, {k_strange, 1}}, Mode::rotate},
      DeleteCorrection{k_strange},
      PlaceCurve{{{3, {0.25, 0.5, 0.25}}, {0, {1, 0, 0}}}, true},
      PlaceTarget{CurveId{4}, {{0.1, -2, 1e-9}, {1, 2, 3}}},
      DrawFaceLine{{view, some_line()}},
      NameFaceLine{CurveId{4294967295U}, k_strange, true, true},
      SetNeutral{false},
      SetSound{k_strange, {0x123456789abcdef0U, 0xfU}, -0.25},
      RemoveSound{},
      MoveSound{1.0 / 3},
      SetMouth{k_strange, {{"jawOpen", 0.5}, {k_strange, -1}}},
      DeleteMouth{k_strange},
      KeyMouths{{0, 1.0 / 24}, {"rest", k_strange}},
      SetWords{{0, 1.0 / 3}, {"hello", k_strange}},
      SetBookmark{1.0 / 3, k_strange, 4},
      MoveBookmark{1.0 / 3, 2},
      DeleteBookmark{1.0 / 3},
      OpenClip{3},
      ShowClip{1},
      AddClip{k_strange, true},
      NameClip{{k_strange}},
      DeleteClip{},
      TrimClip{1.0 / 3, 2},
      DrawFeature{view, some_line(), k_strange},
      LineIsFeature{CurveId{4294967295U}, k_strange},
      PlaceFeature{k_strange, {{3, {0.25, 0.5, 0.25}}, {0, {1, 0, 0}}}},
      FeatureAsFound{k_strange},
      KeyPoses{{"jawOpen", k_strange}, {0, 1.0 / 24}, {0.5, 1e-9, 1, -2}}};
}

template <std::size_t... I>
std::vector<Command> default_commands(std::index_sequence<I...>) {
  return {Command(std::variant_alternative_t<I, CommandTypes>{})...};
}

TEST(CommandText, EveryCommandReadsBackAsItWas) {
  std::set<std::size_t> seen;
  for (const Command& command : full_commands()) {
    seen.insert(command.index());
    const std::string text = to_text(command);
    EXPECT_EQ(text.find_first_of("\n\r\t\"#"), std::string::npos) << "one line, whatever the names: " << text;
    const auto again = parse_command(text);
    ASSERT_TRUE(again.ok()) << text << ": " << again.error().line();
    EXPECT_EQ(*again, command) << text;
  }
  EXPECT_EQ(seen.size(), std::variant_size_v<CommandTypes>) << "a command without an example here";
}

TEST(CommandText, MembersAtTheirDefaultsAreLeftOut) {
  std::set<std::string> names;
  std::set<std::string_view> words;
  for (const Command& command : default_commands(std::make_index_sequence<std::variant_size_v<CommandTypes>>())) {
    EXPECT_EQ(to_text(command), name_of(command));
    EXPECT_EQ(parse_command(to_text(command)).value(), command);
    names.insert(to_text(command));
    words.insert(called(command).words);
  }
  EXPECT_EQ(names.size(), std::variant_size_v<CommandTypes>) << "two commands have one name";
  EXPECT_EQ(words.size(), names.size()) << "an animator cannot tell two commands apart";
  EXPECT_EQ(words.count(""), 0U) << "an animator has no words for a command";
}

TEST(CommandText, IsWrittenAsTheFormatSays) {
  EXPECT_EQ(to_text(SetParameters{{{"jawOpen", 0.5}, {"brow up", 1}}}),
            "set_parameters values=jawOpen,0.5;brow%20up,1");
  const View view{{{0, 0.1, 0.8}, {0, 0, 0}, {0, 1, 0}, 30}, {1000, 900}};
  EXPECT_EQ(to_text(DrawTarget{CurveId{1}, view, {{412, 300}, {415.5, 301}}, {}}),
            "draw_target curve=1 view=0,0.1,0.8/0,0,0/0,1,0/30/1000x900 line=412,300;415.5,301");
  EXPECT_EQ(to_text(BeginDeformer{"blink", articulation::Mode::rotate, articulation::PartSurface{"ball_L"}, 0, 1}),
            "begin_deformer name=blink mode=rotate surface=part:ball_L");
  EXPECT_EQ(to_text(ResetParameters{{""}}), "reset_parameters names=%");
  EXPECT_EQ(parse_command("set_key  time_s=1  name=a").value(), Command(SetKey{1, "a"})) << "blanks may be doubled";
}

TEST(CommandText, MembersThatAreNotGivenAreToldFromThoseThatAre) {
  const auto none = *parse_command("change_deformer deformer=a").value().get_if<ChangeDeformer>();
  EXPECT_FALSE(none.mode || none.surface || none.minimum || none.maximum);
  const auto some = *parse_command("change_deformer mode=auto surface=none minimum=0").value().get_if<ChangeDeformer>();
  EXPECT_EQ(some.mode, articulation::Mode::automatic);
  EXPECT_TRUE(some.surface.has_value());
  EXPECT_EQ(some.minimum, 0.0);
}

TEST(CommandText, ErrorsNameTheMember) {
  const auto error = [](const char* text) {
    const auto command = parse_command(text);
    EXPECT_FALSE(command.ok()) << text;
    return command.ok() ? base::Error{} : command.error();
  };
  EXPECT_NE(error("set_everything a=1").what.find("set_everything"), std::string::npos);
  EXPECT_FALSE(parse_command("").ok());
  EXPECT_EQ(error("set_key time=1").place, "time");
  EXPECT_EQ(error("set_key time_s=1 time_s=1").place, "time_s");
  const std::pair<const char*, const char*> malformed[] = {{"set_key time_s=", "time_s"},
                                                           {"set_key time_s", "time_s"},
                                                           {"set_key time_s=nan", "time_s"},
                                                           {"set_key time_s=inf", "time_s"},
                                                           {"set_key time_s=1e400", "time_s"},
                                                           {"set_key time_s=1e16", "time_s"},
                                                           {"set_key time_s=1,5", "time_s"},
                                                           {"set_key name=a%2", "name"},
                                                           {"set_key name=a%+4", "name"},
                                                           {"set_key name=a%GG", "name"},
                                                           {"set_key name=a,b", "name"},
                                                           {"set_key name=", "name"},
                                                           {"delete_curve curve=-1", "curve"},
                                                           {"delete_curve curve=4294967296", "curve"},
                                                           {"delete_curve curve=1.0", "curve"},
                                                           {"set_pressure_weighting on=yes", "on"},
                                                           {"set_parameters values=a", "values"},
                                                           {"set_parameters values=a,1;", "values"},
                                                           {"set_parameters values=;a,1", "values"},
                                                           {"set_parameters values=a,1,2", "values"},
                                                           {"drag_target by=1", "by"},
                                                           {"drag_target by=1,2,3", "by"},
                                                           {"drag_target by=1000001,0", "by"},
                                                           {"draw_reference line=1,2;;3,4", "line"},
                                                           {"pin view=0,0,1/0,0,0/0,1,0/30/1000", "view"},
                                                           {"pin view=0,0,1/0,0,0/0,1,0/30/0x1000", "view"},
                                                           {"pin view=0,0,1/0,0,0/0,1,0/30/1000x99999", "view"},
                                                           {"pin view=0,0/0,0,0/0,1,0/30/1000x1000", "view"},
                                                           {"pin view=0,0,1/0,0,0/0,1,0/30/1000x1000/1", "view"},
                                                           {"begin_deformer mode=turn", "mode"},
                                                           {"begin_deformer surface=sphere:1,2,3", "surface"},
                                                           {"begin_deformer surface=ball", "surface"},
                                                           {"sketch_curve role=lasso", "role"},
                                                           {"set_key_kind kind=step", "kind"}};
  for (const auto& [text, place] : malformed) EXPECT_EQ(error(text).place, place) << text;
}

TEST(CommandText, ALineHasNoMoreThanAHundredThousandPoints) {
  std::string line = "1,2";
  for (std::size_t i = 1; i < articulation::k_most_points; ++i) line += ";1,2";
  EXPECT_TRUE(parse_command("draw_reference line=" + line).ok());
  EXPECT_FALSE(parse_command("draw_reference line=" + line + ";1,2").ok());
}

TEST(CommandText, WhatIsCutOrChangedIsRefusedOrReadsBackAsItIsWritten) {
  std::size_t accepted = 0;
  const auto check = [&](const std::string& text) {
    const auto command = parse_command(text);
    if (!command) {
      EXPECT_LE(command.error().place.size(), 40U);
      return;
    }
    ++accepted;
    EXPECT_EQ(parse_command(to_text(*command)).value(), *command) << text;
  };
  for (const Command& command : full_commands()) {
    const std::string text = to_text(command);
    for (std::size_t i = 0; i < text.size(); ++i) {
      check(text.substr(0, i));
      for (const char c : {' ', '=', ';', ',', '/', '%', '-', '0', '\0', '\xff'}) {
        std::string changed = text;
        changed[i] = c;
        check(changed);
      }
    }
  }
  EXPECT_GT(accepted, 1000U);
}

TEST(CommandText, AViewAloneReadsBack) {
  EXPECT_EQ(parse_view(to_text(some_view())).value(), some_view());
  EXPECT_FALSE(parse_view("0,0,1/0,0,0/0,1,0/30").ok());
}

}  // namespace
}  // namespace penpose::document
