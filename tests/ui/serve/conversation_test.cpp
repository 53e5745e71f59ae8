#include "ui/serve/conversation.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "replay/session/session_player.h"
#include "tests/support/models/laughing_head.h"
#include "tests/support/models/sheet_model.h"

namespace penpose::tests {
namespace {

using Json = nlohmann::json;

constexpr std::string_view k_take = "Timecode,BlendShapeCount,Lift,TongueOut\n0:0:0:0,2,0.25,0.5\n0:0:0:1,2,0.5,0\n";

/// A conversation about the bent sheet, its files kept in memory.
class Talk {
 public:
  explicit Talk(bool recorded = true) : conversation_(files(recorded)) {}

  std::vector<std::uint8_t> saved;
  std::string session;
  bool disk_full = false;

  Json says(const std::string& line) {
    const std::string answer = conversation_.answer(line);
    EXPECT_EQ(answer.find('\n'), std::string::npos);
    return Json::parse(answer);
  }
  Json does(const std::string& line) {
    Json answer = says(line);
    EXPECT_TRUE(answer["ok"].get<bool>()) << line << ": " << answer;
    return answer;
  }
  Json load() { return does(R"({"do":"load","model":"sheet"})"); }
  std::string state() { return does(R"({"do":"state"})")["state"]; }
  character::Character* character() { return conversation_.character(); }

 private:
  serve::Files files(bool recorded) {
    serve::Files files;
    files.load = [](const std::string& path) -> base::Result<document::Document> {
      if (path == "head") return demo_character().document();
      if (path == "sheet") return document::make_document(sheet_model());
      return base::Error{"there is no file \"" + path + "\"", "", ""};
    };
    files.save = [this](const std::string& path, base::Bytes bytes) -> base::Status {
      if (path.starts_with("no/")) return base::Error{"there is no such folder", "", ""};
      saved.assign(bytes.begin(), bytes.end());
      return base::Done{};
    };
    if (recorded) {
      files.record = [this](std::string_view text) -> base::Status {
        if (disk_full) return base::Error{"the disk is full", "", "make room"};
        session += text;
        return base::Done{};
      };
    }
    files.read = [](const std::string& path) -> base::Result<std::vector<std::uint8_t>> {
      const std::string text = R"({"format": "arkit", "names": {"TongueOut": "lean"}})";
      if (path == "map.json") return std::vector<std::uint8_t>(text.begin(), text.end());
      return base::Error{"there is no file \"" + path + "\"", "", ""};
    };
    files.track = [](const std::string& path, const io::TrackFormat* format, std::optional<io::PictureSize> picture) {
      return io::read_track(base::as_bytes(path == "take.csv" ? k_take : ""), format, picture);
    };
    return files;
  }

  serve::Conversation conversation_;
};

/// Vertices that `lift` moves, and where they are at 0.6 of it.
std::string target_of(Talk& talk, const Json& curve) {
  const Json there =
      talk.does(R"({"do":"evaluate","parameters":{"lift":0.6},"vertices":[182,186,190,192]})")["positions"];
  return Json{{"do", "target"}, {"curve", curve["curve"]}, {"points", there}}.dump();
}

TEST(Serve, ACharacterIsPosed) {
  Talk talk;
  const Json loaded = talk.load();
  EXPECT_EQ(loaded["vertices"], 225);
  EXPECT_EQ(loaded["parameters"][0]["name"], "lift");
  const Json curve = talk.does(R"({"id":7,"do":"curve","vertices":[182,186,190,192]})");
  EXPECT_EQ(curve["id"], 7);
  EXPECT_EQ(curve["positions"].size(), 4U);
  talk.does(target_of(talk, curve));
  talk.does(R"({"do":"perform","command":"lock_parameters names=base.rx;base.ry;base.rz"})");
  for (const char* preset : {"default", "exact"}) {
    const Json solved = talk.does(std::string(R"({"do":"solve","preset":")") + preset + "\"}");
    EXPECT_NEAR(solved["parameters"]["lift"].get<double>(), 0.6, 0.002) << preset;
    EXPECT_LT(solved["distances"]["1"]["most"].get<double>(), 0.002) << preset;
  }
  const Json positions = talk.does(R"({"do":"evaluate"})")["positions"];
  EXPECT_EQ(positions.size(), 225U);
  const Json saved = talk.does(R"({"do":"save","path":"out.glb"})");
  EXPECT_EQ(saved["bytes"], talk.saved.size());
  EXPECT_EQ(character::Character::read(talk.saved)->state().whole.hex(), talk.state());
}

TEST(Serve, ALineIsDrawnAndAViewSaysFromWhere) {
  Talk talk;
  talk.load();
  const Json view = talk.does(R"({"do":"view","yaw":0,"width":800,"height":600})")["view"];
  EXPECT_EQ(view["viewport"], Json({800, 600}));
  Json draw{{"do", "curve"}, {"view", view}, {"line", {{300, 250}, {400, 250}, {500, 250}}}, {"role", "reference"}};
  const Json curve = talk.does(draw.dump());
  EXPECT_EQ(curve["positions"].size(), 32U);
  draw = {{"do", "target"}, {"curve", curve["curve"]}, {"view", view}, {"line", {{300, 230}, {400, 230}, {500, 230}}}};
  EXPECT_FALSE(talk.does(draw.dump())["parameters"].empty()) << "it is solved at once";
}

TEST(Serve, WhatWasSaidReplaysToTheSameBits) {
  Talk talk;
  talk.load();
  const Json curve = talk.does(R"({"do":"curve","vertices":[182,186,190,192]})");
  talk.does(target_of(talk, curve));
  talk.does(R"({"do":"curve","points":[[0,0.25,0.25,0.5]],"role":"constraint"})");
  talk.says(R"({"do":"set","parameters":{"lift":99}})");
  talk.does(R"({"do":"set","parameters":{"lean":0.125}})");
  talk.does(R"({"do":"solve"})");
  const auto round = [](double r) {
    Json line = Json::array();
    for (const auto& [x, y] : {std::pair{r, 0.0}, {0.0, r}, {-r, 0.0}, {0.0, -r}})
      line.push_back({500 + 300 * x, 500 + 300 * y});
    return line;
  };
  const Json view = talk.does(R"({"do":"view"})")["view"];
  const Json sketched = talk.does(Json{
      {"do", "sketch"},
      {"name", "up"},
      {"view", view},
      {"general", round(0.9)},
      {"specific", round(0.5)},
      {"reference", {{440, 500}, {560, 500}}},
      {"target",
       {{440, 440}, {560, 440}}}}.dump());
  EXPECT_EQ(sketched["parameter"], "up");
  replay::PlayerOptions options;
  options.open = [](const std::string&) {
    return base::Result<document::Document>(document::make_document(sheet_model()));
  };
  auto played = replay::play_session(replay::read_from(base::as_bytes(talk.session)), options);
  ASSERT_TRUE(played.ok()) << played.error().line();
  EXPECT_EQ(played->refused, 0U);
  EXPECT_EQ(played->checked, played->steps);
  EXPECT_FALSE(played->divergence);
  EXPECT_EQ(played->session->editor().state().whole.hex(), talk.state());
}

TEST(Serve, ALineThatMeansNothingChangesNothing) {
  Talk talk;
  EXPECT_NE(talk.says(R"({"do":"solve"})")["error"].get<std::string>().find("load"), std::string::npos);
  talk.load();
  talk.does(R"({"do":"curve","vertices":[182,186,190,192]})");
  const std::string before = talk.state();
  const std::string recorded = talk.session;
  for (const std::string line : {"",
                                 "{",
                                 "[]",
                                 "7",
                                 "nonsense",
                                 "{\"do\":\"solve\"} and more",
                                 "\xff\xfe",
                                 R"({})",
                                 R"({"do":7})",
                                 R"({"do":"fly"})",
                                 R"({"do":"solve","presets":"exact"})",
                                 R"({"do":"solve","preset":"best"})",
                                 R"({"do":"load"})",
                                 R"({"do":"curve"})",
                                 R"({"do":"curve","vertices":[999]})",
                                 R"({"do":"curve","vertices":[-1]})",
                                 R"({"do":"curve","vertices":[1.5]})",
                                 R"({"do":"curve","vertices":[]})",
                                 R"({"do":"curve","vertices":7})",
                                 R"({"do":"curve","vertices":[1],"name":"a"})",
                                 R"({"do":"curve","vertices":[1],"role":"friend"})",
                                 R"({"do":"curve","name":"nothing"})",
                                 R"({"do":"curve","points":[[0,1,1,1]]})",
                                 R"({"do":"curve","points":[[0,1,0]]})",
                                 R"({"do":"curve","points":[[1e30,1,0,0]]})",
                                 R"({"do":"curve","line":[[0,0],[1,1]]})",
                                 R"({"do":"curve","view":{"eye":[0,0,6]},"line":[[0,0],[1,1]]})",
                                 R"({"do":"target","curve":1})",
                                 R"({"do":"target","curve":9,"points":[[0,0,0]]})",
                                 R"({"do":"target","curve":1,"points":[[0,0,0]]})",
                                 R"({"do":"target","curve":1,"points":[[0,0,"a"]]})",
                                 R"({"do":"sketch"})",
                                 R"({"do":"animate","track":"take.csv"})",
                                 R"({"do":"set","parameters":{"lift":9}})",
                                 R"({"do":"set","parameters":{"nothing":0}})",
                                 R"({"do":"set","parameters":[1]})",
                                 R"({"do":"perform","command":"make_coffee"})",
                                 R"({"do":"evaluate","vertices":[225]})",
                                 R"({"do":"evaluate","parameters":{"nothing":1}})",
                                 R"({"do":"view","width":0})",
                                 R"({"do":"save"})",
                                 R"({"do":"save","path":"a.png"})",
                                 R"({"do":"save","path":"no/a.glb"})"}) {
    const Json answer = talk.says(line);
    EXPECT_FALSE(answer["ok"].get<bool>()) << line;
    EXPECT_FALSE(answer["error"].get<std::string>().empty()) << line;
    ASSERT_EQ(talk.state(), before) << line;
    ASSERT_EQ(talk.session, recorded) << line;
  }
  EXPECT_EQ(talk.says(R"({"do":"fly","id":"a"})")["id"], "a") << "an error says whose it is";
  EXPECT_NE(talk.says(R"({"do":"curve","vertices":[1,999]})")["error"].get<std::string>().find("vertices/1"),
            std::string::npos);
}

TEST(Serve, ATrackBecomesAnAnimation) {
  Talk talk(false);
  talk.load();
  const std::string before = talk.state();
  const Json animated = talk.does(R"({"do":"animate","track":"take.csv"})");
  EXPECT_EQ(animated["frames"], 2);
  EXPECT_EQ(animated["parameters"]["lift"], Json({0.25, 0.5}));
  EXPECT_EQ(animated["unmatched"], Json({"TongueOut"}));
  EXPECT_EQ(animated["times"].size(), 2U);
  EXPECT_EQ(animated["state"], talk.state());
  EXPECT_NE(talk.state(), before);
  talk.does(R"({"do":"save","path":"out.glb"})");
  EXPECT_EQ(character::Character::read(talk.saved)->document().model->animations.size(), 1U);
  EXPECT_EQ(talk.does(R"({"do":"animate","track":"take.csv","map":"map.json","stretch":10})")["times"], Json({0, 0.1}));
  EXPECT_EQ(talk.character()->document().model->animations.size(), 2U);
  const std::string after = talk.state();
  for (const char* line :
       {R"({"do":"animate"})", R"({"do":"animate","track":"none.csv"})",
        R"({"do":"animate","track":"take.csv","map":"openface"})",
        R"({"do":"animate","track":"take.csv","curves":"none.json"})",
        R"({"do":"animate","track":"take.csv","head":"nod"})", R"({"do":"animate","track":"take.csv","units":1})",
        R"({"do":"animate","track":"take.csv","smooth":99})",
        R"({"do":"animate","track":"take.csv","picture":[1,0]})"}) {
    EXPECT_FALSE(talk.says(line)["ok"].get<bool>()) << line;
    EXPECT_EQ(talk.state(), after) << line;
  }
}

TEST(Serve, ADrawingOfTheFacePosesIt) {
  Talk talk;
  talk.does(R"({"do":"load","model":"head"})");
  const LaughingHead laugh;
  Json lines = Json::array();
  for (const auto& line : laugh.lines) {
    Json points = Json::array();
    for (const auto& p : line) points.push_back({p.x, p.y});
    lines.push_back(std::move(points));
  }
  const Json view = talk.does(R"({"do":"view"})")["view"];
  const Json drawn = talk.does(Json{{"do", "draw"}, {"lines", lines}, {"view", view}}.dump());
  std::vector<std::string> names;
  for (const Json& line : drawn["lines"]) names.push_back(line["curve"].is_null() ? "" : line["curve"]);
  EXPECT_GE(laugh.right(names), laugh.names.size() - 1);
  EXPECT_NEAR(drawn["parameters"]["jaw"].get<double>(), LaughingHead::k_jaw, 0.2);
  EXPECT_LT(drawn["lines"][0]["from"].get<double>(), drawn["lines"][0]["to"].get<double>());
  EXPECT_TRUE(drawn["lines"][0]["reversed"].is_boolean());
  EXPECT_NE(talk.session.find("set_parameters"), std::string::npos);
  const Json rested = talk.does(Json{{"do", "draw"}, {"lines", lines}, {"neutral", lines}}.dump());
  EXPECT_EQ(rested["neutral_lines"].size(), lines.size());
  const std::string before = talk.state();
  for (const char* line :
       {R"({"do":"draw"})", R"({"do":"draw","lines":[]})", R"({"do":"draw","lines":7})", R"({"do":"draw","lines":[7]})",
        R"({"do":"draw","lines":[[[1,1]]]})", R"({"do":"draw","lines":[[[1,1],[2]]]})",
        R"({"do":"draw","lines":[[[1,1],[2,2]]],"neutral":[[]]})",
        R"({"do":"draw","lines":[[[1,1],[2,2]]],"yaw":3})"}) {
    EXPECT_FALSE(talk.says(line)["ok"].get<bool>()) << line;
    EXPECT_EQ(talk.state(), before) << line;
  }
  EXPECT_NE(talk.says(R"({"do":"draw","lines":[[[1,1],[2]]]})")["error"].get<std::string>().find("/lines/0/1"),
            std::string::npos);
}

TEST(Serve, WhatCannotBeRecordedIsNotDone) {
  Talk talk;
  talk.load();
  const std::string before = talk.state();
  talk.disk_full = true;
  EXPECT_NE(talk.says(R"({"do":"set","parameters":{"lift":0.5}})")["error"].get<std::string>().find("disk"),
            std::string::npos);
  EXPECT_EQ(talk.state(), before);
  talk.disk_full = false;
  talk.does(R"({"do":"set","parameters":{"lift":0.5}})");
  EXPECT_NE(talk.state(), before);
}

}  // namespace
}  // namespace penpose::tests
