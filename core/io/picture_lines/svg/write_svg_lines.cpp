#include "core/io/picture_lines/svg/write_svg_lines.h"

#include <algorithm>
#include <string_view>

#include "core/base/numbers.h"

namespace penpose::io {
namespace {

/// Width of the lines as a share of the drawing's longer side.
constexpr double k_width = 0.003;
constexpr int k_decimals = 3;

/// Names come from files: what steers a terminal or is no XML becomes _.
std::string attribute_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '_' : c;
    }
  }
  return out;
}

std::string path_data(const PictureLine& line) {
  std::string out;
  const std::size_t count = line.points.size() - (line.closed ? 1 : 0);
  for (std::size_t i = 0; i < count; ++i) {
    out += i == 0 ? "M" : " L";
    out += base::format_fixed(line.points[i].x, k_decimals) + ' ' + base::format_fixed(line.points[i].y, k_decimals);
  }
  return line.closed ? out + " Z" : out;
}

}  // namespace

std::string write_svg_lines(const PictureLines& drawing) {
  const std::string width = base::format_double(drawing.width);
  const std::string height = base::format_double(drawing.height);
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height +
                    "\" viewBox=\"0 0 " + width + ' ' + height +
                    "\">\n<g fill=\"none\" stroke=\"#000\" stroke-width=\"" +
                    base::format_fixed(k_width * std::max(drawing.width, drawing.height), k_decimals) +
                    "\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  for (const PictureLine& line : drawing.lines) {
    out += "<path";
    if (!line.name.empty()) out += " id=\"" + attribute_text(line.name) + '"';
    out += " d=\"" + path_data(line) + "\"/>\n";
  }
  return out + "</g>\n</svg>\n";
}

}  // namespace penpose::io
