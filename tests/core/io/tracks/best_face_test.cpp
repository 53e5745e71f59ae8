#include "core/io/tracks/best_face.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace penpose::io {
namespace {

/// Rows on lines 2, 3, ... of one point whose x is the face's number.
class Rows {
 public:
  void add(std::int64_t face, int frame, double confidence = 0.9) {
    FaceRow row;
    row.face = face;
    row.row.line = rows.size() + 2;
    row.row.frame = frame;
    row.row.time_s = 0.04 * frame;
    row.row.confidence = confidence;
    if (confidence > 0) row.row.points = {{static_cast<double>(face), 0}};
    if (!(confidence > 0)) row.row.why_held = "no face";
    rows.push_back(row);
  }
  void add_all(std::int64_t face, int first, int end, double confidence = 0.9) {
    for (int frame = first; frame < end; ++frame) add(face, frame, confidence);
  }
  std::vector<FaceRow> rows;
};

/// The face of each frame, -1 where it is held; asserts that no frame is left out.
std::vector<int> faces(const std::vector<TrackRow>& rows) {
  std::vector<int> result;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(*rows[i].frame, static_cast<std::int64_t>(i)) << i;
    EXPECT_EQ(rows[i].points.empty(), !rows[i].why_held.empty()) << i;
    result.push_back(rows[i].points.empty() ? -1 : static_cast<int>(rows[i].points[0].x));
  }
  return result;
}

TEST(BestFace, IdsThatAreNeverSeenTogetherAreOneFace) {
  Rows table;
  table.add_all(0, 0, 150);
  table.add_all(1, 150, 300);
  std::vector<std::string> notes;
  const auto seen = faces(rows_of_best_face(table.rows, notes));
  ASSERT_EQ(seen.size(), 300U);
  EXPECT_EQ(std::count(seen.begin(), seen.begin() + 150, 0), 150);
  EXPECT_EQ(std::count(seen.begin() + 150, seen.end(), 1), 150);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0],
            "line 152: face 1 is never seen together with face 0; it is read as the same face, lost and found");
}

TEST(BestFace, TheFirstFramesOfAnotherIdAreKept) {
  for (const bool by_face : {false, true}) {
    Rows table;
    if (by_face) table.add_all(0, 100, 300);
    table.add_all(1, 0, 100);
    if (!by_face) table.add_all(0, 100, 300);
    std::vector<std::string> notes;
    const auto rows = rows_of_best_face(table.rows, notes);
    ASSERT_EQ(faces(rows).size(), 300U) << by_face;
    EXPECT_EQ(faces(rows)[99], 1);
    EXPECT_EQ(faces(rows)[100], 0);
    EXPECT_DOUBLE_EQ(*rows[150].time_s, 6.0);
  }
}

TEST(BestFace, FramesOfAnotherFaceAloneAreHeld) {
  Rows table;
  for (int frame = 0; frame < 6; ++frame) {
    table.add(7, frame, 0.4);
    if (frame >= 2) table.add(8, frame, 0.9);
  }
  table.add(7, 6, 0.4);
  std::vector<std::string> notes;
  const auto rows = rows_of_best_face(table.rows, notes);
  EXPECT_EQ(faces(rows), (std::vector<int>{-1, -1, 8, 8, 8, 8, -1}));
  EXPECT_EQ(rows[6].line, 12U);
  EXPECT_EQ(rows[6].why_held, "only face 7 is seen, not the one that is read");
  EXPECT_EQ(notes, (std::vector<std::string>{"of 2 faces, face 8 is seen best and is read"}));
}

TEST(BestFace, AFaceIsJoinedWhileAnotherStaysApart) {
  Rows table;
  for (int frame = 0; frame < 8; ++frame) {
    table.add(frame < 4 ? 0 : 2, frame, 0.9);
    table.add(1, frame, 0.3);
  }
  std::vector<std::string> notes;
  EXPECT_EQ(faces(rows_of_best_face(table.rows, notes)), (std::vector<int>{0, 0, 0, 0, 2, 2, 2, 2}));
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0], "of 3 faces, face 0 is seen best and is read");
  EXPECT_TRUE(notes[1].starts_with("line 10: face 2 is never seen together")) << notes[1];
}

/// A tracker may go on with rows of a face that it has lost.
TEST(BestFace, RowsOfALostFaceGiveWayToThoseOfTheFound) {
  Rows table;
  for (int frame = 0; frame < 6; ++frame) {
    table.add(0, frame, frame < 3 ? 0.9 : 0);
    if (frame >= 4) table.add(1, frame, 0.9);
  }
  std::vector<std::string> notes;
  EXPECT_EQ(faces(rows_of_best_face(table.rows, notes)), (std::vector<int>{0, 0, 0, -1, 1, 1}));
}

TEST(BestFace, WithoutNumbersOrTimesTheBestIsReadAlone) {
  Rows table;
  table.add_all(0, 0, 3);
  table.add_all(1, 3, 5);
  for (FaceRow& row : table.rows) {
    row.row.frame = 0;
    row.row.time_s.reset();
  }
  std::vector<std::string> notes;
  EXPECT_EQ(rows_of_best_face(table.rows, notes).size(), 3U);
  EXPECT_EQ(notes, (std::vector<std::string>{"of 2 faces, face 0 is seen best and is read"}));
  EXPECT_TRUE(rows_of_best_face({}, notes).empty());
}

TEST(BestFace, ManyFacesAreNotedInFewLines) {
  Rows table;
  for (int frame = 0; frame < 30; ++frame) table.add(frame, frame);
  std::vector<std::string> notes;
  EXPECT_EQ(faces(rows_of_best_face(table.rows, notes)).size(), 30U);
  ASSERT_EQ(notes.size(), 6U);
  EXPECT_EQ(notes.back(), "and 24 faces more like these");
}

}  // namespace
}  // namespace penpose::io
