#include <fstream>
#include <gtest/gtest.h>
#include <iterator>

#include "core/io/gltf/read/read_gltf.h"
#include "tests/support/shared_data.h"

namespace penpose::io {
namespace {

/// Avatars that people had trouble with.
class SharedAvatars : public testing::Test {
 protected:
  void SetUp() override {
    if (!tests::has_shared() || !std::filesystem::exists(tests::shared_dir() / "cases" / "rigs")) GTEST_SKIP();
  }
  static document::Model read(const char* folder, const char* name) {
    std::ifstream file(tests::shared_dir() / "cases" / "rigs" / folder / name, std::ios::binary);
    const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
    return read_gltf(bytes).value();
  }
  static std::vector<std::string> names(const document::Model& model) {
    std::vector<std::string> all;
    for (const rig::Parameter& parameter : model.rig->parameters()) all.push_back(parameter.name);
    return all;
  }
};

TEST_F(SharedAvatars, NamesOfTargetsStandInPrimitives) {
  EXPECT_EQ(names(read("primitive_target_names", "prims_prim_extras.glb")), (std::vector<std::string>{"up", "side"}));
}

TEST_F(SharedAvatars, AnExpressionIsNoSecondControl) {
  const auto model = read("vrm_expression_twice", "vrm.glb");
  EXPECT_EQ(names(model), std::vector<std::string>{"Fcl_EYE_Close"});
  ASSERT_EQ(model.expressions.size(), 1U);
  EXPECT_EQ(model.expressions[0].name, "Blink");
  EXPECT_EQ(model.expressions[0].values, (std::vector<std::pair<std::size_t, double>>{{0, 1.0}}));
}

TEST_F(SharedAvatars, Vrm0LooksAlongMinusZ) {
  EXPECT_EQ(read("vrm0_seen_from_behind", "vrm0.glb").front_yaw_degrees, 180);
}

}  // namespace
}  // namespace penpose::io
