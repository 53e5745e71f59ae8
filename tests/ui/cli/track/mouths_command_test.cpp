#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/sound/read/read_sound.h"
#include "tests/support/command_run.h"
#include "tests/support/sound_files.h"
#include "ui/cli/commands.h"
#include "ui/files/load_model.h"

namespace penpose::cli {
namespace {

class MouthsCommand : public tests::CommandRun {
 protected:
  int mouths(const std::vector<std::string>& arguments) { return run("mouths", arguments); }
  void write_cues() { save("cues.tsv", "0.00\tX\n0.50\tD\n1.00\tA\n1.10\tD\n1.50\tX\n"); }
};

TEST_F(MouthsCommand, KeysTheMouthsOfCues) {
  write_cues();
  ASSERT_EQ(mouths({"builtin:demo", path("cues.tsv"), "-o", path("talks.glb"), "--json"}), k_success) << error_;
  const auto json = nlohmann::json::parse(out_);
  EXPECT_EQ(json["mouths"].size(), 9U);
  EXPECT_EQ(json["keys"].front()["mouth"], "rest");
  const auto document = files::load_document(path("talks.glb"));
  ASSERT_TRUE(document.ok()) << document.error().line();
  EXPECT_EQ(document->spoken->size(), json["keys"].size());
  const auto jaw = rig::find_parameter(document->model->rig->parameters(), "jaw").value();
  EXPECT_GT(document::pose_at(*document, 0.8)[jaw], 0.4) << "open";
  EXPECT_EQ(document::pose_at(*document, 1.04)[jaw], 0) << "closed for m, b, p";
  EXPECT_GT(document::pose_at(*document, 1.25)[jaw], 0.4);
}

TEST_F(MouthsCommand, WordsOfCuesAreSpokenAndTold) {
  save("words.srt", "1\n00:00:00,500 --> 00:00:01,000\nma\n\n2\n00:00:01,500 --> 00:00:02,000\nbob\n");
  ASSERT_EQ(mouths({"builtin:demo", path("words.srt"), "-o", path("talks.glb"), "--json"}), k_success) << error_;
  const auto json = nlohmann::json::parse(out_);
  ASSERT_EQ(json["words"].size(), 2U);
  EXPECT_EQ(json["words"][1]["word"], "bob");
  EXPECT_EQ(json["words"][1]["from_s"], 1.5);
  const auto document = files::load_document(path("talks.glb"));
  ASSERT_TRUE(document.ok()) << document.error().line();
  const auto jaw = rig::find_parameter(document->model->rig->parameters(), "jaw").value();
  EXPECT_EQ(document::pose_at(*document, 0.55)[jaw], 0) << "m";
  EXPECT_GT(document::pose_at(*document, 0.85)[jaw], 0.4) << "a";
  EXPECT_EQ(document::pose_at(*document, 1.3)[jaw], 0) << "a pause";
}

TEST_F(MouthsCommand, BytesThatAreNoCuesAreNotToBeExportedAgain) {
  save("film.bin", std::string("\x00\x01\x02\x03 film", 9));
  EXPECT_NE(mouths({"builtin:demo", path("film.bin"), "-o", path("talks.glb")}), k_success);
  EXPECT_NE(error_.find("neither a sound that is read here nor a list of cues"), std::string::npos) << error_;
  EXPECT_EQ(error_.find("again"), std::string::npos) << error_;
}

TEST_F(MouthsCommand, TakesTheMouthsOfAFileAndOfAProject) {
  write_cues();
  save("mouths.json", R"({"mouths": [{"name": "A", "values": {"jaw": 0.75}}, {"name": "rest", "values": {}}]})");
  ASSERT_EQ(mouths({"builtin:demo", path("cues.tsv"), "--mouths", path("mouths.json"), "-o", path("talks.glb")}),
            k_success)
      << error_;
  const auto jaw_at = [&](const std::string& file, double time_s) {
    const auto document = files::load_document(path(file));
    EXPECT_TRUE(document.ok());
    const auto jaw = rig::find_parameter(document->model->rig->parameters(), "jaw").value();
    return document::pose_at(*document, time_s)[jaw];
  };
  EXPECT_EQ(jaw_at("talks.glb", 0.75), 0.75);
  ASSERT_EQ(mouths({path("talks.glb"), path("cues.tsv"), "-o", path("again.glb"), "--fps", "12"}), k_success) << error_;
  EXPECT_EQ(jaw_at("again.glb", 0.75), 0.75);
}

TEST_F(MouthsCommand, SaysWhatIsMissing) {
  write_cues();
  save("mouths.json", R"({"mouths": [{"name": "A", "values": {"nothing": 1}}]})");
  EXPECT_EQ(mouths({"builtin:demo", path("cues.tsv"), "--mouths", path("mouths.json")}), k_failure);
  EXPECT_NE(error_.find("nothing"), std::string::npos) << error_;
  EXPECT_EQ(mouths({"builtin:demo", path("none.wav")}), k_failure);
  EXPECT_EQ(mouths({"builtin:demo", path("cues.tsv"), "-o", path("x.obj")}), k_failure);
  save("bad.tsv", "hello\n");
  EXPECT_EQ(mouths({"builtin:demo", path("bad.tsv")}), k_failure);
  EXPECT_NE(error_.find("bad.tsv"), std::string::npos) << error_;
}

TEST_F(MouthsCommand, ASoundInWhichNobodySpeaksIsRefused) {
  if (!sound::reads_sounds()) GTEST_SKIP() << "built without libsndfile";
  const auto bytes = tests::wav_bytes(std::vector<float>(8000), 8000);
  save("silence.wav", std::string(bytes.begin(), bytes.end()));
  EXPECT_EQ(mouths({"builtin:demo", path("silence.wav"), "--text", "my baby"}), k_failure);
  EXPECT_NE(error_.find("silence.wav"), std::string::npos) << error_;
}

}  // namespace
}  // namespace penpose::cli
