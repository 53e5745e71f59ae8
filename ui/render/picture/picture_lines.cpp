#include "ui/render/picture/picture_lines.h"

#include <algorithm>
#include <string_view>

#include "core/io/picture_lines/svg/read_svg_lines.h"
#include "core/io/picture_lines/trace/trace_lines.h"
#include "core/picture/decode_picture.h"
#include "core/picture/jpeg.h"
#include "ui/render/picture/image.h"

namespace penpose::render {
namespace {

constexpr int k_most_traced_px = 4096;  ///< a side
constexpr int k_largest_px = 16384;     ///< a side of what is made smaller first

base::Result<io::PictureLines> trace(const Image& picture) {
  const Image smaller = picture::shrunk(picture, k_most_traced_px);
  auto drawing = io::trace_lines({smaller.width, smaller.height, smaller.pixels});
  if (!drawing) return drawing;
  const int factor = (std::max(picture.width, picture.height) + k_most_traced_px - 1) / k_most_traced_px;
  for (io::PictureLine& line : drawing->lines) {
    for (geometry::PxPoint& p : line.points) p = p * factor;
  }
  drawing->width = picture.width;
  drawing->height = picture.height;
  return drawing;
}

}  // namespace

base::Result<io::PictureLines> read_picture_lines(base::Bytes bytes) {
  const std::string_view text = base::as_text(bytes);
  if (io::looks_like_svg(bytes) || text.starts_with("\x1f\x8b")) return io::read_svg_lines(bytes);
  if (!text.starts_with("\x89PNG") && !text.starts_with("\xff\xd8") && !text.starts_with("RIFF")) {
    return base::Error{"is no drawing that can be read", "", "choose an SVG, PNG, JPEG or WebP file"};
  }
  const auto picture = picture::decode_picture(bytes, k_largest_px);
  if (!picture) return picture.error();
  return trace(*picture);
}

}  // namespace penpose::render
