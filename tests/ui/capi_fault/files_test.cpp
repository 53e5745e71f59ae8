// Files of models while memory runs out at the n-th allocation, for every n: an error code, nothing made, nothing
// leaked.

#include <gtest/gtest.h>

#include "tests/support/gltf_sample.h"
#include "tests/ui/capi_fault/run_short.h"

namespace penpose::tests {
namespace {

/// What is read while memory runs out is nothing, or what is read without that.
void read_short(const char* name, const std::vector<std::uint8_t>& bytes, const char* hint) {
  CDesk desk;
  penpose_handle made = 0;
  ASSERT_EQ(penpose_character_read(desk.open, bytes.data(), bytes.size(), hint, &made, &desk.error), PENPOSE_OK)
      << name << ": " << desk.error.message;
  const std::string state = desk.state(made);
  ASSERT_EQ(penpose_free(desk.open, made, nullptr), PENPOSE_OK);
  made = 0;
  std::size_t handles = 0;
  ASSERT_EQ(penpose_handle_count(desk.open, &handles, nullptr), PENPOSE_OK);
  const auto read = [&](penpose_error* e) {
    return penpose_character_read(desk.open, bytes.data(), bytes.size(), hint, &made, e);
  };
  const auto nothing_made = [&] {
    std::size_t now = 0;
    EXPECT_EQ(penpose_handle_count(desk.open, &now, nullptr), PENPOSE_OK);
    EXPECT_EQ(now, handles);
    EXPECT_EQ(made, 0U);
  };
  const auto free_again = [&] {
    EXPECT_EQ(desk.state(made), state) << name << ": what did with less memory came to something else";
    EXPECT_EQ(penpose_free(desk.open, made, nullptr), PENPOSE_OK);
    made = 0;
  };
  EXPECT_GT(run_short(name, read, nothing_made, free_again), 20U) << name;
  if (made != 0) free_again();
}

/// A project with a reference, a sketched deformer and keys, so that all that is written is read.
void fill(CDesk& desk) {
  static_cast<void>(desk.place_lift(0.5));
  penpose_sketch sketch{};
  sketch.name = "up";
  sketch.view = desk.view;
  const auto around = desk.line(-0.8, 0.0, 0.8, 0.0);
  const auto feature = desk.line(-0.4, 0.0, 0.4, 0.0);
  const auto target = desk.line(-0.4, 0.3, 0.4, 0.3);
  sketch.general = around.data();
  sketch.general_count = around.size() / 2;
  sketch.specific = feature.data();
  sketch.specific_count = feature.size() / 2;
  sketch.target = target.data();
  sketch.target_count = target.size() / 2;
  sketch.maximum = 1;
  static_cast<void>(penpose_sketch_deformer(desk.open, desk.sheet, &sketch, &desk.error));
  for (const char* command : {"set_key time_s=0", "set_key time_s=1 name=later"}) {
    ASSERT_EQ(penpose_perform(desk.open, desk.sheet, command, &desk.error), PENPOSE_OK) << desk.error.message;
    ASSERT_EQ(penpose_set_parameter(desk.open, desk.sheet, "lean", 0.5, &desk.error), PENPOSE_OK);
  }
}

std::vector<std::uint8_t> written(CDesk& desk, const char* format) {
  std::size_t size = 0;
  static_cast<void>(penpose_write(desk.open, desk.sheet, format, nullptr, 0, &size, nullptr));
  std::vector<std::uint8_t> bytes(size);
  EXPECT_EQ(penpose_write(desk.open, desk.sheet, format, bytes.data(), size, &size, &desk.error), PENPOSE_OK)
      << desk.error.message;
  return bytes;
}

TEST(CFiles, AProjectIsReadOrNotReadWhenMemoryRunsOut) {
  CDesk desk;
  fill(desk);
  read_short("project", written(desk, ".glb"), nullptr);
}

TEST(CFiles, OtherModelsAreReadOrNotRead) {
  read_short("morph targets", morph_sample().glb(), nullptr);
  read_short("joints", skin_sample().glb(), nullptr);
  const std::string text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
  read_short("OBJ", {text.begin(), text.end()}, "square.obj");
}

TEST(CFiles, WhatIsNoModelIsOneOfTheTwo) {
  CDesk desk;
  GltfSample sample = skin_sample();
  sample.json["skins"][0]["joints"][1] = 77;
  sample.json["extras"] = {{"far", {{"down", {{"in", {1, 2, {3, {4, 5}}}}}}}}};
  const auto bytes = sample.glb();
  penpose_handle made = 0;
  for (std::size_t number = 1; number < 5000; ++number) {
    begin_faults({FaultPlan::Kind::memory, number, true});
    const auto status = penpose_character_read(desk.open, bytes.data(), bytes.size(), nullptr, &made, &desk.error);
    const std::size_t calls = end_faults();
    ASSERT_TRUE(status == PENPOSE_NO_MEMORY || status == PENPOSE_REFUSED) << number << ": " << desk.error.message;
    ASSERT_EQ(made, 0U);
    if (calls < number) {
      EXPECT_EQ(status, PENPOSE_REFUSED);
      return;
    }
  }
  ADD_FAILURE() << "memory without end";
}

TEST(CFiles, AFileIsWrittenOrNotWritten) {
  CDesk desk;
  fill(desk);
  const std::string before = desk.state();
  for (const char* format : {".glb", ".obj"}) {
    const auto whole = written(desk, format);
    std::vector<std::uint8_t> bytes(whole.size());
    std::size_t size = 0;
    const auto write = [&](penpose_error* e) {
      return penpose_write(desk.open, desk.sheet, format, bytes.data(), bytes.size(), &size, e);
    };
    const auto unchanged = [&] { EXPECT_EQ(desk.state(), before); };
    EXPECT_GT(run_short(format, write, unchanged, [&] { EXPECT_EQ(bytes, whole) << format; }), 5U) << format;
    EXPECT_EQ(bytes, whole);
  }
}

}  // namespace
}  // namespace penpose::tests
