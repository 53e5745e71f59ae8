#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "firmware_io/decode/hand_factory.h"
#include "firmware_io/decode/layout/protocol.h"
#include "tests/support/shared_data.h"

namespace penpose::decode {
namespace {

using Report = std::vector<std::uint8_t>;

nlohmann::json shared_vectors() {
  const auto bytes = tests::read_file(tests::shared_dir() / "tablets" / "vectors_visible.json");
  return nlohmann::json::parse(bytes.begin(), bytes.end(), nullptr, false);
}

Report from_hex(const std::string& text) {
  Report bytes;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) {
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(text.substr(i, 2), nullptr, 16)));
  }
  return bytes;
}

std::uint64_t bits_of(const nlohmann::json& list) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < list.size(); ++i) bits |= list[i].get<std::uint64_t>() << i;
  return bits;
}

void expect_pen(const nlohmann::json& want, const PenSample& sample) {
  const bool near = want.value("near", true);
  EXPECT_EQ(sample.in_range, near);
  const auto equal = [&](const char* name, std::int64_t value) {
    if (want.contains(name)) {
      EXPECT_EQ(value, want[name].get<std::int64_t>()) << name;
    }
  };
  equal("x", sample.x);
  equal("y", sample.y);
  equal("distance", sample.distance);
  if (!near) return;
  equal("scroll", sample.wheel);
  if (want["kind"] == "mouse") {
    EXPECT_EQ(sample.tool, Tool::mouse);
    EXPECT_EQ(sample.buttons, bits_of(want["mouse_buttons"]));
    return;
  }
  equal("pressure", sample.pressure);
  equal("tilt_x", sample.tilt_x);
  equal("tilt_y", sample.tilt_y);
  equal("rotation", sample.rotation);
  equal("finger_wheel", sample.wheel);
  EXPECT_EQ(sample.buttons, bits_of(want["buttons"]));
  EXPECT_EQ(sample.tool, want.value("eraser", false) ? Tool::eraser : Tool::pen);
  if (want.contains("tip")) {
    EXPECT_EQ(sample.tip, want["tip"].get<bool>());
  }
}

void expect_pad(const nlohmann::json& want, const PadState& pad) {
  if (want.contains("aux") && !want["aux"].empty()) {
    EXPECT_EQ(pad.keys, bits_of(want["aux"]));
  }
  if (want.contains("wheel_buttons")) {
    EXPECT_EQ(pad.wheel_buttons, bits_of(want["wheel_buttons"]));
  }
  if (want.contains("wheel_pos")) {
    const auto& position = want["wheel_pos"][0];
    EXPECT_EQ(pad.wheel_position, position.is_null() ? -1 : position.get<int>());
  }
  if (!want.contains("wheel_delta")) return;
  EXPECT_EQ(pad.wheel_delta, want["wheel_delta"][0].get<int>());
  if (want["wheel_delta"].size() > 1) {
    EXPECT_EQ(pad.second_wheel_delta, want["wheel_delta"][1].get<int>());
  }
}

TEST(SharedTablets, EveryVectorDecodes) {
  if (!tests::has_shared()) GTEST_SKIP() << "no shared data";
  const auto document = shared_vectors();
  ASSERT_TRUE(document.is_object());
  std::size_t reports = 0;
  for (const auto& vector : document["vectors"]) {
    SCOPED_TRACE(vector["id"].get<std::string>());
    const auto decoder = make_protocol_decoder(vector["family"].get<std::string>());
    ASSERT_NE(decoder, nullptr);
    for (const auto& report : vector["reports"]) {
      ++reports;
      const auto& want = report["expect"];
      const auto kind = want["kind"].get<std::string>();
      const auto got = decoder->decode(from_hex(report["hex"].get<std::string>()));
      if (kind == "pen" || kind == "mouse") {
        ASSERT_EQ(got, ReportKind::pen);
        expect_pen(want, decoder->sample());
        expect_pad(want, decoder->pad());
      } else if (kind == "out_of_range") {
        EXPECT_EQ(got, ReportKind::pen);
        EXPECT_FALSE(decoder->sample().in_range);
      } else if (kind == "aux" || kind == "wheel") {
        ASSERT_EQ(got, ReportKind::pad);
        expect_pad(want, decoder->pad());
      } else if (kind == "touch") {
        EXPECT_NE(got, ReportKind::pen);
        expect_pad(want, decoder->pad());
      } else {
        EXPECT_TRUE(got != ReportKind::pen || !decoder->sample().in_range) << kind;
      }
    }
  }
  EXPECT_GT(reports, 600U);
}

/// A contact of a vector: its slot, which is the finger's place among all of them, and where it is.
TEST(SharedTablets, FingersOfEveryVector) {
  if (!tests::has_shared()) GTEST_SKIP() << "no shared data";
  const auto vectors = shared_vectors();
  unsigned frames = 0;
  for (const auto& vector : vectors["vectors"]) {
    auto hand = make_protocol_hand_decoders(vector["family"].get<std::string>());
    if (!hand.touch) continue;
    SCOPED_TRACE(vector["id"].get<std::string>());
    for (const auto& report : vector["reports"]) {
      const bool ended = hand.touch->decode(from_hex(report["hex"].get<std::string>()));
      const auto& want = report["expect"];
      EXPECT_EQ(ended, want["kind"] == "touch");
      if (want["kind"] != "touch") continue;
      ++frames;
      const auto contacts = hand.touch->contacts();
      ASSERT_EQ(contacts.size(), want["touches"].size());
      for (std::size_t i = 0; i < contacts.size(); ++i) {
        EXPECT_EQ(contacts[i].x, want["touches"][i]["x"].get<int>());
        EXPECT_EQ(contacts[i].y, want["touches"][i]["y"].get<int>());
      }
    }
  }
  EXPECT_GE(frames, 20U);
}

}  // namespace
}  // namespace penpose::decode
