#include <gtest/gtest.h>

#include "core/base/byte_writer.h"
#include "core/document/time/animation_building.h"
#include "core/io/surface/read_obj.h"
#include "core/io/surface/shape_list.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "core/io/tracks/vmd/shift_jis.h"
#include "core/io/tracks/vmd/write_vmd.h"

namespace penpose::io {
namespace {

void pad(base::ByteWriter& out, std::string_view text, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) out.write(static_cast<std::uint8_t>(i < text.size() ? text[i] : 0));
}

struct MorphKey {
  std::string name;
  std::uint32_t frame;
  float weight;
};

std::vector<std::uint8_t> motion(const std::vector<MorphKey>& keys, std::uint32_t bones = 0) {
  base::ByteWriter out;
  pad(out, "Vocaloid Motion Data 0002", 30);
  pad(out, "Miku", 20);
  out.write(bones);
  for (std::uint32_t b = 0; b < bones; ++b) pad(out, "bone", 111);
  out.write(static_cast<std::uint32_t>(keys.size()));
  for (const MorphKey& key : keys) {
    pad(out, key.name, 15);
    out.write(key.frame);
    out.write_f32(key.weight);
  }
  return out.take();
}

TEST(ShiftJis, GoesToUtf8AndBack) {
  EXPECT_EQ(utf8_of_shift_jis(base::as_bytes("\x82\xa0")), "あ");
  EXPECT_EQ(utf8_of_shift_jis(base::as_bytes("\xb3\xa8\xdd\xb8\x82\x51\x89\x45")), "ｳｨﾝｸ２右");
  for (const char* name :
       {"まばたき", "笑い", "ウィンク右", "じと目", "にやり２", "真面目", "瞳小", "jawOpen", "ｷﾘｯ", "①"}) {
    const ShiftJis written = shift_jis_of(name, 100);
    EXPECT_TRUE(written.whole) << name;
    EXPECT_EQ(utf8_of_shift_jis(base::as_bytes(written.bytes)), name);
  }
  const ShiftJis cut = shift_jis_of("ウィンク右ウィンク右", 15);
  EXPECT_EQ(cut.bytes.size(), 14U) << "no letter is cut in two";
  EXPECT_FALSE(cut.whole);
  EXPECT_EQ(shift_jis_of("\xf0\x9f\x98\x80", 15).bytes, "?");
  EXPECT_EQ(utf8_of_shift_jis(base::as_bytes("\x82")), "?");
}

TEST(ReadVmd, MorphKeysAreLinearAt30Frames) {
  const auto bytes = motion({{"\x82\xa0", 0, 0}, {"\x82\xa0", 30, 1}, {"\x82\xa0", 10, 0.5F}, {"\x82\xa2", 0, 0}}, 2);
  EXPECT_EQ(format_of_track(bytes)->name, "vmd");
  const auto track = read_vmd_track(bytes).value();
  EXPECT_EQ(track.names, std::vector<std::string>{"あ"}) << "a morph that never moves is left out";
  ASSERT_EQ(track.frames.size(), 31U);
  EXPECT_NEAR(track.frames[5].values[0], 0.25, 1e-9);
  EXPECT_NEAR(track.frames[20].values[0], 0.75, 1e-9);
  EXPECT_NEAR(track.frames[30].time_s, 1, 1e-9);
  EXPECT_EQ(track.notes.size(), 1U);
}

TEST(ReadVmd, BrokenFilesAreSaidInOneLine) {
  const auto whole = motion({{"a", 0, 1}, {"a", 5, 0}}, 1);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(read_vmd_track(base::Bytes(whole).first(size))) << size;
  }
  EXPECT_FALSE(read_vmd_track(motion({{"a", 0xffffffff, 1}})));
  EXPECT_FALSE(read_vmd_track(motion({})));
}

document::Model square_with(const std::vector<std::string>& names) {
  const auto square = [](const char* text) { return read_obj(base::as_bytes(text)).value(); };
  std::vector<ShownShape> shapes;
  for (const std::string& name : names) {
    shapes.push_back({name, square("v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 1 0\nf 1 2 3 4\n")});
  }
  return with_shapes(square("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"), shapes).value();
}

TEST(WriteVmd, ReadsBackAsItWas) {
  auto model = square_with({"あ", "まばたき", "aVeryLongNameOfAControl"});
  const std::vector<double> times{0, 0.5, 1};
  const std::vector<rig::Pose> poses{{0, 1, 0}, {0.5, 0, 0.25}, {0.25, 0, 1}};
  model.animations = {document::make_animation(model, "clip", times, poses)};
  const auto written = write_vmd(model).value();
  const auto track = read_vmd_track(written.bytes).value();
  ASSERT_EQ(track.names.size(), 3U);
  ASSERT_EQ(track.frames.size(), 31U);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t control = track.names[i] == "あ" ? 0 : track.names[i] == "まばたき" ? 1 : 2;
    EXPECT_NEAR(track.frames[0].values[i], poses[0][control], 1e-6);
    EXPECT_NEAR(track.frames[15].values[i], poses[1][control], 1e-3);
    EXPECT_NEAR(track.frames[30].values[i], poses[2][control], 1e-6);
  }
  EXPECT_LT(written.bytes.size(), 30U + 20 + 4 + 4 + 9 * 23 + 12 + 1) << "keys only where the lines turn";
  ASSERT_EQ(written.notes.size(), 1U);
  EXPECT_NE(written.notes[0].find("15 bytes"), std::string::npos);
}

}  // namespace
}  // namespace penpose::io
