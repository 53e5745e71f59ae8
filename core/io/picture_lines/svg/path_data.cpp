#include "core/io/picture_lines/svg/internal/path_data.h"

#include <optional>
#include <string>

#include "core/base/text/letters.h"
#include "core/io/picture_lines/svg/internal/number_scanner.h"
#include "core/io/remedies.h"

namespace penpose::io {
namespace {

class PathDrawer {
 public:
  using Point = geometry::PxPoint;

  PathDrawer(std::string_view data, OutlinePen& pen) : scanner_(data), pen_(pen) {}

  base::Status draw() {
    scanner_.skip_blanks();
    bool first = true;
    while (!scanner_.at_end()) {
      const char command = scanner_.peek();
      if (first && base::lower(command) != 'm') return wrong("a path begins with M or m");
      first = false;
      if (std::string_view("MmLlHhVvCcSsQqTtAaZz").find(command) == std::string_view::npos) {
        return wrong("there is no such command of a path");
      }
      scanner_.take(command);
      if (!draw_all(command)) return wrong("a number of the path was expected");
      if (pen_.full() || pen_.too_far()) return base::Done{};
    }
    return base::Done{};
  }

 private:
  base::Error wrong(const char* what) const {
    return {what, "character " + std::to_string(scanner_.offset() + 1), k_export_again};
  }

  /// One command with all its repeats.
  bool draw_all(char command) {
    relative_ = command >= 'a';
    char kind = base::lower(command);
    if (kind == 'z') {
      pen_.close();
      forget_handles();
      scanner_.skip_blanks();
      return true;
    }
    do {
      if (!draw_one(kind)) return false;
      if (kind == 'm') kind = 'l';
      scanner_.skip_separator();
    } while (scanner_.before_number() && !pen_.full() && !pen_.too_far());
    return true;
  }

  bool draw_one(char kind) {
    if (kind == 'm' || kind == 'l') return draw_line(kind);
    if (kind == 'h' || kind == 'v') return draw_level(kind);
    if (kind == 'c' || kind == 's') return draw_cubic(kind);
    if (kind == 'q' || kind == 't') return draw_quadratic(kind);
    return draw_arc();
  }

  bool draw_line(char kind) {
    const auto p = point();
    if (!p) return false;
    kind == 'm' ? pen_.move_to(*p) : pen_.line_to(*p);
    forget_handles();
    return true;
  }

  bool draw_level(char kind) {
    const auto value = number();
    if (!value) return false;
    Point p = pen_.at();
    double& moved = kind == 'h' ? p.x : p.y;
    moved = relative_ ? moved + *value : *value;
    pen_.line_to(p);
    forget_handles();
    return true;
  }

  bool draw_cubic(char kind) {
    const Point at = pen_.at();
    const auto first = kind == 'c' ? point() : std::optional(cubic_handle_ ? at * 2 - *cubic_handle_ : at);
    const auto second = first ? point() : std::nullopt;
    const auto p = second ? point() : std::nullopt;
    if (!p) return false;
    pen_.curve_to(*first, *second, *p);
    forget_handles();
    cubic_handle_ = second;
    return true;
  }

  bool draw_quadratic(char kind) {
    const Point at = pen_.at();
    const auto middle = kind == 'q' ? point() : std::optional(quadratic_handle_ ? at * 2 - *quadratic_handle_ : at);
    const auto p = middle ? point() : std::nullopt;
    if (!p) return false;
    pen_.curve_to(*middle, *p);
    forget_handles();
    quadratic_handle_ = middle;
    return true;
  }

  bool draw_arc() {
    const auto rx = number();
    const auto ry = rx ? number() : std::nullopt;
    const auto turn = ry ? number() : std::nullopt;
    const auto large = turn ? flag() : std::nullopt;
    const auto sweep = large ? flag() : std::nullopt;
    const auto p = sweep ? point() : std::nullopt;
    if (!p) return false;
    pen_.arc_to({*rx, *ry}, *turn, *large, *sweep, *p);
    forget_handles();
    return true;
  }

  std::optional<double> number() {
    scanner_.skip_separator();
    return scanner_.number();
  }
  std::optional<bool> flag() {
    scanner_.skip_separator();
    return scanner_.flag();
  }
  std::optional<Point> point() {
    const auto x = number();
    const auto y = x ? number() : std::nullopt;
    if (!y) return std::nullopt;
    const Point p{*x, *y};
    return relative_ ? pen_.at() + p : p;
  }

  void forget_handles() {
    cubic_handle_.reset();
    quadratic_handle_.reset();
  }

  NumberScanner scanner_;
  OutlinePen& pen_;
  std::optional<Point> cubic_handle_;  ///< the second of the curve before, which S mirrors
  std::optional<Point> quadratic_handle_;
  bool relative_ = false;
};

}  // namespace

base::Status draw_path(std::string_view data, OutlinePen& pen) { return PathDrawer(data, pen).draw(); }

}  // namespace penpose::io
