#include <gtest/gtest.h>

#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "tests/support/track_texts.h"

namespace penpose::io {
namespace {

using tests::bytes;
using tests::s;
using tests::Table;
using tests::text_of;
using tests::two_frames;

TEST(ReadOpenFace, ReadsPointsTimesAndConfidences) {
  const auto track = read_openface_track(bytes(two_frames().text())).value();
  ASSERT_EQ(track.frames.size(), 2U);
  EXPECT_EQ(track.point_count, 68U);
  EXPECT_DOUBLE_EQ(track.frames[1].time_s, 0.04);
  EXPECT_DOUBLE_EQ(track.frames[1].confidence, 0.88);
  EXPECT_EQ(track.frames[1].points[11], (animation::PxPoint{111, 210}));
  EXPECT_EQ(track.frames[0].depths.size(), 68U);
  EXPECT_TRUE(track.notes.empty());
}

/// A row of 68 points in space, mm: the outer corners of the eyes 90 apart at depth 400, the tip of the nose `nose` in
/// front of them, everything else as deep as they are.
std::string solid_points(double nose) {
  std::string x;
  std::string y;
  std::string z;
  for (int i = 0; i < 68; ++i) {
    x += ", " + text_of(i == 36 ? -45 : i == 45 ? 45 : i);
    y += ", 0";
    z += ", " + text_of(i == 30 ? 400 - nose : 400);
  }
  return x + y + z;
}

TEST(ReadOpenFace, TakesTheTrackersOwnTurnOfTheHead) {
  Table table;
  table.before += ", pose_Rx, pose_Ry, pose_Rz";
  table.rows = {s("1, 0.000, 0.98, 1, 0.3, 0, 0") + table.points(0),
                s("2, 0.040, 0.88, 1, 0, 0, nan") + table.points(1),
                s("3, 0.080, 0.88, 1, 0, 0.2, 0.5") + table.points(1)};
  const auto track = read_openface_track(bytes(table.text())).value();
  // A nod: what pointed away from the camera now points up (y is down).
  EXPECT_NEAR(track.frames[0].rotation->operator[](2)[1], -std::sin(0.3), 1e-12);
  EXPECT_FALSE(track.frames[1].rotation);
  const glm::dmat3 r = *track.frames[2].rotation;
  EXPECT_NEAR(r[0][1], std::sin(0.5), 1e-12);
  EXPECT_NEAR(r[2][0], std::sin(0.2), 1e-12);
  EXPECT_FALSE(read_openface_track(bytes(two_frames().text())).value().frames[0].rotation);
}

TEST(ReadOpenFace, TakesTheTrackersOwnDepths) {
  Table table = two_frames();
  for (const char* axis : {"X_", "Y_", "Z_"}) {
    for (int i = 0; i < 68; ++i) table.before += ", " + (axis + std::to_string(i));
  }
  table.rows = {s("1, 0.000, 0.98, 1") + solid_points(30) + table.points(0),
                s("2, 0.040, 0.88, 1") + solid_points(-500) + table.points(1)};
  const auto track = read_openface_track(bytes(table.text())).value();
  const auto& frame = track.frames[0];
  EXPECT_EQ(frame.points[11], (animation::PxPoint{110, 210}));  // px, not mm
  const double scale = geometry::distance(frame.points[36], frame.points[45]) / 90;
  EXPECT_NEAR(frame.depths[30], 30 * scale, 1e-9);
  EXPECT_NEAR(frame.depths[8], 0, 1e-9);
  // What cannot be a face counts as unknown, as in tables without these columns.
  const auto common = read_openface_track(bytes(two_frames().text())).value();
  EXPECT_EQ(track.frames[1].depths, common.frames[1].depths);
}

TEST(ReadOpenFace, TakesOtherCountriesTables) {
  Table table = two_frames();
  std::string text = table.text();
  std::string other;
  for (const char c : text) other += c == ',' ? ';' : c == '.' ? ',' : c;
  const auto track = read_openface_track(bytes(other)).value();
  EXPECT_DOUBLE_EQ(track.frames[1].time_s, 0.04);
  EXPECT_EQ(track.frames[1].points[11], (animation::PxPoint{111, 210}));
}

TEST(ReadOpenFace, NamesTheLineOfDecimalCommasBetweenCommas) {
  Table table = two_frames();
  table.rows[1] = s("2, 0,040, 0,88, 1") + table.points(1);
  const auto error = read_openface_track(bytes(table.text())).error();
  EXPECT_EQ(error.place, "line 3");
  EXPECT_NE(error.remedy.find("decimal point"), std::string::npos);
}

TEST(ReadOpenFace, NamesTheFirstMissingColumn) {
  const auto error = read_openface_track(bytes("frame, timestamp, confidence, success, x_0\n1, 0, 1, 1, 5\n")).error();
  EXPECT_EQ(error.place, "line 1");
  EXPECT_NE(error.what.find("y_0"), std::string::npos);
  EXPECT_EQ(read_openface_track(bytes("\n\n")).error().place, "line 1");
}

TEST(ReadOpenFace, DoesNotTakeMillimetresForPx) {
  // OpenFace writes x_0 in px and X_0 in mm into one file.
  auto table = two_frames();
  std::string text = table.text();
  text.replace(text.find("x_40"), 4, "X_40");
  const auto error = read_openface_track(bytes(text)).error();
  EXPECT_NE(error.what.find("x_40"), std::string::npos) << error.line();
}

TEST(ReadOpenFace, HoldsFramesThatShowNoFace) {
  Table table;
  table.rows = {s("1, 0.00, 0.98, 1") + table.points(0), s("2, 0.04, 0.98, 0") + table.points(1),
                s("3, 0.08, 0.00, 1") + table.points(2), "4, 0.12, 0.98, 1, 5, 6",
                s("5, 0.16, nan, 1") + table.points(4),  s("6, 0.20, 0.98, 1") + table.points(5)};
  std::string& last = table.rows[5];
  last.replace(last.find("115"), 10, "nan");
  table.rows.push_back(s("7, 0.24, 0.98, 1") + table.points(6));
  const auto track = read_openface_track(bytes(table.text())).value();
  ASSERT_EQ(track.frames.size(), 7U);
  for (const std::size_t f : {1U, 2U, 3U, 4U, 5U}) EXPECT_FALSE(track.frames[f].found()) << f;
  EXPECT_TRUE(track.frames[6].found());
  EXPECT_GE(track.notes.size(), 4U);
  EXPECT_EQ(track.notes[0].substr(0, 7), "line 3:");
}

TEST(ReadOpenFace, RefusesTextWhereANumberBelongs) {
  Table table = two_frames();
  table.rows[1].replace(table.rows[1].find("0.88"), 4, "good");
  const auto error = read_openface_track(bytes(table.text())).error();
  EXPECT_EQ(error.place, "line 3");
  EXPECT_NE(error.what.find("good"), std::string::npos);
}

TEST(ReadOpenFace, FillsFramesThatAreLeftOut) {
  Table table;
  table.rows = {s("1, 0.00, 0.9, 1") + table.points(0), s("2, 0.04, 0.9, 1") + table.points(1),
                s("5, 0.16, 0.9, 1") + table.points(4)};
  const auto track = read_openface_track(bytes(table.text())).value();
  ASSERT_EQ(track.frames.size(), 5U);
  EXPECT_FALSE(track.frames[2].found());
  EXPECT_NEAR(track.frames[3].time_s, 0.12, 1e-9);
  table.rows[2] = s("4000000000, 0.16, 0.9, 1") + table.points(4);
  EXPECT_EQ(read_openface_track(bytes(table.text())).value().frames.size(), 3U);
}

TEST(ReadOpenFace, NumbersThatStandStillAreNotTrusted) {
  Table table;
  for (int f = 0; f < 3; ++f) table.rows.push_back(s("0, ") + text_of(0.1 * f) + s(", 0.9, 1") + table.points(f));
  const auto track = read_openface_track(bytes(table.text())).value();
  ASSERT_EQ(track.frames.size(), 3U);
  EXPECT_NEAR(track.frames[2].time_s, 0.2, 1e-9);
  // Nor are times that stand still.
  for (std::string& row : table.rows) row.replace(0, row.find(", 0.9"), "0, 0");
  EXPECT_NEAR(read_openface_track(bytes(table.text()))->frames[2].time_s, 2.0 / 30, 1e-9);
}

TEST(ReadOpenFace, TakesTimesInMilliseconds) {
  Table table;
  for (int f = 0; f < 5; ++f)
    table.rows.push_back(std::to_string(f + 1) + ", " + text_of(40 * f) + ", 0.9, 1" + table.points(f));
  EXPECT_NEAR(read_openface_track(bytes(table.text())).value().frames[4].time_s, 0.16, 1e-9);
  // A pause does not make milliseconds of seconds.
  for (int f = 0; f < 5; ++f) {
    std::string& row = table.rows[static_cast<std::size_t>(f)];
    row = std::to_string(f + 1) + ", " + text_of(f < 4 ? 0.04 * f : 30) + ", 0.9, 1" + table.points(f);
  }
  EXPECT_NEAR(read_openface_track(bytes(table.text())).value().frames[3].time_s, 0.12, 1e-9);
  Table ibug;
  ibug.before = "frame, timestamp";
  for (int f = 0; f < 5; ++f) ibug.rows.push_back(s("1, ") + text_of(40 * f) + ibug.points(f));
  EXPECT_NEAR(read_ibug_track(bytes(ibug.text())).value().frames[4].time_s, 0.16, 1e-9);
}

TEST(ReadOpenFace, HoldsWhatMicrosoftsLibrariesWriteForNoNumber) {
  for (const char* nothing : {"1.#QNAN", "-1.#IND", "1.#INF", "-1.#IND00"}) {
    Table table = two_frames();
    table.rows[1].replace(table.rows[1].find("111"), 10, nothing);
    const auto track = read_openface_track(bytes(table.text()));
    ASSERT_TRUE(track.ok()) << track.error().line();
    EXPECT_TRUE(track->frames[0].found());
    EXPECT_FALSE(track->frames[1].found()) << nothing;
    ASSERT_EQ(track->notes.size(), 1U);
    EXPECT_TRUE(track->notes[0].starts_with("line 3: ")) << track->notes[0];
  }
}

TEST(ReadOpenFace, KeepsTheFaceThatIsSeenBest) {
  Table table;
  table.before = "frame,face_id,timestamp,confidence,success";
  table.separator = ",";
  table.rows = {s("1,0,0.00,0.3,1") + table.points(50), s("1,1,0.00,0.9,1") + table.points(0),
                s("2,0,0.04,0.3,1") + table.points(50), s("2,1,0.04,0.9,1") + table.points(1),
                s("3,0,0.08,0.3,1") + table.points(50)};
  const auto track = read_openface_track(bytes(table.text())).value();
  ASSERT_EQ(track.frames.size(), 3U);
  EXPECT_EQ(track.frames[0].points[0].x, 100);
  ASSERT_EQ(track.notes.size(), 2U);
  EXPECT_NE(track.notes[0].find("2 faces"), std::string::npos);
  EXPECT_FALSE(track.frames[2].found());
  EXPECT_NEAR(track.frames[2].time_s, 0.08, 1e-9);
  EXPECT_EQ(track.notes[1], "line 6: only face 0 is seen, not the one that is read; the frame is held");
}

}  // namespace
}  // namespace penpose::io
