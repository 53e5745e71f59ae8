#include "core/poses/kept_pose.h"

#include <gtest/gtest.h>

#include "core/poses/base64.h"

namespace penpose::poses {
namespace {

base::Result<KeptPose> read(const std::string& text) { return read_kept_pose(base::as_bytes(text)); }

KeptPose some_pose() {
  KeptPose pose;
  pose.name = "smile \"wide\"";
  pose.model = "ict_face";
  pose.controls = {"jawOpen", "mouthSmile_L"};
  pose.values = {{"mouthSmile_L", 0.75, {{"lip_upper", {0.1, 0.2, -0.05}}}}};
  FeatureMoves moves{"lip_upper", {}};
  for (std::size_t i = 0; i < k_places; ++i) moves.moves.emplace_back(0.1, 0.02 * static_cast<double>(i), 0);
  pose.moves = {moves};
  pose.lines = {{"lip_upper", {0, 0, 1}, {0, 0.5, 1}, {{0, 0.1, 0}, {0, 0, 0}, {0.25, 0.1, 0}}}};
  pose.pictures[0] = {1, 2, 3, 250};
  pose.pictures[3] = {7};
  return pose;
}

TEST(KeptPose, ReadsBackAsItWasWritten) {
  const KeptPose pose = some_pose();
  const auto again = read(write_kept_pose(pose));
  ASSERT_TRUE(again) << again.error().line();
  EXPECT_EQ(*again, pose);
}

TEST(KeptPose, APoseThatWasWrittenByHandNeedsANameAndValues) {
  const auto pose = read(R"({"penpose_pose": 1, "name": "jaw", "values": {"jaw": 0.5}})");
  ASSERT_TRUE(pose) << pose.error().line();
  ASSERT_EQ(pose->values.size(), 1U);
  EXPECT_EQ(pose->values[0].control, "jaw");
  EXPECT_EQ(pose->values[0].value, 0.5);
}

TEST(KeptPose, OtherFilesAreRefusedInOneLineThatSaysWhere) {
  const auto refused = [](const std::string& text) {
    const auto pose = read(text);
    EXPECT_FALSE(pose) << text;
    return pose ? std::string() : pose.error().line();
  };
  EXPECT_NE(refused("no JSON").find("byte offset"), std::string::npos);
  EXPECT_NE(refused("{\"mouths\": []}").find("this is no pose"), std::string::npos);
  EXPECT_NE(refused(R"({"penpose_pose": 2, "name": "x", "values": {}})").find("format 2"), std::string::npos);
  EXPECT_NE(refused(R"({"penpose_pose": 1, "name": "a\nb", "values": {}})").find("/name"), std::string::npos);
  EXPECT_NE(refused(R"({"penpose_pose": 1, "name": "x", "values": {"jaw": "1"}})").find("/values/jaw"),
            std::string::npos);
  EXPECT_NE(refused(R"({"penpose_pose": 1, "name": "x", "values": {}, "moves": {"jaw": [[0, 0, 0]]}})").find("nine"),
            std::string::npos);
  const std::string line =
      R"({"penpose_pose": 1, "name": "x", "values": {}, "lines": [{"feature": "jaw", "from": [0, 0, 1], )"
      R"("at": [0.5, 0.25], "moves": [[0, 0, 0], [0, 0, 0]]}]})";
  EXPECT_NE(refused(line).find("/lines/0/at"), std::string::npos);
  EXPECT_NE(refused(R"({"penpose_pose": 1, "name": "x", "values": {}, "pictures": {"all": "###="}})").find("base64"),
            std::string::npos);
}

TEST(Base64, IsThatOfTheSpecification) {
  // RFC 4648, section 10.
  const std::pair<const char*, const char*> known[] = {{"", ""},
                                                       {"f", "Zg=="},
                                                       {"fo", "Zm8="},
                                                       {"foo", "Zm9v"},
                                                       {"foob", "Zm9vYg=="},
                                                       {"fooba", "Zm9vYmE="},
                                                       {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : known) {
    EXPECT_EQ(base64_text(base::as_bytes(bytes)), text);
    const auto back = base64_bytes(text);
    ASSERT_TRUE(back);
    EXPECT_EQ(std::string(back->begin(), back->end()), bytes);
  }
  EXPECT_FALSE(base64_bytes("Zg="));
  EXPECT_FALSE(base64_bytes("Z==="));
}

}  // namespace
}  // namespace penpose::poses
