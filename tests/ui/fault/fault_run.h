#pragma once

#include <string>
#include <utility>

#include "tests/support/command_run.h"

namespace penpose::tests {

/// Commands with a small model: face.glb, a sheet of four triangles with one shape.
class FaultRun : public CommandRun {
 protected:
  /// `smile`: where the shape has the first and the fifth vertex.
  void save_face(const std::pair<std::string, std::string>& smile) {
    const auto sheet = [](const std::string& first, const std::string& fifth) {
      return first + "\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\n" + fifth + "\nv 2 1 0\nf 1 2 3\nf 1 3 4\nf 2 5 6\nf 2 6 3\n";
    };
    save("face.obj", sheet("v 0 0 0", "v 2 0 0.2"));
    save("smile.obj", sheet(smile.first, smile.second));
    ASSERT_EQ(run({"convert", path("face.obj"), "--shapes", path("smile.obj"), path("face.glb")}), 0) << error_;
  }
};

}  // namespace penpose::tests
