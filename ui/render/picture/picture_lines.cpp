#include "ui/render/picture/picture_lines.h"

#include <algorithm>

#include "core/io/picture_lines/svg/read_svg_lines.h"
#include "core/io/picture_lines/trace/trace_lines.h"
#include "ui/render/picture/image.h"
#include "ui/render/picture/jpeg.h"

namespace penpose::render {
namespace {

constexpr int k_most_traced_px = 4096;  ///< a side

/// Lines of a picture that was made smaller, in px of the file. Precondition: whole numbers of them, but for the last.
void enlarge(io::PictureLines& drawing, double factor) {
  for (io::PictureLine& line : drawing.lines) {
    for (geometry::PxPoint& p : line.points) p = p * factor;
  }
}

base::Result<io::PictureLines> trace(const Image& picture) {
  const Image smaller = shrunk(picture, k_most_traced_px);
  auto drawing = io::trace_lines({smaller.width, smaller.height, smaller.pixels});
  if (!drawing) return drawing;
  const int factor = (std::max(picture.width, picture.height) + k_most_traced_px - 1) / k_most_traced_px;
  enlarge(*drawing, factor);
  drawing->width = picture.width;
  drawing->height = picture.height;
  return drawing;
}

}  // namespace

base::Result<io::PictureLines> read_picture_lines(base::Bytes bytes) {
  if (io::looks_like_svg(bytes) || base::as_text(bytes).starts_with("\x1f\x8b")) return io::read_svg_lines(bytes);
  const bool png = base::as_text(bytes).starts_with("\x89PNG");
  const bool jpeg = base::as_text(bytes).starts_with("\xff\xd8");
  if (!png && !jpeg) {
    return base::Error{"is no drawing that can be read", "", "choose an SVG, a PNG or a JPEG"};
  }
  const auto picture = png ? decode_png(bytes) : decode_jpeg(bytes);
  if (!picture) return picture.error();
  return trace(*picture);
}

}  // namespace penpose::render
