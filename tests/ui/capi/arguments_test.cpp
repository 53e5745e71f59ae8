#include <functional>
#include <gtest/gtest.h>
#include <limits>

#include "core/base/text/utf8.h"
#include "tests/support/c_desk.h"

// Null pointers, counts that do not fit, numbers that are none: a status that says so, and nothing has changed.

namespace penpose::tests {
namespace {

constexpr double k_nan = std::numeric_limits<double>::quiet_NaN();
constexpr double k_inf = std::numeric_limits<double>::infinity();
constexpr std::size_t k_huge = std::numeric_limits<std::size_t>::max();

struct BadCall {
  const char* name;
  std::int32_t status;
  std::function<std::int32_t(CDesk&, penpose_error*)> call;
};

std::vector<BadCall> bad_calls() {
  static double numbers[675 + 3];
  static std::size_t count;
  static std::uint32_t curve;
  static penpose_handle handle;
  static const std::uint32_t vertices[] = {0, 1, 2};
  static const double nans[] = {k_nan, 1, 2, 3, 4, 5, 6, 7, 8};
  static const double far[] = {1, 2, k_inf, 3, 4, 5, 6, 7, 8};
  return {
      // Null pointers.
      {"penpose_open(nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk&, penpose_error* e) { return penpose_open(nullptr, e); }},
      {"penpose_handle_count(nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_handle_count(d.open, nullptr, e); }},
      {"penpose_handle_count(nullptr, &count)", PENPOSE_BAD_ARGUMENT,
       [](CDesk&, penpose_error* e) { return penpose_handle_count(nullptr, &count, e); }},
      {"penpose_character_read(nullptr, 5, nullptr, &handle)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_character_read(d.open, nullptr, 5, nullptr, &handle, e); }},
      {"penpose_character_read(glTF, 4, nullptr, nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_character_read(d.open, "glTF", 4, nullptr, nullptr, e); }},
      {"penpose_character_read(nullptr, glTF, 4, nullptr, &handle)", PENPOSE_BAD_ARGUMENT,
       [](CDesk&, penpose_error* e) { return penpose_character_read(nullptr, "glTF", 4, nullptr, &handle, e); }},
      {"penpose_character_built_in(nullptr, &handle)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_character_built_in(d.open, nullptr, &handle, e); }},
      {"penpose_character_from_arrays(nullptr, &handle)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_character_from_arrays(d.open, nullptr, &handle, e); }},
      {"penpose_character_from_arrays(&d.sheet_arrays.arrays, nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) {
         return penpose_character_from_arrays(d.open, &d.sheet_arrays.arrays, nullptr, e);
       }},
      {"penpose_character_copy(nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_character_copy(d.open, d.sheet, nullptr, e); }},
      {"penpose_character_copy(nullptr, d.sheet, &handle)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_character_copy(nullptr, d.sheet, &handle, e); }},
      {"penpose_count(nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_count(d.open, d.sheet, nullptr, e); }},
      {"penpose_triangles(nullptr, 1000)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_triangles(d.open, d.sheet, nullptr, 1000, e); }},
      {"penpose_state(nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_state(d.open, d.sheet, nullptr, e); }},
      {"penpose_write(nullptr, numbers, 9, &count)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_write(d.open, d.sheet, nullptr, numbers, 9, &count, e); }},
      {"penpose_write(.glb, nullptr, 9, &count)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_write(d.open, d.sheet, ".glb", nullptr, 9, &count, e); }},
      {"penpose_write(.glb, nullptr, 0, nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_write(d.open, d.sheet, ".glb", nullptr, 0, nullptr, e); }},
      {"penpose_parameter(0, nullptr, 9, nullptr, nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) {
         return penpose_parameter(d.open, d.sheet, 0, nullptr, 9, nullptr, nullptr, e);
       }},
      {"penpose_find_parameter(nullptr, &count)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_find_parameter(d.open, d.sheet, nullptr, &count, e); }},
      {"penpose_find_parameter(lift, nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_find_parameter(d.open, d.sheet, "lift", nullptr, e); }},
      {"penpose_get_pose(nullptr, 2)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_get_pose(d.open, d.sheet, nullptr, 2, e); }},
      {"penpose_set_pose(nullptr, 2)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_set_pose(d.open, d.sheet, nullptr, 2, e); }},
      {"penpose_set_parameter(nullptr, 0)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_set_parameter(d.open, d.sheet, nullptr, 0, e); }},
      {"penpose_lock(nullptr, 1)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_lock(d.open, d.sheet, nullptr, 1, e); }},
      {"penpose_evaluate(nullptr, 2, numbers, 225)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_evaluate(d.open, d.sheet, nullptr, 2, numbers, 225, e); }},
      {"penpose_evaluate(nullptr, 0, nullptr, 225)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_evaluate(d.open, d.sheet, nullptr, 0, nullptr, 225, e); }},
      {"penpose_evaluate_float(nullptr, 0, nullptr, 225)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_evaluate_float(d.open, d.sheet, nullptr, 0, nullptr, 225, e); }},
      {"penpose_view_of(0, 0, 10, 10, nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_view_of(d.open, d.sheet, 0, 0, 10, 10, nullptr, e); }},
      {"penpose_project(nullptr, numbers, 1, numbers)", PENPOSE_BAD_ARGUMENT,
       [](CDesk&, penpose_error* e) { return penpose_project(nullptr, numbers, 1, numbers, e); }},
      {"penpose_project(&d.view, nullptr, 1, numbers)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_project(&d.view, nullptr, 1, numbers, e); }},
      {"penpose_project(&d.view, numbers, 1, nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_project(&d.view, numbers, 1, nullptr, e); }},
      {"penpose_curve_from_vertices(nullptr, 3, 0, &curve)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) {
         return penpose_curve_from_vertices(d.open, d.sheet, nullptr, 3, 0, &curve, e);
       }},
      {"penpose_curve_from_vertices(vertices, 3, 0, nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) {
         return penpose_curve_from_vertices(d.open, d.sheet, vertices, 3, 0, nullptr, e);
       }},
      {"penpose_curve_from_points(nullptr, 3, 0, &curve)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_curve_from_points(d.open, d.sheet, nullptr, 3, 0, &curve, e); }},
      {"penpose_curve_from_stroke(nullptr, numbers, 3, 0, &curve)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) {
         return penpose_curve_from_stroke(d.open, d.sheet, nullptr, numbers, 3, 0, &curve, e);
       }},
      {"penpose_curve_from_stroke(&d.view, nullptr, 3, 0, &curve)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) {
         return penpose_curve_from_stroke(d.open, d.sheet, &d.view, nullptr, 3, 0, &curve, e);
       }},
      {"penpose_curve_named(nullptr, 0, &curve)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_curve_named(d.open, d.sheet, nullptr, 0, &curve, e); }},
      {"penpose_curve_points(1, nullptr, 5, &count)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_curve_points(d.open, d.sheet, 1, nullptr, 5, &count, e); }},
      {"penpose_curve_positions(1, numbers, 15, nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_curve_positions(d.open, d.sheet, 1, numbers, 15, nullptr, e); }},
      {"penpose_curve_positions(1, nullptr, 15, &count)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_curve_positions(d.open, d.sheet, 1, nullptr, 15, &count, e); }},
      {"penpose_curve_distances(1, nullptr, 15, &count)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_curve_distances(d.open, d.sheet, 1, nullptr, 15, &count, e); }},
      {"penpose_target_points(1, nullptr, 15)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_target_points(d.open, d.sheet, 1, nullptr, 15, e); }},
      {"penpose_target_stroke(1, nullptr, numbers, nullptr, 5)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) {
         return penpose_target_stroke(d.open, d.sheet, 1, nullptr, numbers, nullptr, 5, e);
       }},
      {"penpose_target_stroke(1, &d.view, nullptr, nullptr, 5)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) {
         return penpose_target_stroke(d.open, d.sheet, 1, &d.view, nullptr, nullptr, 5, e);
       }},
      {"penpose_solve(nullptr, d.sheet, 0)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_solve(nullptr, d.sheet, 0, e); }},
      {"penpose_live_begin(1, &d.view, nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_live_begin(d.open, d.sheet, 1, &d.view, nullptr, e); }},
      {"penpose_live_begin(1, nullptr, &handle)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_live_begin(d.open, d.sheet, 1, nullptr, &handle, e); }},
      {"penpose_sketch_deformer(nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_sketch_deformer(d.open, d.sheet, nullptr, e); }},
      {"penpose_perform(nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_perform(d.open, d.sheet, nullptr, e); }},
      {"penpose_session_play(nullptr, 7, 0, &handle, nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_session_play(d.open, nullptr, 7, 0, &handle, nullptr, e); }},
      {"penpose_session_play(, 0, 0, nullptr, nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_session_play(d.open, "", 0, 0, nullptr, nullptr, e); }},
      {"penpose_record(nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_record(d.open, d.sheet, nullptr, e); }},
      {"penpose_tablet(nullptr, &handle, nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_tablet(d.open, nullptr, &handle, nullptr, e); }},
      // Counts.
      {"penpose_triangles(&curve, 1)", PENPOSE_TOO_SMALL,
       [](CDesk& d, penpose_error* e) { return penpose_triangles(d.open, d.sheet, &curve, 1, e); }},
      {"penpose_write(.obj, numbers, 3, &count)", PENPOSE_TOO_SMALL,
       [](CDesk& d, penpose_error* e) { return penpose_write(d.open, d.sheet, ".obj", numbers, 3, &count, e); }},
      {"penpose_curve_positions(1, numbers, 3, &count)", PENPOSE_TOO_SMALL,
       [](CDesk& d, penpose_error* e) { return penpose_curve_positions(d.open, d.sheet, 1, numbers, 3, &count, e); }},
      {"penpose_curve_distances(1, numbers, 3, &count)", PENPOSE_TOO_SMALL,
       [](CDesk& d, penpose_error* e) { return penpose_curve_distances(d.open, d.sheet, 1, numbers, 3, &count, e); }},
      {"penpose_parameter(2, nullptr, 0, &count, nullptr)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) {
         return penpose_parameter(d.open, d.sheet, 2, nullptr, 0, &count, nullptr, e);
       }},
      {"penpose_get_pose(numbers, 3)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_get_pose(d.open, d.sheet, numbers, 3, e); }},
      {"penpose_set_pose(numbers, 1)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_set_pose(d.open, d.sheet, numbers, 1, e); }},
      {"penpose_evaluate(numbers, 3, numbers, 225)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_evaluate(d.open, d.sheet, numbers, 3, numbers, 225, e); }},
      {"penpose_evaluate(nullptr, 0, numbers, 224)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_evaluate(d.open, d.sheet, nullptr, 0, numbers, 224, e); }},
      {"penpose_evaluate(nullptr, 0, numbers, k_huge)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_evaluate(d.open, d.sheet, nullptr, 0, numbers, k_huge, e); }},
      {"penpose_curve_from_vertices(vertices, k_huge, 0, &curve)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) {
         return penpose_curve_from_vertices(d.open, d.sheet, vertices, k_huge, 0, &curve, e);
       }},
      {"penpose_curve_from_vertices(vertices, 0, 0, &curve)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) {
         return penpose_curve_from_vertices(d.open, d.sheet, vertices, 0, 0, &curve, e);
       }},
      {"penpose_curve_from_stroke(&d.view, numbers, k_huge / 2, 0, &curve)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) {
         return penpose_curve_from_stroke(d.open, d.sheet, &d.view, numbers, k_huge / 2, 0, &curve, e);
       }},
      {"penpose_curve_from_stroke(&d.view, numbers, 1, 0, &curve)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) {
         return penpose_curve_from_stroke(d.open, d.sheet, &d.view, numbers, 1, 0, &curve, e);
       }},
      {"penpose_target_points(1, numbers, 14)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_target_points(d.open, d.sheet, 1, numbers, 14, e); }},
      {"penpose_target_points(1, numbers, k_huge)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_target_points(d.open, d.sheet, 1, numbers, k_huge, e); }},
      {"penpose_character_read(glTF, k_huge, nullptr, &handle)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_character_read(d.open, "glTF", k_huge, nullptr, &handle, e); }},
      // Numbers that are none.
      {"penpose_set_parameter(lift, k_nan)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_set_parameter(d.open, d.sheet, "lift", k_nan, e); }},
      {"penpose_set_parameter(lift, 1.5)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_set_parameter(d.open, d.sheet, "lift", 1.5, e); }},
      {"penpose_set_pose(nans, 2)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_set_pose(d.open, d.sheet, nans, 2, e); }},
      {"penpose_evaluate(nans, 2, numbers, 225)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_evaluate(d.open, d.sheet, nans, 2, numbers, 225, e); }},
      {"penpose_curve_from_stroke(&d.view, nans, 4, 0, &curve)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) {
         return penpose_curve_from_stroke(d.open, d.sheet, &d.view, nans, 4, 0, &curve, e);
       }},
      {"penpose_curve_from_stroke(&d.view, far, 4, 0, &curve)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) {
         return penpose_curve_from_stroke(d.open, d.sheet, &d.view, far, 4, 0, &curve, e);
       }},
      {"penpose_target_stroke(1, &d.view, nans, nullptr, 4)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) {
         return penpose_target_stroke(d.open, d.sheet, 1, &d.view, nans, nullptr, 4, e);
       }},
      {"penpose_target_stroke(1, &d.view, numbers, nans, 4)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) {
         return penpose_target_stroke(d.open, d.sheet, 1, &d.view, numbers, nans, 4, e);
       }},
      {"penpose_view_of(k_nan, 0, 10, 10, &d.view)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_view_of(d.open, d.sheet, k_nan, 0, 10, 10, &d.view, e); }},
      {"penpose_view_of(0, 0, 0, 10, &d.view)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_view_of(d.open, d.sheet, 0, 0, 0, 10, &d.view, e); }},
      // What there is not.
      {"penpose_solve(3)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_solve(d.open, d.sheet, 3, e); }},
      {"penpose_solve(-1)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_solve(d.open, d.sheet, -1, e); }},
      {"penpose_lock(lift, 2)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_lock(d.open, d.sheet, "lift", 2, e); }},
      {"penpose_lock(nothing, 1)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_lock(d.open, d.sheet, "nothing", 1, e); }},
      {"penpose_curve_from_vertices(vertices, 3, 2, &curve)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) {
         return penpose_curve_from_vertices(d.open, d.sheet, vertices, 3, 2, &curve, e);
       }},
      {"penpose_write(.png, numbers, 9, &count)", PENPOSE_BAD_ARGUMENT,
       [](CDesk& d, penpose_error* e) { return penpose_write(d.open, d.sheet, ".png", numbers, 9, &count, e); }},
      {"penpose_find_parameter(nothing, &count)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_find_parameter(d.open, d.sheet, "nothing", &count, e); }},
      {"penpose_set_parameter(xff, 0)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_set_parameter(d.open, d.sheet, "\xff", 0, e); }},
      {"penpose_curve_named(nothing, 0, &curve)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_curve_named(d.open, d.sheet, "nothing", 0, &curve, e); }},
      {"penpose_curve_positions(9, numbers, 15, &count)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_curve_positions(d.open, d.sheet, 9, numbers, 15, &count, e); }},
      {"penpose_curve_distances(0, numbers, 15, &count)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_curve_distances(d.open, d.sheet, 0, numbers, 15, &count, e); }},
      {"penpose_curve_delete(9)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_curve_delete(d.open, d.sheet, 9, e); }},
      {"penpose_target_points(9, numbers, 15)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_target_points(d.open, d.sheet, 9, numbers, 15, e); }},
      {"penpose_live_begin(9, &d.view, &handle)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_live_begin(d.open, d.sheet, 9, &d.view, &handle, e); }},
      {"penpose_character_built_in(builtin:nobody, &handle)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_character_built_in(d.open, "builtin:nobody", &handle, e); }},
      {"penpose_character_read(not a model, 11, nullptr, &handle)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) {
         return penpose_character_read(d.open, "not a model", 11, nullptr, &handle, e);
       }},
      {"penpose_perform(make_coffee)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_perform(d.open, d.sheet, "make_coffee", e); }},
      {"penpose_perform(set_key time_s=nan)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_perform(d.open, d.sheet, "set_key time_s=nan", e); }},
      {"penpose_session_play(, 0, 0, &handle, nullptr)", PENPOSE_REFUSED,
       [](CDesk& d, penpose_error* e) { return penpose_session_play(d.open, "", 0, 0, &handle, nullptr, e); }},
      {"penpose_session_play(# penpose undon, 15, 5, &handle, nullptr)", PENPOSE_BAD_HANDLE,
       [](CDesk& d, penpose_error* e) {
         return penpose_session_play(d.open, "# penpose undo\n", 15, 5, &handle, nullptr, e);
       }},
  };
}

TEST(CArguments, ABadCallSaysSoAndChangesNothing) {
  CDesk desk;
  static_cast<void>(desk.place_lift(0.5));
  const std::string before = desk.state();
  for (const BadCall& bad : bad_calls()) {
    desk.error = {};
    EXPECT_EQ(bad.call(desk, &desk.error), bad.status) << bad.name << ": " << desk.error.message;
    EXPECT_EQ(desk.error.status, bad.status) << bad.name;
    EXPECT_STRNE(desk.error.message, "") << bad.name;
    EXPECT_EQ(std::string(desk.error.message).find('\n'), std::string::npos) << bad.name;
    EXPECT_EQ(bad.call(desk, nullptr), bad.status) << bad.name << ", with nowhere to say it";
    ASSERT_EQ(desk.state(), before) << bad.name;
  }
  std::size_t count = 0;
  EXPECT_EQ(penpose_handle_count(desk.open, &count, nullptr), PENPOSE_OK);
  EXPECT_EQ(count, 1U) << "nothing was made";
}

TEST(CArguments, ArraysThatAreNoCharacterAreRefused) {
  CDesk desk;
  penpose_handle made = 0;
  const auto refused = [&](const std::function<void(SheetArrays&)>& spoil, std::int32_t status, const char* said) {
    SheetArrays arrays;
    spoil(arrays);
    EXPECT_EQ(penpose_character_from_arrays(desk.open, &arrays.arrays, &made, &desk.error), status) << said;
    EXPECT_NE(std::string(desk.error.message).find(said), std::string::npos) << desk.error.message;
  };
  refused([](SheetArrays& a) { a.positions[7] = k_nan; }, PENPOSE_REFUSED, "vertex 2");
  refused([](SheetArrays& a) { a.triangles[4] = 9999; }, PENPOSE_REFUSED, "triangle 1");
  refused([](SheetArrays& a) { a.arrays.vertex_count = 0; }, PENPOSE_REFUSED, "vert");
  refused([](SheetArrays& a) { a.arrays.vertex_count = k_huge; }, PENPOSE_BAD_ARGUMENT, "vertex_count");
  refused([](SheetArrays& a) { a.arrays.triangle_count = k_huge; }, PENPOSE_BAD_ARGUMENT, "triangle_count");
  refused([](SheetArrays& a) { a.arrays.positions = nullptr; }, PENPOSE_BAD_ARGUMENT, "positions");
  refused([](SheetArrays& a) { a.arrays.shapes = nullptr; }, PENPOSE_BAD_ARGUMENT, "shapes");
  refused([](SheetArrays& a) { a.shapes[1].name = nullptr; }, PENPOSE_BAD_ARGUMENT, "name");
  refused([](SheetArrays& a) { a.shapes[1].name = "lift"; }, PENPOSE_REFUSED, "lift");
  refused([](SheetArrays& a) { a.shapes[1].minimum = k_nan; }, PENPOSE_BAD_ARGUMENT, "lean");
  refused([](SheetArrays& a) { a.shapes[0].vertices = nullptr; }, PENPOSE_BAD_ARGUMENT, "lift");
  refused([](SheetArrays& a) { a.vertices[0][0] = 9999; }, PENPOSE_REFUSED, "lift");
  refused([](SheetArrays& a) { a.deltas[0][0] = std::numeric_limits<float>::infinity(); }, PENPOSE_REFUSED, "lift");
  refused([](SheetArrays& a) { a.arrays.joint_count = 2; }, PENPOSE_BAD_ARGUMENT, "joints");
  EXPECT_EQ(made, 0U);
}

TEST(CArguments, ALongMessageIsCutBetweenCharacters) {
  CDesk desk;
  // A cut anywhere, also where it would go through a letter of two bytes.
  for (std::size_t letters = 220; letters < 300; ++letters) {
    std::string name(letters % 2, 'a');
    for (std::size_t i = 0; i < letters; ++i) name += "\xC3\xA4";
    std::size_t found = 0;
    EXPECT_EQ(penpose_find_parameter(desk.open, desk.sheet, name.c_str(), &found, &desk.error), PENPOSE_REFUSED);
    const std::string message = desk.error.message;
    EXPECT_LT(message.size(), sizeof desk.error.message);
    EXPECT_GT(message.size(), sizeof desk.error.message - 12) << letters;
    EXPECT_EQ(base::valid_utf8(message), message) << letters;
  }
}

}  // namespace
}  // namespace penpose::tests
