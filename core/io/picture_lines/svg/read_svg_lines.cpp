#include "core/io/picture_lines/svg/read_svg_lines.h"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <utility>

#include "core/io/picture_lines/svg/internal/filled_lines.h"
#include "core/io/picture_lines/svg/internal/outline_pen.h"
#include "core/io/picture_lines/svg/internal/svg_lengths.h"
#include "core/io/picture_lines/svg/internal/svg_shapes.h"
#include "core/io/picture_lines/svg/internal/svg_style.h"
#include "core/io/picture_lines/svg/internal/svg_tree.h"
#include "core/io/picture_lines/svg/internal/words.h"
#include "core/io/remedies.h"
#include "core/io/text/text_lines.h"

namespace penpose::io {
namespace {

constexpr std::size_t k_most_shapes = 100'000;
constexpr std::size_t k_most_points = 1'000'000;
constexpr int k_deepest = 100;
/// What may be looked at: `use` can name the same elements again and again.
constexpr std::uint64_t k_most_effort = std::uint64_t{1} << 30;
constexpr std::uint64_t k_effort_of_byte = 16;
constexpr std::uint64_t k_effort_of_px = 16;  ///< of a filled shape
constexpr double k_tolerance = 1e-4;          ///< of curves, in longer sides of the drawing
constexpr double k_svg_tolerance_px = 0.1;    ///< where the file does not say how large it is
constexpr double k_paper_margin = 0.005;      ///< in sides of the drawing

/// What an element has from those that it is in.
struct Surroundings {
  Affine to_px;
  Viewport viewport;
  SvgStyle style;
  int depth = 0;
};

class SvgReader {
 public:
  explicit SvgReader(SvgTree tree) : tree_(std::move(tree)) {}

  base::Result<PictureLines> read() {
    const pugi::xml_node root = tree_.root();
    const SvgAttributes attributes = attributes_of(root);
    Surroundings around;
    const auto width = svg_length(attributes, "width", 0, 0);
    if (!width) return tree_.error(root, width.error().what, width.error().remedy);
    const auto height = svg_length(attributes, "height", 0, 0);
    if (!height) return tree_.error(root, height.error().what, height.error().remedy);
    const auto box = view_box(root);
    if (!box) return box.error();
    if (*box) {
      around.viewport = (*box)->size;
      around.to_px = translation(-(*box)->x, -(*box)->y);
    } else {
      around.viewport = {*width, *height};
    }
    lines_.width = around.viewport.width;
    lines_.height = around.viewport.height;
    const double side = std::max(lines_.width, lines_.height);
    if (lines_.width > 0 && lines_.height > 0) tolerance_ = side * k_tolerance;
    if (auto status = read_element(root, around); !status) return status.error();
    if (!(lines_.width > 0 && lines_.height > 0)) measure();
    return std::move(lines_);
  }

 private:
  static SvgAttributes attributes_of(pugi::xml_node node) {
    return [node](const char* name) { return text_of(node, name); };
  }

  base::Result<std::optional<ViewBox>> view_box(pugi::xml_node node) const {
    const std::string_view text = text_of(node, "viewBox");
    if (text.empty()) return std::optional<ViewBox>();
    const auto box = parse_view_box(text);
    if (!box) return tree_.error(node, "its viewBox is not four numbers with an area", k_export_again);
    return std::optional(*box);
  }

  /// Adds what it takes to look at an element.
  base::Status charge(pugi::xml_node node) {
    effort_ += k_effort_of_byte;
    for (const pugi::xml_attribute one : node.attributes()) {
      effort_ += k_effort_of_byte * (std::string_view(one.name()).size() + std::string_view(one.value()).size());
    }
    effort_ += tree_.style_sheet().size() * (1 + text_of(node, "class").size());
    return effort_ <= k_most_effort ? base::Done{} : base::Status(too_much(node));
  }
  base::Error too_much(pugi::xml_node node) const {
    return tree_.error(node, "the drawing takes too long to look through",
                       "save its lines alone, and without elements that name others");
  }

  SvgStyle style_of(pugi::xml_node node, SvgStyle style) const {
    const auto text = attributes_of(node);
    SvgProperties given;
    for (const char* name : {"fill", "stroke", "fill-rule", "visibility", "display"}) given.set(name, text(name));
    style.take(given);
    tree_.style_sheet().apply(tree_.tag(node), text("id"), text("class"), style);
    SvgProperties own;
    own.set_all(text("style"));
    style.take(own);
    return style;
  }

  base::Status read_element(pugi::xml_node node, Surroundings around) {
    const std::string_view tag = tree_.tag(node);
    const bool shape = is_svg_shape(tag);
    const bool holds = tag == "g" || tag == "a" || tag == "switch" || tag == "svg";
    if (!shape && !holds && tag != "use") return base::Done{};
    if (auto status = charge(node); !status) return status;
    if (++around.depth > k_deepest) {
      return tree_.error(node, "more than 100 elements are inside each other, or one uses itself",
                         "ungroup the drawing");
    }
    around.style = style_of(node, around.style);
    if (!around.style.displayed) return base::Done{};
    const auto transform = parse_transform(text_of(node, "transform"));
    if (!transform) return tree_.error(node, "its transform is none that SVG knows", k_export_again);
    around.to_px = around.to_px * *transform;
    if (shape) return read_shape(node, around);
    if (tag == "use") return read_use(node, around);
    if (tag == "svg" && node != tree_.root()) return read_nested(node, node, around);
    return read_children(node, around, tag == "switch");
  }

  base::Status read_children(pugi::xml_node node, const Surroundings& around, bool first_alone) {
    for (const pugi::xml_node child : node.children()) {
      if (auto status = read_element(child, around); !status) return status;
      // What is for programs of another kind stands in front.
      if (first_alone && !tree_.tag(child).empty() && tree_.tag(child) != "foreignObject") break;
    }
    return base::Done{};
  }

  /// An svg or a symbol with a viewport of its own, whose size `sized` gives.
  base::Status read_nested(pugi::xml_node node, pugi::xml_node sized, Surroundings around) {
    const auto attributes = attributes_of(sized);
    const Viewport outer = around.viewport;
    const bool moves = sized == node;
    const auto x = moves ? svg_length(attributes, "x", outer.width, 0) : base::Result<double>(0.0);
    const auto y = moves ? svg_length(attributes, "y", outer.height, 0) : base::Result<double>(0.0);
    const auto width = svg_length(attributes, "width", outer.width, outer.width);
    const auto height = svg_length(attributes, "height", outer.height, outer.height);
    for (const auto* one : {&x, &y, &width, &height}) {
      if (!*one) return tree_.error(sized, one->error().what, one->error().remedy);
    }
    const auto box = view_box(node);
    if (!box) return box.error();
    around.to_px = around.to_px * translation(*x, *y);
    around.viewport = {*width, *height};
    if (*box) {
      around.to_px = around.to_px * fitted(**box, around.viewport, text_of(node, "preserveAspectRatio"));
      around.viewport = (*box)->size;
    }
    return read_children(node, around, false);
  }

  base::Status read_use(pugi::xml_node node, Surroundings around) {
    const pugi::xml_node target = tree_.target(node);
    if (!target) return base::Done{};
    const auto attributes = attributes_of(node);
    const auto x = svg_length(attributes, "x", around.viewport.width, 0);
    const auto y = svg_length(attributes, "y", around.viewport.height, 0);
    for (const auto* one : {&x, &y}) {
      if (!*one) return tree_.error(node, one->error().what, one->error().remedy);
    }
    around.to_px = around.to_px * translation(*x, *y);
    if (tree_.tag(target) != "symbol") return read_element(target, around);
    if (++around.depth > k_deepest) {
      return tree_.error(node, "a symbol uses itself", "ungroup the drawing");
    }
    around.style = style_of(target, around.style);
    return around.style.displayed ? read_nested(target, node, around) : base::Done{};
  }

  base::Status read_shape(pugi::xml_node node, const Surroundings& around) {
    const SvgStyle& style = around.style;
    if (!style.visible || (!style.filled && !style.stroked)) return base::Done{};
    if (shapes_ == k_most_shapes) {
      return tree_.error(node, "the drawing has more than 100000 shapes", "save its lines alone");
    }
    const std::size_t element = shapes_++;
    OutlinePen pen(around.to_px, tolerance_, k_most_points - points_);
    if (auto status = draw_shape(tree_.tag(node), attributes_of(node), around.viewport, pen); !status) {
      const base::Error& error = status.error();
      return tree_.error(node, error.place.empty() ? error.what : error.what + ", " + error.place, error.remedy);
    }
    if (pen.too_far()) return tree_.error(node, "a coordinate lies beyond a million", "scale the drawing down");
    if (pen.full()) return tree_.error(node, "the drawing has more than a million points", "simplify its paths");
    std::vector<Contour> contours = pen.take();
    if (!style.stroked) {
      if (is_paper(contours)) return base::Done{};
      const FilledShape filled{contours, style.even_odd};
      if (filled.is_line()) {
        effort_ += k_effort_of_px * filled.px();
        if (effort_ > k_most_effort) return too_much(node);
        if (auto middle = middle_lines(filled); !middle.empty()) contours = std::move(middle);
      }
    }
    for (Contour& one : contours) {
      points_ += one.points.size();
      lines_.lines.push_back({std::move(one.points), one.closed, element, std::string(text_of(node, "id"))});
    }
    return base::Done{};
  }

  /// Whether an outline reaches over the whole drawing.
  bool is_paper(const std::vector<Contour>& contours) const {
    if (contours.size() != 1 || !(lines_.width > 0 && lines_.height > 0)) return false;
    const auto& points = contours[0].points;
    const auto reaches = [&](double geometry::PxPoint::*axis, double side) {
      const auto [least, most] = std::minmax_element(points.begin(), points.end(),
                                                     [&](const auto& a, const auto& b) { return a.*axis < b.*axis; });
      return (*least).*axis <= k_paper_margin * side && (*most).*axis >= (1 - k_paper_margin) * side;
    };
    return reaches(&geometry::PxPoint::x, lines_.width) && reaches(&geometry::PxPoint::y, lines_.height);
  }

  /// Gives a drawing without a size that of its lines.
  void measure() {
    lines_.width = lines_.height = 0;
    for (const PictureLine& line : lines_.lines) {
      for (const geometry::PxPoint& p : line.points) {
        lines_.width = std::max(lines_.width, p.x);
        lines_.height = std::max(lines_.height, p.y);
      }
    }
  }

  SvgTree tree_;
  PictureLines lines_;
  double tolerance_ = k_svg_tolerance_px;
  std::size_t shapes_ = 0;
  std::size_t points_ = 0;
  std::uint64_t effort_ = 0;
};

}  // namespace

bool looks_like_svg(base::Bytes bytes) {
  // Comments and declarations come first; what follows the first tag says what it is.
  std::string_view text = first_text(bytes);
  while (text.starts_with("<?") || text.starts_with("<!")) {
    const bool comment = text.starts_with("<!--");
    const std::size_t end = text.find(comment ? "-->" : text.find('[') < text.find('>') ? "]>" : ">");
    if (end == std::string_view::npos) return false;
    text = svg_trimmed(text.substr(text.find('>', end) + 1));
  }
  if (!text.starts_with('<')) return false;
  const std::string_view name = text.substr(1, std::min<std::size_t>(text.find_first_of(" \t\r\n/>"), 40) - 1);
  return name == "svg" || name.ends_with(":svg");
}

base::Result<PictureLines> read_svg_lines(base::Bytes bytes) {
  auto tree = SvgTree::parse(bytes);
  if (!tree) return tree.error();
  return SvgReader(std::move(*tree)).read();
}

}  // namespace penpose::io
