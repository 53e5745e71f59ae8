#include <gtest/gtest.h>

#include "tests/support/c_desk.h"
#include "tests/support/models/laughing_head.h"

namespace penpose::tests {
namespace {

/// Lines as a caller of C has them; valid as long as the lines.
std::vector<penpose_line> lines_in_c(const std::vector<std::vector<geometry::PxPoint>>& lines) {
  static_assert(sizeof(geometry::PxPoint) == 2 * sizeof(double));
  std::vector<penpose_line> out;
  for (const auto& line : lines) out.push_back({reinterpret_cast<const double*>(line.data()), line.size()});
  return out;
}

struct Face {
  CDesk desk;
  LaughingHead laugh;
  penpose_handle head = 0;
  penpose_view view{};

  Face() {
    EXPECT_EQ(penpose_character_built_in(desk.open, "builtin:demo", &head, &desk.error), PENPOSE_OK);
    EXPECT_EQ(penpose_view_of(desk.open, head, 0, 0, 1000, 1000, &view, &desk.error), PENPOSE_OK);
  }
};

TEST(CDrawings, EachLineIsTakenForACurveAndTheFaceIsPosed) {
  Face face;
  const auto lines = lines_in_c(face.laugh.lines);
  std::vector<penpose_line_read> read(2 * lines.size());
  ASSERT_EQ(penpose_draw_face(face.desk.open, face.head, &face.view, lines.data(), lines.size(), nullptr, 0,
                              read.data(), &face.desk.error),
            PENPOSE_OK)
      << face.desk.error.message;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    names.emplace_back(read[i].curve);
    EXPECT_LT(read[i].from, read[i].to);
    EXPECT_LE(read[i].to, 1);
  }
  EXPECT_GE(face.laugh.right(names), names.size() - 1);
  std::size_t jaw = 0;
  ASSERT_EQ(penpose_find_parameter(face.desk.open, face.head, "jaw", &jaw, nullptr), PENPOSE_OK);
  EXPECT_NEAR(face.desk.pose(face.head)[jaw], LaughingHead::k_jaw, 0.2);
  // The face at rest, by the same hand: nothing moves.
  const tests::LaughingHead still(0, false);
  const auto rest = lines_in_c(still.lines);
  ASSERT_EQ(penpose_draw_face(face.desk.open, face.head, &face.view, rest.data(), rest.size(), rest.data(), rest.size(),
                              read.data(), &face.desk.error),
            PENPOSE_OK)
      << face.desk.error.message;
  EXPECT_STRNE(read.back().curve, "") << "neutral lines are told of, too";
  EXPECT_EQ(face.desk.pose(face.head)[jaw], 0);
}

TEST(CDrawings, WhatDoesNotFitIsRefusedAndChangesNothing) {
  Face face;
  const auto lines = lines_in_c(face.laugh.lines);
  const std::string before = face.desk.state(face.head);
  const auto draws = [&](penpose_handle who, const penpose_line* given, std::size_t count,
                         const penpose_view* view = nullptr) {
    const std::int32_t status =
        penpose_draw_face(face.desk.open, who, view, given, count, nullptr, 0, nullptr, &face.desk.error);
    EXPECT_EQ(status == PENPOSE_OK, face.desk.error.message[0] == '\0');
    return status;
  };
  const double nothing[] = {1, 1, 1, 1};
  const penpose_line dot{nothing, 2}, none{nullptr, 0}, lost{nullptr, 3};
  const penpose_view nowhere{};
  EXPECT_EQ(draws(face.head, nullptr, 0), PENPOSE_REFUSED);
  EXPECT_EQ(draws(face.head, nullptr, 3), PENPOSE_BAD_ARGUMENT);
  EXPECT_EQ(draws(face.head, &dot, 1), PENPOSE_REFUSED);
  EXPECT_EQ(draws(face.head, &none, 1), PENPOSE_REFUSED);
  EXPECT_EQ(draws(face.head, &lost, 1), PENPOSE_BAD_ARGUMENT);
  EXPECT_EQ(draws(face.head, lines.data(), lines.size(), &nowhere), PENPOSE_REFUSED);
  EXPECT_EQ(draws(face.desk.sheet, lines.data(), lines.size()), PENPOSE_REFUSED) << "it has no face";
  EXPECT_EQ(draws(0, lines.data(), lines.size()), PENPOSE_BAD_HANDLE);
  EXPECT_EQ(face.desk.state(face.head), before);
}

}  // namespace
}  // namespace penpose::tests
