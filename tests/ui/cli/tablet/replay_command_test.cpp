#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/edition.h"
#include "core/document/document_hash.h"
#include "core/io/model/write_model.h"
#include "core/io/project/read_document.h"
#include "tests/support/command_run.h"
#include "tests/support/random_session.h"
#include "ui/files/load_model.h"

namespace penpose::cli {
namespace {

class ReplayCommand : public tests::CommandRun {
 protected:
  void SetUp() override {
    CommandRun::SetUp();
    save("sheet.glb", io::write_glb(tests::sheet_model()).value());
    tests::SessionScript script(files::load_document(path("sheet.glb")).value(), "somewhere/sheet.glb");
    const auto line = [](double height) {
      std::vector<geometry::PxPoint> out;
      for (int i = 0; i <= 10; ++i) out.push_back({350.0 + 30 * i, height});
      return out;
    };
    EXPECT_TRUE(script.stroke(line(300)));
    EXPECT_TRUE(script.stroke(line(230)));
    EXPECT_TRUE(script.perform(document::SetKey{1, "up"}));
    state_ = script.editor().state().whole.hex();
    save("drawn.session", script.text());
  }
  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(out_); }

  std::string state_;
};

TEST_F(ReplayCommand, EndsInTheRecordedState) {
  ASSERT_EQ(run({"replay", path("drawn.session"), "--json"}), 0) << error_;
  EXPECT_EQ(json()["state"], state_);
  EXPECT_EQ(json()["strokes"], 2);
  EXPECT_EQ(json()["checked"], 3);
  EXPECT_EQ(json()["differing"], 0);
  EXPECT_GT(json()["parameters"]["lift"], 0.1);
  EXPECT_EQ(error_, "") << "the model was found beside the session";
}

TEST_F(ReplayCommand, WritesAProjectToGoOnWith) {
  ASSERT_EQ(run({"replay", path("drawn.session"), "-o", path("out.glb")}), 0) << error_;
  EXPECT_NE(out_.find("3 of 3 recorded states equal"), std::string::npos) << out_;
  const auto document = files::load_document(path("out.glb"));
  ASSERT_TRUE(document);
  EXPECT_EQ(document::DocumentHasher()(*document).whole.hex(), state_);
}

TEST_F(ReplayCommand, StopsAfterAStroke) {
  ASSERT_EQ(run({"replay", path("drawn.session"), "--stroke", "1", "--json"}), 0) << error_;
  EXPECT_EQ(json()["parameters"]["lift"], 0.0);
  EXPECT_EQ(json()["curves"], 1);
}

TEST_F(ReplayCommand, ANumberOfStrokesIsNotNegative) {
  EXPECT_EQ(run({"replay", path("drawn.session"), "--stroke", "-1"}), 2);
  EXPECT_EQ(run({"replay", path("drawn.session"), "--stroke", "x"}), 2);
}

TEST_F(ReplayCommand, NamesTheLineAndThePartsOfADivergence) {
  std::string text = content("drawn.session");
  const std::size_t key = text.find("time_s=1");
  text.replace(key, 8, "time_s=2");
  save("edited.session", text);
  EXPECT_EQ(run({"replay", path("edited.session"), "--json"}), 1);
  const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(key), '\n') + 2;
  EXPECT_EQ(json()["divergence"]["line"], line);
  EXPECT_NE(error_.find("edited.session: line " + std::to_string(line) + ":"), std::string::npos) << error_;
  EXPECT_NE(error_.find("different are: parameters, curves, keys"), std::string::npos) << error_;
}

TEST_F(ReplayCommand, AMissingModelIsNamedWithTheRemedy) {
  std::filesystem::remove(path("sheet.glb"));
  EXPECT_EQ(run({"replay", path("drawn.session")}), 1);
  EXPECT_NE(error_.find("drawn.session: line 2: there is no model \"somewhere/sheet.glb\""), std::string::npos)
      << error_;
  EXPECT_NE(error_.find("name it with --model"), std::string::npos);
}

TEST_F(ReplayCommand, AChangedModelIsRefused) {
  auto model = tests::sheet_model();
  model.pose[1] = 0.5;
  save("sheet.glb", io::write_glb(model).value());
  EXPECT_EQ(run({"replay", path("drawn.session")}), 1);
  EXPECT_NE(error_.find("is not the one that was drawn on"), std::string::npos) << error_;
}

TEST_F(ReplayCommand, TheCopyOfTheModelThatIsKeptBesideASessionIsUsed) {
  const std::string model = content("sheet.glb");
  auto other = tests::sheet_model();
  other.pose[1] = 0.5;
  save("sheet.glb", io::write_glb(other).value());
  save("drawn.session.model.glb", model);
  ASSERT_EQ(run({"replay", path("drawn.session"), "--json"}), 0) << error_;
  EXPECT_EQ(json()["state"], state_);
  EXPECT_EQ(json()["model"], path("drawn.session.model.glb"));
}

TEST_F(ReplayCommand, WritesItselfDownAndNeverOverAnOlderSession) {
  ASSERT_EQ(run({"replay", path("drawn.session"), "--session", path("again.session")}), 0) << error_;
  ASSERT_EQ(run({"replay", path("again.session"), "--json"}), 0) << error_;
  EXPECT_EQ(json()["state"], state_);
  EXPECT_EQ(json()["checked"], 3);
  const std::string before = content("again.session");
  EXPECT_EQ(run({"replay", path("drawn.session"), "--session", path("again.session")}), 1);
  EXPECT_NE(error_.find("exists already"), std::string::npos) << error_;
  EXPECT_EQ(content("again.session"), before);
}

TEST_F(ReplayCommand, DrawsAPictureOfTheLastView) {
  ASSERT_EQ(run({"replay", path("drawn.session"), "--png", path("out.png")}), 0) << error_;
  EXPECT_EQ(content("out.png").substr(1, 3), "PNG");
}

TEST_F(ReplayCommand, AFileThatIsNoSessionIsNamed) {
  save("notes.txt", std::string("dear diary\n"));
  EXPECT_EQ(run({"replay", path("notes.txt")}), 1);
  EXPECT_NE(error_.find("notes.txt: holds nothing to replay"), std::string::npos) << error_;
  save("cut.hid", std::string("E: zz\nE: 0.1 9 00\nE: 0.2"));
  EXPECT_EQ(run({"replay", path("cut.hid")}), 1);
  EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1) << error_;
}

/// The session as an older edition would have recorded it; commands and their states are the same since edition 6.
std::string of_edition(std::string text, const std::string& edition) {
  const std::string now = "edition=" + std::to_string(base::k_edition);
  return text.replace(text.find(now), now.size(), "edition=" + edition);
}

TEST_F(ReplayCommand, AnOlderSessionIsRefusedWithOneLineThatNamesByToday) {
  save("old.session", of_edition(content("drawn.session"), "6"));
  EXPECT_EQ(run({"replay", path("old.session")}), 1);
  EXPECT_NE(error_.find("old.session: line 1: "), std::string::npos) << error_;
  EXPECT_NE(error_.find("--by-today"), std::string::npos) << error_;
  EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1);
  save("new.session", of_edition(content("drawn.session"), "99"));
  EXPECT_EQ(run({"replay", path("new.session"), "--by-today"}), 1);
  EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1);
}

TEST_F(ReplayCommand, ByTodayDrawsAnOlderSessionAndSavesItAsOneOfToday) {
  save("old.session", of_edition(content("drawn.session"), "6"));
  ASSERT_EQ(run({"replay", path("old.session"), "--by-today", "--session", path("today.session")}), 0) << error_;
  EXPECT_NE(out_.find("drawn in edition 6"), std::string::npos) << out_;
  EXPECT_NE(out_.find("of 3 steps 3 came out as recorded, 0 differently, 0 could not be drawn"), std::string::npos)
      << out_;
  ASSERT_EQ(run({"replay", path("today.session"), "--json"}), 0) << error_;
  EXPECT_EQ(json()["state"], state_);
  EXPECT_EQ(json()["checked"], 3);
  EXPECT_FALSE(json().contains("by_today"));
}

TEST_F(ReplayCommand, ByTodaySaysWhatComesOutDifferentlyAndInWhichParts) {
  std::string text = of_edition(content("drawn.session"), "6");
  // The second stroke was read otherwise then.
  std::size_t at = text.find("# penpose state ");
  at = text.find("# penpose state ", at + 1);
  text[at + 16] = text[at + 16] == '0' ? '1' : '0';
  const std::size_t parameters = text.find("parameters=", at) + 11;
  text[parameters] = text[parameters] == '0' ? '1' : '0';
  save("old.session", text);
  ASSERT_EQ(run({"replay", path("old.session"), "--by-today", "--json"}), 0) << "what is different is no failure";
  const auto told = json()["by_today"];
  EXPECT_EQ(told["edition"], 6);
  EXPECT_EQ(told["same_model"], true);
  EXPECT_EQ(told["strokes"], 2);
  EXPECT_EQ(told["equal"], 2);
  EXPECT_EQ(told["different"], 1);
  ASSERT_EQ(told["steps"].size(), 3U);
  EXPECT_EQ(told["steps"][1]["stroke"], 2);
  EXPECT_EQ(told["steps"][1]["came_out"], "different");
  EXPECT_EQ(told["steps"][1]["parts"], nlohmann::json::array({"parameters"}));
  EXPECT_EQ(told["steps"][2]["step"], "set_key");
  EXPECT_EQ(json()["state"], state_);
  ASSERT_EQ(run({"replay", path("old.session"), "--by-today"}), 0);
  EXPECT_NE(out_.find("stroke 2 (line "), std::string::npos) << out_;
  EXPECT_NE(out_.find("different in parameters"), std::string::npos) << out_;
}

TEST_F(ReplayCommand, ByTodayNamesTheLineOfWhatCannotBeExpressedAndWritesTheRest) {
  std::string text = of_edition(content("drawn.session"), "6");
  const std::size_t key = text.find("do set_key");
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(key), '\n');
  save("old.session", text.replace(key, 10, "do set_kei"));
  EXPECT_EQ(run({"replay", path("old.session"), "--by-today", "--session", path("today.session")}), 1);
  EXPECT_NE(error_.find("old.session: line " + std::to_string(line) + ": set_kei could not be drawn by today"),
            std::string::npos)
      << error_;
  EXPECT_EQ(run({"replay", path("today.session"), "--json"}), 0);
  EXPECT_EQ(json()["strokes"], 2);
}

}  // namespace
}  // namespace penpose::cli
