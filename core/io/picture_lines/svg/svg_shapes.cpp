#include "core/io/picture_lines/svg/internal/svg_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>

#include "core/base/text/shown_text.h"
#include "core/io/picture_lines/svg/internal/number_scanner.h"
#include "core/io/picture_lines/svg/internal/path_data.h"
#include "core/io/picture_lines/svg/internal/words.h"
#include "core/io/remedies.h"

namespace penpose::io {
namespace {

using geometry::PxPoint;

/// Draws the shape of one element from its attributes.
class ShapeDrawer {
 public:
  ShapeDrawer(const SvgAttributes& attributes, Viewport viewport, OutlinePen& pen)
      : attributes_(attributes), viewport_(viewport), pen_(pen) {}

  base::Status line() {
    std::array<double, 4> n{};
    if (auto status = lengths({{"x1", "y1", "x2", "y2"}}, n); !status) return status;
    pen_.move_to({n[0], n[1]});
    pen_.line_to({n[2], n[3]});
    return base::Done{};
  }

  base::Status points(bool closed) {
    NumberScanner scanner(attributes_("points"));
    bool first = true;
    for (scanner.skip_blanks(); !scanner.at_end(); scanner.skip_separator()) {
      const auto x = scanner.number();
      scanner.skip_separator();
      const auto y = x ? scanner.number() : std::nullopt;
      if (!y) {
        return base::Error{"a coordinate was expected", "character " + std::to_string(scanner.offset() + 1),
                           k_export_again};
      }
      first ? pen_.move_to({*x, *y}) : pen_.line_to({*x, *y});
      first = false;
      if (pen_.full() || pen_.too_far()) break;
    }
    if (closed) pen_.close();
    return base::Done{};
  }

  base::Status rectangle() {
    std::array<double, 4> n{};
    if (auto status = lengths({{"x", "y", "width", "height"}}, n); !status) return status;
    const auto given_x = svg_length(attributes_, "rx", viewport_.width, -1);
    if (!given_x) return given_x.error();
    const auto given_y = svg_length(attributes_, "ry", viewport_.height, -1);
    if (!given_y) return given_y.error();
    if (!(n[2] > 0 && n[3] > 0)) return base::Done{};
    // One radius stands for both (SVG 1.1, section 9.2).
    const double rx = std::clamp(*given_x >= 0 ? *given_x : *given_y, 0.0, n[2] / 2);
    const double ry = std::clamp(*given_y >= 0 ? *given_y : *given_x, 0.0, n[3] / 2);
    const double right = n[0] + n[2];
    const double bottom = n[1] + n[3];
    pen_.move_to({n[0] + rx, n[1]});
    pen_.line_to({right - rx, n[1]});
    const auto corner = [&](PxPoint p) { pen_.arc_to({rx, ry}, 0, false, true, p); };
    corner({right, n[1] + ry});
    pen_.line_to({right, bottom - ry});
    corner({right - rx, bottom});
    pen_.line_to({n[0] + rx, bottom});
    corner({n[0], bottom - ry});
    pen_.line_to({n[0], n[1] + ry});
    corner({n[0] + rx, n[1]});
    pen_.close();
    return base::Done{};
  }

  base::Status circle() {
    std::array<double, 2> n{};
    if (auto status = lengths({{"cx", "cy"}}, n); !status) return status;
    // What a percentage of a radius is of (SVG 1.1, section 7.10).
    const double whole = std::sqrt((viewport_.width * viewport_.width + viewport_.height * viewport_.height) / 2);
    const auto r = svg_length(attributes_, "r", whole, 0);
    if (!r) return r.error();
    oval({n[0], n[1]}, {*r, *r});
    return base::Done{};
  }

  base::Status ellipse() {
    std::array<double, 4> n{};
    if (auto status = lengths({{"cx", "cy", "rx", "ry"}}, n); !status) return status;
    oval({n[0], n[1]}, {n[2], n[3]});
    return base::Done{};
  }

 private:
  /// Lengths along x and y in turn, 0 where there is none.
  base::Status lengths(std::array<const char*, 4> names, std::span<double> values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto value = svg_length(attributes_, names[i], i % 2 == 0 ? viewport_.width : viewport_.height, 0);
      if (!value) return value.error();
      values[i] = *value;
    }
    return base::Done{};
  }

  void oval(PxPoint centre, PxPoint radii) {
    if (!(radii.x > 0 && radii.y > 0)) return;
    const PxPoint right = centre + PxPoint{radii.x, 0};
    const PxPoint left = centre - PxPoint{radii.x, 0};
    pen_.move_to(right);
    pen_.arc_to(radii, 0, false, true, left);
    pen_.arc_to(radii, 0, false, true, right);
    pen_.close();
  }

  const SvgAttributes& attributes_;
  Viewport viewport_;
  OutlinePen& pen_;
};

constexpr std::array<std::string_view, 7> k_shapes{"path", "line", "polyline", "polygon", "rect", "circle", "ellipse"};

}  // namespace

bool is_svg_shape(std::string_view tag) { return std::find(k_shapes.begin(), k_shapes.end(), tag) != k_shapes.end(); }

base::Status draw_shape(std::string_view tag, const SvgAttributes& attributes, Viewport viewport, OutlinePen& pen) {
  ShapeDrawer drawer(attributes, viewport, pen);
  if (tag == "path") {
    const std::string_view data = attributes("d");
    return svg_trimmed(data) == "none" ? base::Status(base::Done{}) : draw_path(data, pen);
  }
  if (tag == "line") return drawer.line();
  if (tag == "rect") return drawer.rectangle();
  if (tag == "circle") return drawer.circle();
  if (tag == "ellipse") return drawer.ellipse();
  return drawer.points(tag == "polygon");
}

base::Result<double> svg_length(const SvgAttributes& attributes, const char* name, double whole, double otherwise) {
  const std::string_view text = svg_trimmed(attributes(name));
  if (text.empty() || text == "auto") return otherwise;
  const auto value = parse_length(text, whole);
  if (!value) {
    return base::Error{std::string(name) + " is \"" + base::shown_name(text, 40) + "\", which is no length", "",
                       k_export_again};
  }
  return *value;
}

}  // namespace penpose::io
