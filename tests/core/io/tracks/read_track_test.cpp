#include "core/io/tracks/read_track.h"

#include <cmath>
#include <gtest/gtest.h>

#include "core/io/tracks/track_formats.h"

namespace penpose::io {
namespace {

base::Bytes bytes(const std::string& text) { return base::as_bytes(text); }

/// A text that others are appended to.
std::string s(const char* text) { return text; }

std::string text_of(double value) { return std::to_string(value); }

/// A table of 68 points in OpenFace's way. Point i of frame f is (100 + 10 (i % 10) + f, 200 + 10 (i / 10)).
struct Table {
  std::string separator = ", ";
  std::string before = "frame, timestamp, confidence, success";
  std::vector<std::string> rows;

  [[nodiscard]] std::string header() const {
    std::string line = before;
    for (const char* axis : {"x_", "y_"}) {
      for (int i = 0; i < 68; ++i) line += separator + axis + std::to_string(i);
    }
    return line + "\n";
  }
  [[nodiscard]] std::string points(int frame) const {
    std::string line;
    for (int i = 0; i < 68; ++i) line += separator + text_of(100 + 10 * (i % 10) + frame);
    for (int i = 0; i < 68; ++i) line += separator + text_of(200 + 10 * (i / 10));
    return line;
  }
  [[nodiscard]] std::string text() const {
    std::string all = header();
    for (const std::string& row : rows) all += row + "\n";
    return all;
  }
};

Table two_frames() {
  Table table;
  table.rows = {s("1, 0.000, 0.98, 1") + table.points(0), s("2, 0.040, 0.88, 1") + table.points(1)};
  return table;
}

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

TEST(FormatOfTrack, IsNotGuessedForPointsOfAnotherNumber) {
  std::string text = "x_0,y_0";
  for (int i = 1; i < 400; ++i) text += ",x_" + std::to_string(i) + ",y_" + std::to_string(i);
  EXPECT_EQ(format_of_track(bytes(text + "\n1,2\n")), nullptr);
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

std::string mediapipe_wide(int points, bool normalised) {
  std::string text = "frame,timestamp";
  for (int i = 0; i < points; ++i) {
    const std::string n = std::to_string(i);
    text += s(",x_") + n + ",y_" + n + ",z_" + n;
  }
  for (int f = 0; f < 2; ++f) {
    text += s("\n") + std::to_string(f) + "," + std::to_string(33 * f);
    for (int i = 0; i < points; ++i) {
      const double scale = normalised ? 0.001 : 1;
      text += s(",") + text_of(scale * i) + "," + text_of(scale * (i + 100)) + "," + text_of(-scale * 7);
    }
  }
  return text + "\n";
}

TEST(ReadMediapipeCsv, ReadsRowsOfFramesInPx) {
  const auto track = read_mediapipe_csv(bytes(mediapipe_wide(478, false)), {}).value();
  EXPECT_EQ(track.point_count, 478U);
  EXPECT_EQ(track.frames[1].points[3], (animation::PxPoint{3, 103}));
  EXPECT_NEAR(track.frames[1].time_s, 0.033, 1e-9);  // milliseconds
  EXPECT_NEAR(track.frames[0].depths[5], 7, 1e-9);
}

TEST(ReadMediapipeCsv, SharesOfThePictureNeedItsSize) {
  const auto text = mediapipe_wide(468, true);
  const auto track = read_mediapipe_csv(bytes(text), PictureSize{1920, 1080}).value();
  EXPECT_EQ(track.point_count, 468U);
  EXPECT_NEAR(track.frames[0].points[100].x, 192, 1e-9);
  EXPECT_NEAR(track.frames[0].points[100].y, 216, 1e-9);
  const auto square = read_mediapipe_csv(bytes(text), {}).value();
  ASSERT_EQ(square.notes.size(), 1U);
  EXPECT_NE(square.notes[0].find("--picture"), std::string::npos);
}

TEST(ReadMediapipeCsv, ReadsRowsOfPoints) {
  std::string text = "frame,landmark,x,y,z\n";
  for (int f = 0; f < 2; ++f) {
    for (int i = 0; i < 468; ++i) {
      if (f == 1 && i == 40) continue;
      text += std::to_string(f) + "," + std::to_string(i) + "," + std::to_string(i + 3) + "," + std::to_string(2 * i) +
              ",0\n";
    }
  }
  const auto track = read_mediapipe_csv(bytes(text), {}).value();
  EXPECT_EQ(track.frames[0].points[40], (animation::PxPoint{43, 80}));
  EXPECT_FALSE(track.frames[1].found());
  EXPECT_EQ(read_mediapipe_csv(bytes("frame,landmark,x,y\n0,478,1,1\n"), {}).error().place, "line 2");
  EXPECT_EQ(read_mediapipe_csv(bytes("frame,x_0,y_0\n0,1,1\n"), {}).error().place, "line 1");
}

std::string face(int shift, int points = 468, const char* form = "object") {
  std::string text = "[";
  for (int i = 0; i < points; ++i) {
    const std::string x = std::to_string(i + shift);
    const std::string y = std::to_string(2 * i);
    if (i > 0) text += ",";
    text +=
        std::string(form) == "object" ? s(R"({"x":)") + x + R"(,"y":)" + y + R"(,"z":-1})" : s("[") + x + "," + y + "]";
  }
  return text + "]";
}

TEST(ReadMediapipeJson, ReadsTheShapesThatProgramsWrite) {
  const std::string list = s("[") + face(0) + "," + face(1) + ",null]";
  for (const std::string& text :
       {list, s(R"({"fps": 25, "frames": )") + list + "}",
        s(R"({"frames": [{"landmarks": )") + face(0) + R"(}, {"landmarks": )" + face(1) + R"(}, {"landmarks": []}]})",
        s(R"({"frames": [{"faceLandmarks": [)") + face(0) + R"(]}, {"faceLandmarks": [)" + face(1) + R"(]}, {}]})",
        s("[") + face(0, 478, "list") + "," + face(1, 478, "list") + ",[]]"}) {
    const auto track = read_mediapipe_json(bytes(text), {});
    ASSERT_TRUE(track.ok()) << track.error().line();
    ASSERT_EQ(track->frames.size(), 3U);
    EXPECT_EQ(track->frames[1].points[7], (animation::PxPoint{8, 14}));
    EXPECT_FALSE(track->frames[2].found());
  }
}

TEST(ReadMediapipeJson, TakesTimesInMilliseconds) {
  const std::string text = s(R"({"frames": [{"timestamp": 0, "landmarks": )") + face(0) +
                           R"(}, {"timestamp": 40, "landmarks": )" + face(1) + "}]}";
  EXPECT_NEAR(read_mediapipe_json(bytes(text), {}).value().frames[1].time_s, 0.04, 1e-9);
}

TEST(ReadMediapipeJson, TakesTimesOfTheDayInAnyUnit) {
  for (const char* const times : {"1700000000000,1700000000040", "1700000000000000,1700000000040000",
                                  "1700000000.00,1700000000.04", "\"0.00\",\"0.04\""}) {
    const std::string both = times;
    const auto comma = both.find(',');
    const std::string text = s(R"({"frames": [{"timestamp": )") + both.substr(0, comma) + R"(, "landmarks": )" +
                             face(0) + R"(}, {"timestamp": )" + both.substr(comma + 1) + R"(, "landmarks": )" +
                             face(1) + "}]}";
    const auto track = read_mediapipe_json(bytes(text), {}).value();
    EXPECT_NEAR(track.frames[1].time_s - track.frames[0].time_s, 0.04, 1e-3) << times;
  }
}

TEST(ReadMediapipeJson, TakesAFrameALine) {
  const std::string line = s(R"({"landmarks": )") + face(0) + "}\n";
  EXPECT_EQ(read_mediapipe_json(bytes(line + "\n" + line + "null\n"), {}).value().frames.size(), 3U);
  EXPECT_EQ(read_mediapipe_json(bytes(line + line + line.substr(0, 50)), {}).error().place, "line 3");
  EXPECT_TRUE(read_mediapipe_json(bytes("{\n\"frames\": x}"), {}).error().place.starts_with("byte offset"));
}

TEST(ReadMediapipeCsv, OnePointFarOffDoesNotMakeItPx) {
  std::string text = mediapipe_wide(468, true);
  const auto last = text.find_last_of(',');
  const auto before = text.find_last_of(',', last - 1);
  text.replace(before + 1, last - before - 1, "3.5");
  const auto track = read_mediapipe_csv(bytes(text), PictureSize{1920, 1080}).value();
  EXPECT_NEAR(track.frames[0].points[100].x, 192, 1e-9);
}

TEST(ReadMediapipeJson, FollowsOneFaceOfSeveral) {
  const std::string text = s(R"([{"faceLandmarks": [)") + face(0) + "," + face(5000) + R"(]}, {"faceLandmarks": [)" +
                           face(5001) + "," + face(1) + "]}]";
  const auto track = read_mediapipe_json(bytes(text), {}).value();
  EXPECT_EQ(track.frames[0].points[0].x, 0);
  EXPECT_EQ(track.frames[1].points[0].x, 1);
}

TEST(ReadMediapipeJson, SaysWhereItIsWrong) {
  EXPECT_EQ(
      read_mediapipe_json(bytes(s("[") + face(0, 12) + "]"), {}).error().line(),
      "frame 0: no frame shows a face: a face of 468 or 478 points was expected, not of 12; track the video again");
  EXPECT_EQ(read_mediapipe_json(bytes("{}"), {}).error().place, "/frames");
  const auto mixed = read_mediapipe_json(bytes(s("[") + face(0) + "," + face(0, 478) + "," + face(0, 5) + "]"), {});
  EXPECT_FALSE(mixed.value().frames[1].found());
  EXPECT_FALSE(mixed.value().frames[2].found());
  EXPECT_EQ(mixed.value().notes.size(), 2U);
  EXPECT_FALSE(read_mediapipe_json(bytes("[null, null]"), {}).ok());
  EXPECT_EQ(read_mediapipe_json(bytes("[1]"), {}).error().place, "frame 0 (/0)");
  const std::string odd = s(R"({"frames": [{"landmarks": )") + face(0) + R"(}, {"landmarks": [1, 2]}]})";
  EXPECT_EQ(read_mediapipe_json(bytes(odd), {}).error().place, "frame 1 (/frames/1/landmarks/0)");
  EXPECT_NE(read_mediapipe_json(bytes(R"([{"mesh": []}])"), {}).error().what.find("faceLandmarks"), std::string::npos);
}

/// One picture's result, in the shapes that programs give it.
TEST(ReadMediapipeJson, TakesASingleFace) {
  for (const std::string& text :
       {face(3), face(3, 478, "list"), s(R"({"frames": )") + face(3) + "}", s(R"({"landmarks": )") + face(3) + "}",
        s(R"({"faceLandmarks": [)") + face(3) + R"(], "faceBlendshapes": []})", s("[") + face(3) + "]",
        s(R"([{"faces": [{"keypoints": )") + face(3) + "}]}]",
        s(R"([{"multi_face_landmarks": [{"landmark": )") + face(3) + "}]}]"}) {
    const auto track = read_mediapipe_json(bytes(text), {});
    ASSERT_TRUE(track.ok()) << track.error().line() << text.substr(0, 60);
    ASSERT_EQ(track->frames.size(), 1U) << text.substr(0, 60);
    EXPECT_EQ(track->frames[0].points[7], (animation::PxPoint{10, 14})) << text.substr(0, 60);
  }
  const auto clip = read_mediapipe_json(bytes(s(R"({"face_landmarks": [)") + face(0) + "," + face(1) + "]}"), {});
  EXPECT_EQ(clip.value().frames.size(), 2U);
}

TEST(ReadIbug, ReadsBlocksTablesAndBareRows) {
  std::string block = "version: 1\nn_points:  68\n{\n";
  std::string bare;
  for (int i = 0; i < 68; ++i) {
    block += std::to_string(i) + " " + std::to_string(i + 5) + "\n";
    if (i > 0) bare += ",";
    bare += std::to_string(i) + "," + std::to_string(i + 5);
  }
  block += "}\n";
  for (const std::string& text : {block + block, s(bare.c_str()) + "\n" + bare + "\n"}) {
    const auto track = read_ibug_track(bytes(text));
    ASSERT_TRUE(track.ok()) << track.error().line();
    ASSERT_EQ(track->frames.size(), 2U);
    EXPECT_EQ(track->frames[1].points[9], (animation::PxPoint{9, 14}));
  }
  Table table = two_frames();
  EXPECT_EQ(read_ibug_track(bytes(table.text()))->frames.size(), 2U);
  EXPECT_EQ(read_ibug_track(bytes("n_points: 29\n{\n1 2\n}\n")).error().place, "line 1");
  EXPECT_EQ(read_ibug_track(bytes(block + "{\n1,5 2,5\n}\n")).error().place, "line 74");
  EXPECT_FALSE(read_ibug_track(bytes(block + "{\n1 2\n}\n"))->frames[1].found());
}

TEST(ReadCurveTrack, ReadsNamedCurves) {
  const auto track = read_curve_track(bytes(R"({"fps": 25, "frames": [
    {"curves": {"b": [[0, 0], [10, 0], [20, 0]], "a": [[1, 1], [2, 2]]}},
    {"curves": {"a": [[1, 1], [2, 3]], "b": [[0, 0], [20, 0]]}, "confidence": 0.5},
    null,
    {"curves": {"a": [[1, 1], null], "b": [[0, 0], [20, 0]]}}]})"))
                         .value();
  ASSERT_EQ(track.frames.size(), 4U);
  ASSERT_EQ(track.groups.size(), 2U);
  EXPECT_EQ(track.groups[0].name, "a");
  EXPECT_EQ(track.groups[1].first, 2U);
  EXPECT_EQ(track.frames[1].points[3], (animation::PxPoint{10, 0}));  // resampled to three points
  EXPECT_DOUBLE_EQ(track.frames[1].time_s, 0.04);
  EXPECT_FALSE(track.frames[2].found());
  EXPECT_FALSE(track.frames[3].found());
}

TEST(ReadCurveTrack, SaysWhereItIsWrong) {
  const auto place = [](const char* text) { return read_curve_track(bytes(text)).error().place; };
  EXPECT_EQ(place("[]"), "/frames");
  EXPECT_EQ(place(R"({"fps": 0, "frames": []})"), "/fps");
  EXPECT_EQ(place(R"({"frames": [{"curves": {"a": [[1, 1]]}}]})"), "/frames/0/curves/a");
  EXPECT_EQ(place(R"({"frames": [{"curves": {"a": [[1, 1], [2, "3"]]}}]})"), "/frames/0/curves/a/1");
  EXPECT_EQ(place(R"({"frames": [{"curves": {"a": [[1, 1], [2, 3]]}}, {"curves": {"b": [[1, 1], [2, 3]]}}]})"),
            "frame 0");
  EXPECT_EQ(place(R"({"frames": [{"curves": {"a": 7}}]})"), "/frames/0/curves/a");
  EXPECT_EQ(place(R"({"frames": [{"curves": {"a": [[1, 1], [2, 3]], "b": []}}, {"curves": {"b": null}}]})"),
            "/frames/0/curves/b");
}

TEST(ReadCurveTrack, HoldsFramesInWhichACurveIsMissing) {
  const auto track = read_curve_track(bytes(R"({"frames": [
    {"curves": {"a": [[0, 0], [1, 0]]}},
    {"curves": {"a": [[0, 0], [1, 0]], "b": [[5, 5], [6, 6]]}},
    {"curves": {"a": null, "b": [[5, 5], [6, 6]]}},
    {"curves": {"a": [], "b": [[5, 5], [6, 6]]}},
    {"curves": {"a": [[0, 0], [1, NaN]], "b": [[5, 5], [6, 6]]}},
    {"curves": {"a": [[0, 0]], "b": [[5, 5], [6, 6]]}},
    {"curves": {"a": [[0, 0], [1, 0]], "b": [[5, 5], [6, 6]], "bb": [[5, 5], [6, 6]]}, "confidence": NaN},
    {"curves": {"a": [[0, 0], [2, 0]], "b": [[5, 5], [6, 6]]}, "time": NaN}]})"))
                         .value();
  ASSERT_EQ(track.frames.size(), 8U);
  for (std::size_t f = 0; f < 8; ++f) EXPECT_EQ(track.frames[f].found(), f == 1 || f == 7) << f;
  EXPECT_EQ(track.frames[7].points, (std::vector<animation::PxPoint>{{0, 0}, {2, 0}, {5, 5}, {6, 6}}));
  ASSERT_EQ(track.notes.size(), 7U);
  EXPECT_TRUE(track.notes[0].starts_with("curve bb is shown by 1 of 8 frames only")) << track.notes[0];
  EXPECT_EQ(track.notes[1], "frame 0: curve b is missing; the frame is held");
  EXPECT_EQ(track.notes[3], "frame 3: curve a is empty; the frame is held");
  EXPECT_EQ(track.notes[4], "frame 4: curve a has a point that is no number; the frame is held");
}

TEST(ReadMediapipeJson, HoldsFramesThatAreNoNumber) {
  std::string broken = face(1);
  broken.replace(broken.find("\"x\":1,"), 6, "\"x\":NaN,");
  const auto track = read_mediapipe_json(bytes(s("[") + face(0) + "," + broken + "," + face(2) + "]"), {}).value();
  ASSERT_EQ(track.frames.size(), 3U);
  EXPECT_FALSE(track.frames[1].found());
  EXPECT_EQ(track.frames[2].points[7], (animation::PxPoint{9, 14}));
  ASSERT_EQ(track.notes.size(), 1U);
  EXPECT_TRUE(track.notes[0].starts_with("frame 1: ")) << track.notes[0];
}

TEST(ReadMediapipeCsv, ALandmarkThatComesAgainIsNoted) {
  std::string table = "frame,landmark,x,y\n";
  for (int f = 0; f < 2; ++f) {
    for (int i = 0; i < 468; ++i)
      table += std::to_string(f) + "," + std::to_string(i) + "," + std::to_string(i) + "," + std::to_string(f) + "\n";
  }
  const auto track = read_mediapipe_csv(bytes(table + "1,5,900,900\n"), std::nullopt).value();
  EXPECT_EQ(track.frames[1].points[5], (animation::PxPoint{5, 1}));
  ASSERT_FALSE(track.notes.empty());
  EXPECT_TRUE(track.notes[0].starts_with("line 938: landmark 5 of frame 1 comes again")) << track.notes[0];
}

TEST(ReadArkit, TellsTheRateFromWholeSeconds) {
  for (const int fps : {24, 25, 30, 50, 60}) {
    std::string text = "Timecode,BlendShapeCount,JawOpen\n";
    for (int f = 0; f < 3 * fps; ++f)
      text += "01:02:0" + std::to_string(f / fps) + ":" + std::to_string(f % fps) + ".000,1,0.5\n";
    const auto track = read_arkit_track(bytes(text)).value();
    for (int f = 0; f < 3 * fps; ++f)
      EXPECT_NEAR(track.frames[static_cast<std::size_t>(f)].time_s, f / static_cast<double>(fps), 1e-6) << fps;
  }
}

TEST(ReadArkit, ReadsNamesTimesAndHolds) {
  const auto track = read_arkit_track(bytes("Timecode,BlendShapeCount,EyeBlinkLeft,JawOpen\n"
                                            "23:59:59:59.5,61,0.1,0.2\n00:00:00:00.5,61,0.3,0.4\n"
                                            "00:00:00:01.5,0\n00:00:00:02.5,61,nan,0\n"))
                         .value();
  EXPECT_EQ(track.names, (std::vector<std::string>{"EyeBlinkLeft", "JawOpen"}));
  ASSERT_EQ(track.frames.size(), 4U);
  EXPECT_NEAR(track.frames[1].time_s, 1.0 / 60, 1e-9);
  EXPECT_DOUBLE_EQ(track.frames[1].values[1], 0.4);
  EXPECT_FALSE(track.frames[2].found);
  EXPECT_FALSE(track.frames[3].found);
  EXPECT_EQ(track.notes.size(), 2U);
  EXPECT_EQ(read_arkit_track(bytes("a,b\n1,2\n")).error().place, "line 1");
  EXPECT_EQ(read_arkit_track(bytes("Timecode,JawOpen\n0:0:0:1,x\n")).error().place, "line 2");
  EXPECT_EQ(read_arkit_track(bytes("Timecode,JawOpen\n0:0:0:1,0,5\n")).error().place, "line 2");
}

TEST(ReadArkit, SaysWhichRateItTookWhereTheTimecodesDoNotTell) {
  std::string take = "Timecode,JawOpen\n";
  for (int f = 0; f < 10; ++f) take += "0:0:0:" + std::to_string(f) + ",0.5\n";
  const auto track = read_arkit_track(bytes(take)).value();
  EXPECT_NEAR(track.frames[9].time_s, 9 / 60.0, 1e-9);
  EXPECT_NE(track.rate_note.find("60.00 frames a second"), std::string::npos) << track.rate_note;
  EXPECT_NE(track.rate_note.find("--fps"), std::string::npos);
  const auto bare = read_arkit_track(bytes("Timecode,JawOpen\nx,0\ny,1\n")).value();
  EXPECT_NEAR(bare.frames[1].time_s, 1 / 60.0, 1e-9);
  EXPECT_NE(bare.rate_note.find("no timecode"), std::string::npos);
}

TEST(ReadArkit, HoldsRowsWhoseTimecodesRepeatOrStepBack) {
  const auto track = read_arkit_track(bytes("Timecode,JawOpen\n0:0:0:55,0\n0:0:0:56,0.1\n0:0:0:56,0.2\n0:0:0:58,0.3\n"
                                            "0:0:0:59,0.4\n0:0:0:12,0.5\n0:0:1:01,0.6\n?,0.7\n0:0:1:03,0.8\n"))
                         .value();
  for (std::size_t f = 0; f < 9; ++f) {
    EXPECT_NEAR(track.frames[f].time_s, static_cast<double>(f) / 60, 1e-9) << f;
    EXPECT_EQ(track.frames[f].found, f != 2 && f != 5) << f;
  }
  ASSERT_EQ(track.notes.size(), 3U);
  EXPECT_TRUE(track.notes[0].starts_with("line 9: its timecode cannot be read")) << track.notes[0];
  EXPECT_TRUE(track.notes[1].starts_with("line 4: its timecode does not come after"));
  EXPECT_TRUE(track.notes[2].starts_with("line 7: "));
  EXPECT_TRUE(track.rate_note.empty());
}

TEST(ReadArkit, OfColumnsOfOneNameTheFirstCounts) {
  const auto track = read_arkit_track(bytes("Timecode,JawOpen,jawopen,Other\n0:0:0:0,0.25,0.5,1\n")).value();
  EXPECT_EQ(track.names, (std::vector<std::string>{"JawOpen", "Other"}));
  EXPECT_EQ(track.frames[0].values, (std::vector<double>{0.25, 1}));
  ASSERT_EQ(track.notes.size(), 1U);
  EXPECT_TRUE(track.notes[0].starts_with("line 1: the column jawopen comes again")) << track.notes[0];
}

/// A take at 60 frames a second of the frames [first, end), frame numbers from 0.
std::string arkit_rows(int first, int end) {
  std::string rows;
  for (int f = first; f < end; ++f)
    rows += "0:0:" + std::to_string(f / 60) + ":" + std::to_string(f % 60) + ".5," + text_of(0.01 * f) + "\n";
  return rows;
}

TEST(ReadArkit, HoldsFramesThatAreLeftOut) {
  const auto track = read_arkit_track(bytes("Timecode,JawOpen\n" + arkit_rows(0, 21) + arkit_rows(51, 90))).value();
  ASSERT_EQ(track.frames.size(), 90U);
  for (std::size_t f = 0; f < 90; ++f) {
    EXPECT_EQ(track.frames[f].found, f < 21 || f >= 51) << f;
    EXPECT_NEAR(track.frames[f].time_s, static_cast<double>(f) / 60, 1e-9) << f;
  }
  EXPECT_NEAR(track.frames[51].values[0], 0.51, 1e-9);
  EXPECT_EQ(track.notes, (std::vector<std::string>{"line 23: 30 frames before it are left out and held"}));
}

TEST(ReadArkit, ARowThatIsLateLeavesNothingOut) {
  std::string take = "Timecode,JawOpen\n" + arkit_rows(0, 20) + "0:0:0:21.2,0.5\n" + arkit_rows(21, 70);
  const auto track = read_arkit_track(bytes(take)).value();
  EXPECT_EQ(track.frames.size(), 70U);
  EXPECT_TRUE(track.notes.empty());
}

TEST(ReadArkit, RowsWithoutACommonStepComeAsTheyPlease) {
  std::string take = "Timecode,JawOpen\n";
  for (int f = 0; f < 60; ++f)
    if (f % 3 != 2) take += arkit_rows(f, f + 1);
  EXPECT_EQ(read_arkit_track(bytes(take)).value().frames.size(), 40U);
  // 45 of 60 that are counted.
  take = "Timecode,JawOpen\n";
  for (int f = 0; f < 120; ++f)
    if (f % 4 != 3) take += arkit_rows(f, f + 1);
  EXPECT_EQ(read_arkit_track(bytes(take)).value().frames.size(), 90U);
}

TEST(ReadArkit, ATimecodeThatLeapsAwayIsNotGoneBy) {
  const auto track = read_arkit_track(bytes("Timecode,JawOpen\n" + arkit_rows(0, 90) + "9:0:0:0,0.5\n")).value();
  ASSERT_EQ(track.frames.size(), 91U);
  EXPECT_NEAR(track.frames[90].time_s, 1.5, 1e-6);
  EXPECT_TRUE(track.rate_note.starts_with("the timecode leaps by far in line 92: 60.00 frames")) << track.rate_note;
  // Timecodes that show no step cannot leap.
  const auto far = read_arkit_track(bytes("Timecode,JawOpen\n0:0:0:0,0\n?,0.1\n0:0:20:0,0.2\n")).value();
  ASSERT_EQ(far.frames.size(), 3U);
  EXPECT_NEAR(far.frames[1].time_s, 10, 1e-9);
}

/// Faces seen twice as often as the timecodes count.
TEST(ReadArkit, SpreadsRowsOverTimecodesThatStandStill) {
  std::string take = "Timecode,JawOpen\n";
  for (int f = 0; f < 90; ++f)
    take += "0:0:" + std::to_string(f / 60) + ":" + std::to_string(f % 60 / 2) + "," + std::to_string(f) + "\n";
  const auto track = read_arkit_track(bytes(take)).value();
  EXPECT_NEAR(track.frames[89].time_s, 89 / 60.0, 0.02);
  EXPECT_TRUE(track.frames[1].found);
  EXPECT_NE(track.rate_note.find("do not grow"), std::string::npos);
}

TEST(TrackFormat, IsToldByTheContent) {
  const auto told = [](const std::string& text) { return std::string(format_of_track(bytes(text))->name); };
  EXPECT_EQ(told(two_frames().text()), "openface");
  EXPECT_EQ(told(mediapipe_wide(468, true)), "mediapipe");
  EXPECT_EQ(told("frame,landmark,x,y\n"), "mediapipe");
  EXPECT_EQ(told("version: 1\nn_points: 68\n{\n"), "ibug68");
  EXPECT_EQ(told("1,2,3\n"), "ibug68");
  EXPECT_EQ(told(R"({"frames": [{"curves": {}}]})"), "curves");
  EXPECT_EQ(told("[[]]"), "mediapipe");
  EXPECT_EQ(told("Timecode,BlendShapeCount,JawOpen\n"), "arkit");
  EXPECT_EQ(format_of_track(bytes("hello, world\n")), nullptr);
}

}  // namespace
}  // namespace penpose::io
