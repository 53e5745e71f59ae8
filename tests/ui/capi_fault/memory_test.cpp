// Memory runs out at the n-th allocation of a call, for every n: the call says so, nothing has changed, and what was
// taken is given back (the sanitizer of addresses looks for leaks). Or the call has done without, as the library of C++
// sorts with less memory where it gets none, and then has done all of it.

#include <functional>
#include <gtest/gtest.h>
#include <set>
#include <tuple>

#include "tests/support/c_desk.h"
#include "tests/ui/fault/faults.h"

namespace penpose::tests {
namespace {

/// Calls until one is not short of memory, which must then have worked. Gives how often one failed. `undo` takes back
/// what a call did that did without.
std::size_t run_short(
    const char* name, const std::function<std::int32_t(penpose_error*)>& call, const std::function<void()>& check,
    const std::function<void()>& undo = [] {}) {
  // Every number up to here, then ever farther apart: an allocation deep in a loop is like the one before.
  constexpr std::size_t k_each = 400;
  std::size_t shorts = 0;
  for (std::size_t number = 1; number < 2'000'000; number += number < k_each ? 1 : number / 50) {
    // That one alone, and all from it on.
    for (const bool stays : {false, true}) {
      penpose_error error{};
      begin_faults({FaultPlan::Kind::memory, number, stays});
      const std::int32_t status = call(&error);
      const std::size_t calls = end_faults();
      if (calls < number) {
        EXPECT_EQ(status, PENPOSE_OK) << name << ": " << error.message;
        return shorts;
      }
      if (status == PENPOSE_OK) {
        undo();
        continue;
      }
      ++shorts;
      EXPECT_EQ(status, PENPOSE_NO_MEMORY) << name << ", allocation " << number << ": " << error.message;
      EXPECT_EQ(error.status, status);
      EXPECT_STRNE(error.message, "");
      check();
      if (testing::Test::HasFailure()) return shorts;
    }
  }
  ADD_FAILURE() << name << " takes memory without end";
  return shorts;
}

TEST(CMemory, ACallThatChangesTheCharacterChangesNothing) {
  CDesk desk;
  const std::uint32_t lift = desk.place_lift(0.6);
  const auto over = desk.line(-0.5, 0.5, 0.5, 0.5);
  const auto to = desk.line(-0.5, 0.6, 0.5, 0.6);
  const std::uint32_t drawn = desk.draw(over);
  ASSERT_EQ(penpose_record(desk.open, desk.sheet, "sheet", nullptr), PENPOSE_OK);
  const std::string before = desk.state();
  std::size_t recorded = 0;
  ASSERT_EQ(penpose_recorded(desk.open, desk.sheet, nullptr, 0, &recorded, nullptr), PENPOSE_OK);
  const std::vector<std::uint32_t> vertices{1, 2, 3};
  std::uint32_t curve = 77;
  const auto unchanged = [&] {
    EXPECT_EQ(desk.state(), before);
    EXPECT_EQ(curve, 77U);
    std::size_t now = 0;
    EXPECT_EQ(penpose_recorded(desk.open, desk.sheet, nullptr, 0, &now, nullptr), PENPOSE_OK);
    EXPECT_EQ(now, recorded) << "what did not happen is not recorded";
  };
  penpose_handle kept = 0;
  ASSERT_EQ(penpose_character_copy(desk.open, desk.sheet, &kept, nullptr), PENPOSE_OK);
  const auto begin_again = [&] {
    EXPECT_EQ(penpose_free(desk.open, desk.sheet, nullptr), PENPOSE_OK);
    EXPECT_EQ(penpose_character_copy(desk.open, kept, &desk.sheet, nullptr), PENPOSE_OK);
    EXPECT_EQ(penpose_record(desk.open, desk.sheet, "sheet", nullptr), PENPOSE_OK);
    EXPECT_EQ(penpose_recorded(desk.open, desk.sheet, nullptr, 0, &recorded, nullptr), PENPOSE_OK);
    curve = 77;
  };
  const std::vector<std::pair<const char*, std::function<std::int32_t(penpose_error*)>>> calls{
      {"solve", [&](penpose_error* e) { return penpose_solve(desk.open, desk.sheet, 0, e); }},
      {"solve exact", [&](penpose_error* e) { return penpose_solve(desk.open, desk.sheet, 1, e); }},
      {"solve paper", [&](penpose_error* e) { return penpose_solve(desk.open, desk.sheet, 2, e); }},
      {"target stroke",
       [&](penpose_error* e) {
         return penpose_target_stroke(desk.open, desk.sheet, drawn, &desk.view, to.data(), nullptr, to.size() / 2, e);
       }},
      {"curve from stroke",
       [&](penpose_error* e) {
         return penpose_curve_from_stroke(desk.open, desk.sheet, &desk.view, over.data(), over.size() / 2, 0, &curve,
                                          e);
       }},
      {"curve from vertices",
       [&](penpose_error* e) {
         return penpose_curve_from_vertices(desk.open, desk.sheet, vertices.data(), 3, 1, &curve, e);
       }},
      {"set", [&](penpose_error* e) { return penpose_set_parameter(desk.open, desk.sheet, "lean", 0.25, e); }},
      {"perform", [&](penpose_error* e) { return penpose_perform(desk.open, desk.sheet, "set_key time_s=1", e); }},
      {"delete", [&](penpose_error* e) { return penpose_curve_delete(desk.open, desk.sheet, lift, e); }}};
  for (const auto& [name, call] : calls) {
    begin_again();
    std::set<std::string> states;
    const auto coped = [&] {
      states.insert(desk.state());
      begin_again();
    };
    EXPECT_GT(run_short(name, call, unchanged, coped), 2U) << name;
    if (HasFailure()) return;
    // The call that had enough memory did what one that never was short does.
    const std::string after = desk.state();
    states.insert(after);
    EXPECT_EQ(states.size(), 1U) << name << ": what did with less memory came to something else";
    penpose_handle fresh = 0;
    ASSERT_EQ(penpose_character_copy(desk.open, kept, &fresh, nullptr), PENPOSE_OK);
    std::swap(fresh, desk.sheet);
    EXPECT_EQ(call(nullptr), PENPOSE_OK);
    EXPECT_EQ(desk.state(), after) << name;
    std::swap(fresh, desk.sheet);
    ASSERT_EQ(penpose_free(desk.open, fresh, nullptr), PENPOSE_OK);
  }
}

TEST(CMemory, ACallThatMakesSomethingMakesNothing) {
  CDesk desk;
  const std::uint32_t curve = desk.draw(desk.line(-0.5, 0.5, 0.5, 0.5));
  ASSERT_EQ(penpose_record(desk.open, desk.sheet, "sheet", nullptr), PENPOSE_OK);
  std::size_t size = 0;
  std::string session(4096, ' ');
  ASSERT_EQ(penpose_recorded(desk.open, desk.sheet, session.data(), session.size(), &size, nullptr), PENPOSE_OK);
  session.resize(size);
  penpose_handle made = 0;
  std::size_t handles = 0;
  ASSERT_EQ(penpose_handle_count(desk.open, &handles, nullptr), PENPOSE_OK);
  const auto nothing_made = [&] {
    std::size_t now = 0;
    EXPECT_EQ(penpose_handle_count(desk.open, &now, nullptr), PENPOSE_OK);
    EXPECT_EQ(now, handles);
    EXPECT_EQ(made, 0U);
  };
  const std::vector<std::pair<const char*, std::function<std::int32_t(penpose_error*)>>> calls{
      {"from arrays",
       [&](penpose_error* e) { return penpose_character_from_arrays(desk.open, &desk.sheet_arrays.arrays, &made, e); }},
      {"copy", [&](penpose_error* e) { return penpose_character_copy(desk.open, desk.sheet, &made, e); }},
      {"live",
       [&](penpose_error* e) { return penpose_live_begin(desk.open, desk.sheet, curve, &desk.view, &made, e); }},
      {"play", [&](penpose_error* e) {
         return penpose_session_play(desk.open, session.data(), session.size(), desk.sheet, &made, nullptr, e);
       }}};
  for (const auto& [name, call] : calls) {
    made = 0;
    const auto free_again = [&] {
      EXPECT_EQ(penpose_free(desk.open, made, nullptr), PENPOSE_OK) << name;
      made = 0;
    };
    EXPECT_GT(run_short(name, call, nothing_made, free_again), 0U) << name;
    if (HasFailure()) return;
    EXPECT_NE(made, 0U) << name;
    EXPECT_EQ(penpose_free(desk.open, made, nullptr), PENPOSE_OK);
  }
}

/// A curve with a target, a sketched control and a key: all that a project holds.
void fill(CDesk& desk) {
  static_cast<void>(desk.place_lift(0.5));
  const auto around = [&](double x, double y) {
    std::vector<double> px;
    for (const auto& side : {desk.line(-x, -y, x, -y), desk.line(x, -y, x, y), desk.line(x, y, -x, y)})
      px.insert(px.end(), side.begin(), side.end());
    return px;
  };
  const CSketch drawn{around(0.8, 0.5), around(0.4, 0.2), desk.line(-0.4, 0.0, 0.4, 0.0),
                      desk.line(-0.4, 0.3, 0.4, 0.3)};
  const penpose_sketch sketch = drawn.on(desk);
  EXPECT_EQ(penpose_sketch_deformer(desk.open, desk.sheet, &sketch, &desk.error), PENPOSE_OK) << desk.error.message;
  EXPECT_EQ(penpose_perform(desk.open, desk.sheet, "set_key time_s=1", nullptr), PENPOSE_OK);
}

/// The file of the sheet as it is.
std::vector<std::uint8_t> written(CDesk& desk, const char* format) {
  std::size_t size = 0;
  EXPECT_EQ(penpose_write(desk.open, desk.sheet, format, nullptr, 0, &size, nullptr), PENPOSE_OK);
  std::vector<std::uint8_t> file(size);
  EXPECT_EQ(penpose_write(desk.open, desk.sheet, format, file.data(), size, &size, nullptr), PENPOSE_OK);
  return file;
}

TEST(CMemory, AFileThatIsReadMakesNothing) {
  CDesk desk;
  fill(desk);
  const std::string state = desk.state();
  const auto project = written(desk, ".glb");
  const auto mesh = written(desk, ".obj");
  // The same as text with its bytes in it, and with what is no more than an extra.
  const std::string text = R"({"asset":{"version":"2.0"},"extras":{"a":[{"b":[1,2,{"c":"d"}]}]},
    "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}],
    "bufferViews":[{"buffer":0,"byteLength":36}],
    "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0,"extras":{"e":[[],{}]}}],"scenes":[{"nodes":[0]}]})";
  const std::vector<std::uint8_t> gltf(text.begin(), text.end());
  std::size_t handles = 0;
  ASSERT_EQ(penpose_handle_count(desk.open, &handles, nullptr), PENPOSE_OK);
  for (const auto& [name, file, hint] :
       {std::tuple{"project", project, "a.glb"}, {"mesh", mesh, "a.obj"}, {"text", gltf, "a.gltf"}}) {
    penpose_handle made = 0;
    std::string read_state;
    const auto call = [&](penpose_error* e) {
      return penpose_character_read(desk.open, file.data(), file.size(), hint, &made, e);
    };
    const auto nothing_made = [&] {
      std::size_t now = 0;
      EXPECT_EQ(penpose_handle_count(desk.open, &now, nullptr), PENPOSE_OK);
      EXPECT_EQ(now, handles);
      EXPECT_EQ(made, 0U);
    };
    const auto free_again = [&] {
      EXPECT_EQ(penpose_free(desk.open, made, nullptr), PENPOSE_OK) << name;
      made = 0;
    };
    EXPECT_GT(run_short(name, call, nothing_made, free_again), 50U) << name;
    if (HasFailure()) return;
    char now[33];
    EXPECT_EQ(penpose_state(desk.open, made, now, nullptr), PENPOSE_OK);
    if (file == project) {
      EXPECT_EQ(now, state) << "what was read in the end is what was written";
    }
    free_again();
  }
}

TEST(CMemory, AFileThatIsWrittenChangesNothing) {
  CDesk desk;
  fill(desk);
  const std::string before = desk.state();
  for (const char* format : {".glb", ".obj"}) {
    const auto whole = written(desk, format);
    std::vector<std::uint8_t> file(whole.size());
    std::size_t size = 77;
    const auto call = [&](penpose_error* e) {
      return penpose_write(desk.open, desk.sheet, format, file.data(), file.size(), &size, e);
    };
    const auto unchanged = [&] {
      EXPECT_EQ(desk.state(), before);
      EXPECT_EQ(size, 77U);
      EXPECT_EQ(file, std::vector<std::uint8_t>(whole.size()));
    };
    const auto begin_again = [&] {
      EXPECT_EQ(file, whole);
      file.assign(whole.size(), 0);
      size = 77;
    };
    EXPECT_GT(run_short(format, call, unchanged, begin_again), 10U) << format;
    EXPECT_EQ(file, whole) << format;
  }
}

TEST(CMemory, TheBuiltInHeadIsMadeOrIsNot) {
  CDesk desk;
  std::size_t handles = 0;
  ASSERT_EQ(penpose_handle_count(desk.open, &handles, nullptr), PENPOSE_OK);
  penpose_handle made = 0;
  const auto call = [&](penpose_error* e) { return penpose_character_built_in(desk.open, "builtin:head", &made, e); };
  // Each takes a while, so these places alone.
  for (const std::size_t number : {1U, 2U, 3U, 10U, 100U, 1000U, 10000U}) {
    begin_faults({FaultPlan::Kind::memory, number, true});
    const std::int32_t status = call(nullptr);
    const std::size_t calls = end_faults();
    EXPECT_GE(calls, number) << "the head takes less memory than that: choose places that it comes to";
    EXPECT_EQ(status, PENPOSE_NO_MEMORY) << number;
    std::size_t now = 0;
    EXPECT_EQ(penpose_handle_count(desk.open, &now, nullptr), PENPOSE_OK);
    EXPECT_EQ(now, handles);
  }
}

TEST(CMemory, ACallThatAsksGivesNoAnswer) {
  CDesk desk;
  static_cast<void>(desk.place_lift(0.5));
  const std::string before = desk.state();
  double numbers[675];
  float floats[675];
  char state[33] = "untouched";
  std::size_t count = 0;
  const auto unchanged = [&] { EXPECT_EQ(desk.state(), before); };
  static_cast<void>(run_short(
      "evaluate",
      [&](penpose_error* e) { return penpose_evaluate(desk.open, desk.sheet, nullptr, 0, numbers, 225, e); },
      unchanged));
  static_cast<void>(run_short(
      "floats",
      [&](penpose_error* e) { return penpose_evaluate_float(desk.open, desk.sheet, nullptr, 0, floats, 225, e); },
      unchanged));
  static_cast<void>(run_short(
      "state", [&](penpose_error* e) { return penpose_state(desk.open, desk.sheet, state, e); }, unchanged));
  EXPECT_EQ(state, before);
  static_cast<void>(run_short(
      "distances",
      [&](penpose_error* e) { return penpose_curve_distances(desk.open, desk.sheet, 1, numbers, 15, &count, e); },
      unchanged));
  penpose_library* library = nullptr;
  EXPECT_EQ(
      run_short(
          "open", [&](penpose_error* e) { return penpose_open(&library, e); }, [&] { EXPECT_EQ(library, nullptr); }),
      2U);
  penpose_close(&library);
}

}  // namespace
}  // namespace penpose::tests
