#include "core/speech/mouth_keys.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/speech/mouth_file.h"
#include "core/speech/usual_mouths.h"
#include "tests/support/models/sheet_model.h"

namespace penpose::speech {
namespace {

document::SpokenMouths keys_of(const Cues& cues, double offset_s = 0) { return mouth_keys(cues, {24, offset_s}); }

/// Frames from the first to the last key of a mouth that lie next to each other in the list.
struct Run {
  double from = 0, to = 0;
};
std::vector<Run> runs(const document::SpokenMouths& keys, const std::string& mouth) {
  std::vector<Run> out;
  bool on = false;
  for (const auto& key : keys) {
    if (key.mouth == mouth && on) out.back().to = key.time_s * 24;
    if (key.mouth == mouth && !on) out.push_back({key.time_s * 24, key.time_s * 24});
    on = key.mouth == mouth;
  }
  return out;
}

TEST(MouthKeys, MouthsComeAFrameOrTwoBeforeTheirSound) {
  for (double time = 0.5; time < 0.6; time += 0.007) {
    const auto keys = keys_of({{0, "rest"}, {time, "A"}, {1, "E"}, {1.5, "rest"}});
    const auto open = runs(keys, "A");
    ASSERT_EQ(open.size(), 1U);
    EXPECT_LT(open[0].from, time * 24 - 0.9) << time;
    EXPECT_GT(open[0].from, time * 24 - 2.1) << time;
    EXPECT_NEAR(open[0].from, std::round(open[0].from), 1e-9) << "on a frame";
  }
}

TEST(MouthKeys, LipsAreClosedForAFrameHoweverShortTheSound) {
  for (double time = 0.5; time < 0.6; time += 0.003) {
    const auto keys = keys_of({{0, "A"}, {time, "closed"}, {time + 0.02, "A"}, {1, "rest"}});
    const auto closed = runs(keys, "closed");
    ASSERT_EQ(closed.size(), 1U) << time;
    EXPECT_GE(closed[0].to - closed[0].from, 1 - 1e-9);
    EXPECT_LE(closed[0].from, time * 24 + 1e-6);
    EXPECT_GE(closed[0].to, time * 24) << "while the lips are heard to be closed";
  }
}

TEST(MouthKeys, LipsThatMeetTakeTheFramesOfOtherMouths) {
  const auto keys = keys_of(
      {{0, "A"}, {0.5, "consonants"}, {0.51, "closed"}, {0.53, "L"}, {0.54, "closed"}, {0.6, "E"}, {1, "rest"}});
  EXPECT_EQ(runs(keys, "closed").size(), 1U);
  EXPECT_TRUE(runs(keys, "L").empty());
  EXPECT_EQ(runs(keys, "E").size(), 1U);
}

TEST(MouthKeys, AMouthStaysUntilTheNextOneIsOnItsWay) {
  const auto keys = keys_of({{0, "rest"}, {2, "A"}, {3, "rest"}});
  const auto rest = runs(keys, "rest");
  EXPECT_NEAR(rest[0].to, 47 - k_change_frames, 1.01);
  EXPECT_NEAR(runs(keys, "A")[0].to, 71 - k_change_frames, 1.01);
}

TEST(MouthKeys, TheOffsetOfTheSoundMovesThemAndNoneComesBeforeTheTimeline) {
  EXPECT_EQ(keys_of({{0.5, "A"}, {1, "E"}}, 2).front().time_s, 59.0 / 24);
  const auto cut = keys_of({{0.5, "A"}, {1, "closed"}, {1.1, "E"}, {3, "rest"}}, -2);
  for (std::size_t i = 0; i < cut.size(); ++i) {
    EXPECT_GE(cut[i].time_s, 0);
    if (i > 0) {
      EXPECT_GT(cut[i].time_s, cut[i - 1].time_s);
    }
  }
}

TEST(MouthFile, GivesItsMouths) {
  const auto mouths =
      read_mouth_file(base::as_bytes(R"({"mouths": [{"name": "closed", "values": {"b": 1, "a": 0.5}}]})"));
  ASSERT_TRUE(mouths);
  EXPECT_EQ(mouths->front(), (document::Mouth{"closed", {{"a", 0.5}, {"b", 1}}}));
  for (const std::string_view text :
       {"", "{}", R"({"mouths": []})", R"({"mouths": [{"values": {}}]})", R"({"mouths": [{"name": "a"}]})",
        R"({"mouths": [{"name": "a", "values": {"x": "y"}}]})",
        R"({"mouths": [{"name": "a", "values": {}}, {"name": "a", "values": {}}]})"})
    EXPECT_FALSE(read_mouth_file(base::as_bytes(text)).ok()) << text;
}

TEST(DrawnMouths, WhatIsNotDrawnIsSpokenByTheMostAlike) {
  const auto mouth = [](const char* name) {
    return std::make_shared<const document::Mouth>(document::Mouth{name, {}});
  };
  const document::Mouths drawn{mouth("consonants"), mouth("rest")};
  const auto keys = with_drawn({{0, "A"}, {1, "U"}, {2, "consonants"}}, drawn);
  ASSERT_TRUE(keys);
  EXPECT_EQ(*keys, (document::SpokenMouths{{0, "consonants"}, {1, "rest"}, {2, "consonants"}}));
  // The six that are drawn first speak everything, and lips close on nothing else than m, b, p and pauses.
  const document::Mouths six{mouth("closed"), mouth("A"), mouth("E"), mouth("O"), mouth("F"), mouth("L")};
  const auto spoken = with_drawn({{0, "rest"}, {1, "consonants"}, {2, "U"}, {3, "closed"}, {4, "L"}}, six);
  ASSERT_TRUE(spoken.ok());
  EXPECT_EQ(*spoken, (document::SpokenMouths{{0, "closed"}, {1, "E"}, {2, "O"}, {3, "closed"}, {4, "L"}}));
  EXPECT_EQ(with_drawn({{0, "grin"}}, drawn).error().what, "no mouth stands for \"grin\"");
  EXPECT_FALSE(with_drawn({{0, "U"}}, {mouth("A")}).ok());
  EXPECT_TRUE(usual_mouths(tests::sheet_model()).empty()) << "no control of it is called like a mouth";
}

}  // namespace
}  // namespace penpose::speech
