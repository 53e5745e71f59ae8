#include "tests/judges/drawing/faces/shared_drawings.h"

#include <algorithm>

#include "core/io/picture_lines/svg/read_svg_lines.h"
#include "tests/support/shared_data.h"

namespace penpose::judges::drawn {

std::optional<SharedDrawing> meaning_of(const std::string& file_name) {
  SharedDrawing out;
  out.name = std::filesystem::path(file_name).stem().string();
  bool known = false;
  for (std::size_t at = 0; at <= out.name.size();) {
    const std::size_t end = std::min(out.name.find('_', at), out.name.size());
    const std::string word = out.name.substr(at, end - at);
    if (at == 0) out.folder = word;
    if (word == "not") out.face = false, known = true;
    if (word == "L" || word == "R") out.side = word == "L" ? Side::left : Side::right;
    if (const auto expression = expression_named(word == "neutral" ? "rest" : word == "o" ? "open" : word)) {
      out.meant = *expression;
      known = true;
    }
    at = end + 1;
  }
  if (!known) return std::nullopt;
  return out;
}

base::Result<std::vector<SharedDrawing>> shared_drawings(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, ignored)) {
    if (entry.path().extension() == ".svg") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  std::vector<SharedDrawing> out;
  for (const auto& file : files) {
    auto drawing = meaning_of(file.filename().string());
    if (!drawing) continue;
    const auto lines = io::read_svg_lines(tests::read_file(file));
    if (!lines)
      return base::Error{lines.error().what, file.string() + ": " + lines.error().place, lines.error().remedy};
    for (const io::PictureLine& line : lines->lines) drawing->drawing.lines.push_back(line.points);
    out.push_back(std::move(*drawing));
  }
  return out;
}

}  // namespace penpose::judges::drawn
