// What drivers of OpenGL ES 2.0 that are not Mesa's would make of the shaders, by the reference compiler of Khronos.

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>
#include <vector>

#include "ui/render/gl/gl_program.h"
#include "ui/render/gl/shaders.h"

namespace penpose::render {
namespace {

struct Shader {
  const char* name;
  bool fragment;
  std::string text;
};

std::vector<Shader> early_shaders() {
  const auto joined = [](std::string_view a, std::string_view b) { return std::string(a).append(b); };
  return {{"screen", false, std::string(k_screen_vertex)},
          {"copy", true, std::string(k_copy_fragment)},
          {"background", true, std::string(k_background_fragment)},
          {"mesh", false, joined(k_place_functions, k_mesh_vertex)},
          {"mesh", true, joined(k_lights, k_mesh_fragment)},
          {"wire", true, std::string(k_wire_fragment)},
          {"look", false, joined(k_place_functions, k_look_vertex)},
          {"look", true, joined(k_lights, k_look_fragment)}};
}

TEST(EarlyShaders, AreWhatTheReferenceCompilerTakes) {
  if (std::system("glslangValidator --version > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "install glslang-tools";
  }
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("penpose_shaders_" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  for (const bool embedded : {true, false}) {
    for (const bool derivatives : {true, false}) {
      GlDialect dialect;
      dialect.modern = false;
      dialect.embedded = embedded;
      dialect.derivatives = derivatives || !embedded;
      for (const Shader& one : early_shaders()) {
        const std::string path = (folder / (std::string(one.name) + (one.fragment ? ".frag" : ".vert"))).string();
        std::ofstream(path) << shader_source(dialect, one.fragment, one.text);
        EXPECT_EQ(std::system(("glslangValidator " + path + " > " + path + ".log").c_str()), 0)
            << one.name << (embedded ? " ES" : "");
      }
    }
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace penpose::render
