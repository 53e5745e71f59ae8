#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/portrait/read_drawing.h"
#include "tests/judges/hands/hand.h"
#include "tests/support/random.h"

namespace penpose::judges::drawn {

using geometry::PxPoint;

/// How an artist's pen moves: what becomes of a line that is meant.
struct Stroke {
  Hand hand;
  double doubled = 0;    ///< share of lines that are drawn a second time, a little beside
  double in_pieces = 0;  ///< share of lines that are drawn in two pieces
};

/// A line and which of the meant ones it is of.
struct DrawnStroke {
  portrait::DrawnLine points;
  std::size_t meant = 0;
};

/// A meant line as somebody draws it: once, in two pieces, or twice.
[[nodiscard]] std::vector<DrawnStroke> strokes_of(const Stroke& stroke, std::span<const PxPoint> meant,
                                                  std::size_t number, tests::Random& random);

/// A sheet of paper, x to the right, y down. A face on it is about 700 px high.
class Sheet {
 public:
  Sheet(const Stroke& stroke, std::uint64_t seed) : stroke_(stroke), random_(seed) {}

  /// A smooth line through these points.
  void line(const std::vector<PxPoint>& through);
  /// A smooth line that ends where it begins.
  void loop(const std::vector<PxPoint>& through);
  /// Straight from point to point.
  void corners(const std::vector<PxPoint>& points);
  void oval(PxPoint middle, double half_width, double half_height);
  /// Part of an oval, from one angle to another: degrees, 0 at its right, 90 at its top.
  void arc(PxPoint middle, double half_width, double half_height, double from_degrees, double to_degrees);

  /// A number that differs from sheet to sheet.
  [[nodiscard]] double about(double value, double share) { return value * (1 + random_(-share, share)); }
  [[nodiscard]] tests::Random& random() { return random_; }
  [[nodiscard]] const std::vector<portrait::DrawnLine>& lines() const { return lines_; }

 private:
  void draw(std::span<const PxPoint> meant);

  const Stroke& stroke_;
  tests::Random random_;
  std::vector<portrait::DrawnLine> lines_;
};

}  // namespace penpose::judges::drawn
