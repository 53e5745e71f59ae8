#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/portrait/read_drawing.h"
#include "tests/judges/drawing/signs/expression.h"

namespace penpose::judges::drawn {

/// A drawing of a folder and what its name says of it: HAND_WORD[_SIDE].svg.
struct SharedDrawing {
  std::string name, folder;
  bool face = true;  ///< false: it shows something else
  Expression meant = Expression::rest;
  std::optional<Side> side;
  portrait::Drawing drawing;
};

/// What a file's name says; none where it names no expression.
[[nodiscard]] std::optional<SharedDrawing> meaning_of(const std::string& file_name);
/// All drawings below a folder, in the order of their names; empty where there is no such folder. Errors of the files.
[[nodiscard]] base::Result<std::vector<SharedDrawing>> shared_drawings(const std::filesystem::path& folder);

}  // namespace penpose::judges::drawn
