#include "ui/cli/pose/drawing_files.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "core/base/text/letters.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/folder_files.h"
#include "ui/render/picture/picture_lines.h"

namespace penpose::cli {
namespace {

bool is_drawing(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 5> k_kinds{".svg", ".png", ".jpg", ".jpeg", ".webp"};
  // What file managers leave beside a file is none.
  if (file.filename().string().starts_with('.')) return false;
  const std::string kind = base::lower_case(file.extension().string());
  return std::find(k_kinds.begin(), k_kinds.end(), kind) != k_kinds.end();
}

}  // namespace

base::Result<std::vector<std::string>> drawing_files(const std::vector<std::string>& named, const std::string& neutral,
                                                     std::string& blamed) {
  std::vector<std::string> files;
  for (const std::string& path : named) {
    blamed = path;
    auto inside = files::folder_files(path, [&](const std::filesystem::path& file) {
      return is_drawing(file) && (neutral.empty() || !files::same_file(file.string(), neutral));
    });
    if (!inside) return inside.error();
    if (!*inside) {
      files.push_back(path);
      continue;
    }
    if ((*inside)->empty()) {
      return base::Error{"has no drawing", "", "name a folder of .svg, .png, .jpg or .webp files"};
    }
    files.insert(files.end(), (*inside)->begin(), (*inside)->end());
  }
  return files;
}

base::Result<io::PictureLines> read_drawing_file(const std::string& path) {
  const auto bytes = files::read_file(path);
  if (!bytes) return bytes.error();
  auto read = render::read_picture_lines(*bytes);
  if (!read) return read.error();
  if (read->lines.empty())
    return base::Error{"it has no lines", "", "draw the features of the face or contours as open lines"};
  return read;
}

base::Result<std::vector<io::VertexCurve>> read_curves_file(const std::string& path) {
  if (path.empty()) return std::vector<io::VertexCurve>{};
  const auto bytes = files::read_file(path);
  if (!bytes) return bytes.error();
  auto named = io::read_landmarks(*bytes);
  if (named && named->empty()) return base::Error{"it names no curves", "/curves", "name the features of the face"};
  return named;
}

}  // namespace penpose::cli
