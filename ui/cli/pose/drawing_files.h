#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/picture_lines/picture_lines.h"
#include "core/io/project/landmark_file.h"

namespace penpose::cli {

/// The drawings that a user names: each file as it is, a folder's (SVG, PNG, JPEG, WebP) in the order of their names,
/// numbers as numbers, without `neutral`, which may lie among them. An error is that of the folder `blamed`.
[[nodiscard]] base::Result<std::vector<std::string>> drawing_files(const std::vector<std::string>& named,
                                                                   const std::string& neutral, std::string& blamed);

/// The lines of a drawing. Errors of the file and of its reader; it has none.
[[nodiscard]] base::Result<io::PictureLines> read_drawing_file(const std::string& path);

/// The curves of a file that --curves names; none where the path is empty. Errors of the file and of its reader; it
/// names no curve.
[[nodiscard]] base::Result<std::vector<io::VertexCurve>> read_curves_file(const std::string& path);

}  // namespace penpose::cli
