#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/command_run.h"
#include "tests/support/shared_data.h"
#include "ui/cli/commands.h"

// A walking figure without any feature of a face, posed by its outline.

namespace penpose::cli {
namespace {

class SharedContours : public tests::CommandRun {
 protected:
  void SetUp() override {
    CommandRun::SetUp();
    if (!tests::has_shared()) GTEST_SKIP();
  }
};

TEST_F(SharedContours, AnArmIsRaisedByTheOutlineOfTheFigure) {
  const std::string model = (tests::shared_dir() / "meshes" / "cesium_man.glb").string();
  ASSERT_EQ(run({"render", model, "--set", "joint16.rx=-0.8", "--view", "side", "--lines", "-o", path("arm.svg")}), 0)
      << error_;
  ASSERT_EQ(run({"draw", model, path("arm.svg"), "--yaw", "90", "--json"}), 0) << error_;
  const auto out = nlohmann::json::parse(out_);
  EXPECT_NEAR(out["parameters"]["joint16.rx"].get<double>(), -0.8, 0.1);
  for (const auto& [name, value] : out["parameters"].items()) {
    if (!name.starts_with("joint16")) {
      EXPECT_EQ(value, 0.0) << name;
    }
  }
  EXPECT_EQ(out["lines"][0]["curve"], "silhouette");
}

}  // namespace
}  // namespace penpose::cli
