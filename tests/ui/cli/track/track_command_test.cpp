#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/command_run.h"
#include "ui/cli/commands.h"

namespace penpose::cli {
namespace {

/// Pictures of a bright mouth on a dark face that opens: the upper edge stays, the lower edge sinks.
class TrackCommand : public tests::CommandRun {
 protected:
  void SetUp() override {
    CommandRun::SetUp();
    std::filesystem::create_directories(folder_ / "clip");
  }
  static double lower_edge(double open) { return 34 + 12 * open; }
  /// `light`: how bright the picture is.
  void write_picture(const std::string& name, double open, double light) const {
    std::ofstream file(folder_ / name, std::ios::binary);
    file << "P5 64 64 255\n";
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        const double inside = std::clamp(y + 0.5 - 30, 0.0, 1.0) * std::clamp(lower_edge(open) - y, 0.0, 1.0);
        const double grey = x > 16 && x < 48 ? 60 + 150 * inside : 60;
        file.put(static_cast<char>(static_cast<int>(grey * light)));
      }
    }
  }
  static nlohmann::json curves(double open) {
    const double low = lower_edge(open);
    return {{"upper", {{16, 30}, {32, 30}, {48, 30}}}, {"lower", {{16, low}, {32, low}, {48, low}}}};
  }
  int track(const std::vector<std::string>& arguments) { return run("track", arguments); }
};

TEST_F(TrackCommand, FindsTheEdgesOfAMouthInEveryLight) {
  nlohmann::json frames = nlohmann::json::array();
  for (int k = 0; k <= 10; ++k) {
    const std::string name = "label" + std::to_string(k) + ".pgm";
    write_picture(name, k / 10.0, 0.7 + 0.03 * k);
    frames.push_back({{"image", name}, {"curves", curves(k / 10.0)}});
  }
  std::ofstream(folder_ / "labels.json")
      << nlohmann::json{{"frames", frames}, {"features", nlohmann::json::parse(R"([["upper", "lower"]])")}}.dump();
  for (int f = 0; f < 8; ++f)
    write_picture("clip/face000" + std::to_string(f) + ".pgm", 0.05 + 0.11 * f, 1.1 - 0.05 * f);
  ASSERT_EQ(track({path("clip"), "--labels", path("labels.json"), "-o", path("track.json"), "--fps", "10"}), k_success)
      << error_;
  std::ifstream file(folder_ / "track.json");
  const auto found = nlohmann::json::parse(file);
  EXPECT_EQ(found["fps"], 10);
  ASSERT_EQ(found["frames"].size(), 8U);
  for (std::size_t f = 0; f < 8; ++f) {
    const double wanted = lower_edge(0.05 + 0.11 * static_cast<double>(f));
    EXPECT_NEAR(found["frames"][f]["curves"]["lower"][1][1].get<double>(), wanted, 1.0) << f;
    EXPECT_NEAR(found["frames"][f]["curves"]["upper"][1][1].get<double>(), 30, 1.0) << f;
  }
}

TEST_F(TrackCommand, ABlackOrFlatPictureShowsNoFace) {
  nlohmann::json frames = nlohmann::json::array();
  for (int k = 0; k <= 4; ++k) {
    const std::string name = "label" + std::to_string(k) + ".pgm";
    write_picture(name, k / 4.0, 1);
    frames.push_back({{"image", name}, {"curves", curves(k / 4.0)}});
  }
  std::ofstream(folder_ / "labels.json") << nlohmann::json{{"frames", frames}};
  for (int f = 0; f < 5; ++f) write_picture("clip/face" + std::to_string(f) + ".pgm", 0.5, 1);
  std::ofstream(folder_ / "clip" / "face1.pgm", std::ios::binary) << "P5 64 64 255\n" << std::string(64 * 64, '\0');
  std::ofstream(folder_ / "clip" / "face2.pgm", std::ios::binary) << "P5 64 64 255\n" << std::string(64 * 64, 'x');
  write_picture("clip/face3.pgm", 0.5, 0.4);  // dark, and a face
  ASSERT_EQ(track({path("clip"), "--labels", path("labels.json"), "-o", path("track.json")}), k_success) << error_;
  const auto found = nlohmann::json::parse(std::ifstream(folder_ / "track.json"));
  ASSERT_EQ(found["frames"].size(), 5U);
  for (const int f : {1, 2}) EXPECT_TRUE(found["frames"][f].is_null()) << f;
  for (const int f : {0, 3, 4}) {
    ASSERT_TRUE(found["frames"][f].is_object()) << f;
    EXPECT_GT(found["frames"][f]["confidence"].get<double>(), 0.8) << f;
    EXPECT_NEAR(found["frames"][f]["curves"]["lower"][1][1].get<double>(), lower_edge(0.5), 1.0) << f;
  }
}

TEST_F(TrackCommand, SaysWhereCurvesHaveOtherNumbersOfPoints) {
  write_picture("one.pgm", 0, 1);
  write_picture("two.pgm", 1, 1);
  write_picture("clip/face0001.pgm", 0, 1);
  nlohmann::json other = curves(1);
  other["lower"].push_back({50, 46});
  std::ofstream(folder_ / "labels.json") << nlohmann::json{
      {"frames", {{{"image", "one.pgm"}, {"curves", curves(0)}}, {{"image", "two.pgm"}, {"curves", other}}}}};
  ASSERT_EQ(track({path("clip"), "--labels", path("labels.json"), "-o", path("track.json")}), k_success) << error_;
  EXPECT_NE(error_.find("curve lower has 4 points in the picture two.pgm and 3 in one.pgm"), std::string::npos)
      << error_;
  EXPECT_EQ(error_.find("upper"), std::string::npos) << error_;
}

TEST_F(TrackCommand, APictureOfAnotherSizeIsNamedWithBothSizes) {
  std::filesystem::create_directories(folder_ / "odd");
  write_picture("label.pgm", 0, 1);
  write_picture("label2.pgm", 1, 1);
  write_picture("odd/face0001.pgm", 0, 1);
  for (const char* name : {"wide.pgm", "odd/face0002.pgm"}) {
    std::ofstream(folder_ / name, std::ios::binary) << "P5\n8 4\n255\n" << std::string(32, 'x');
  }
  const nlohmann::json label = {{"image", "label.pgm"}, {"curves", curves(0)}};
  nlohmann::json other = {{"image", "label2.pgm"}, {"curves", curves(1)}};
  std::ofstream(folder_ / "labels.json") << nlohmann::json{{"frames", {label, other}}};
  const auto track_of = [&](const char* folder) {
    return track({(folder_ / folder).string(), "--labels", (folder_ / "labels.json").string(), "-o",
                  (folder_ / "track.json").string()});
  };
  EXPECT_EQ(track_of("odd"), k_failure);
  EXPECT_NE(error_.find("face0002.pgm: frame 1: the picture is 8x4 px"), std::string::npos) << error_;
  EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1) << error_;
  other["image"] = "wide.pgm";
  std::ofstream(folder_ / "labels.json") << nlohmann::json{{"frames", {label, other}}};
  EXPECT_EQ(track_of("odd"), k_failure);
  EXPECT_NE(error_.find("wide.pgm: the picture is 8x4 px"), std::string::npos) << error_;
}

TEST_F(TrackCommand, SaysWhatIsWrong) {
  write_picture("label.pgm", 0, 1);
  write_picture("clip/face0001.pgm", 0, 1);
  const auto labels = [&](const nlohmann::json& frames) {
    std::ofstream(folder_ / "labels.json") << nlohmann::json{{"frames", frames}}.dump();
    return track({path("clip"), "--labels", path("labels.json"), "-o", path("track.json")});
  };
  EXPECT_EQ(labels({{{"image", "label.pgm"}, {"curves", curves(0)}}}), k_failure);
  EXPECT_NE(error_.find("two labelled pictures"), std::string::npos) << error_;
  EXPECT_EQ(labels({{{"image", "none.pgm"}, {"curves", curves(0)}}}), k_failure);
  EXPECT_NE(error_.find("none.pgm"), std::string::npos) << error_;
  EXPECT_EQ(labels({{{"curves", curves(0)}}}), k_failure);
  EXPECT_NE(error_.find("/frames/0"), std::string::npos) << error_;
}

TEST_F(TrackCommand, NamesTheCurveAndThePictureThatCannotBeLearned) {
  write_picture("one.pgm", 0, 1);
  write_picture("two.pgm", 1, 1);
  write_picture("clip/face0001.pgm", 0, 1);
  const auto fails = [&](const nlohmann::json& first, const nlohmann::json& second, const std::string& expected,
                         const nlohmann::json& features = {}) {
    nlohmann::json file = {
        {"frames", {{{"image", "one.pgm"}, {"curves", first}}, {{"image", "two.pgm"}, {"curves", second}}}}};
    if (!features.is_null()) file["features"] = features;
    std::ofstream(folder_ / "labels.json") << file.dump();
    EXPECT_EQ(track({path("clip"), "--labels", path("labels.json"), "-o", path("track.json")}), k_failure);
    EXPECT_NE(error_.find("labels.json: " + expected), std::string::npos) << error_;
    EXPECT_EQ(std::count(error_.begin(), error_.end(), '\n'), 1) << error_;
  };
  nlohmann::json broken = curves(1);
  broken["lower"][1] = nullptr;
  fails(curves(0), broken, "/frames/1/curves: curve lower has a point that is no number, in the picture two.pgm");
  broken["lower"] = nlohmann::json::array();
  fails(curves(0), broken, "/frames/1/curves: curve lower is empty, in the picture two.pgm");
  const nlohmann::json flat = {{"upper", {{16, 30}, {32, 30}}}, {"lower", {{5, 5}, {5, 5}}}};
  fails(flat, flat, "feature lower: all its points lie at one place in every picture; mark");
  nlohmann::json outside = curves(1);
  outside["lower"][1] = {640, 46};
  fails(curves(0), outside, "picture two.pgm, feature lower: point 1 lies at 640.0, 46.0 px, far outside the picture");
  fails(curves(0), curves(1), "/features/0: a list of names of curves was expected", nlohmann::json::parse("[[]]"));
  fails(curves(0), curves(1), "/features/0/1: no curve of all pictures is named lip; name one of lower, upper",
        nlohmann::json::parse(R"([["upper", "lip"]])"));
}

}  // namespace
}  // namespace penpose::cli
