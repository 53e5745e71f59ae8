#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/geometry/space.h"

namespace penpose::judges {

/// How a line is drawn that someone has in mind. Lengths are px of a picture in which the diagonal of the face is 800
/// px.
struct Hand {
  const char* name;
  double tremor_px = 0;     ///< root mean square, smooth over about a tenth of the line
  double uneven = 0;        ///< speed along the line changes by up to this factor less one
  double ends = 0;          ///< each end falls short or goes beyond by up to this share of the length
  bool backwards = false;   ///< drawn from the other end
  double wobbly_scale = 0;  ///< the line is larger or smaller about its middle by up to this share
};

/// exact, tremor_1, tremor_2, uneven, ends, backwards, wobbly.
[[nodiscard]] std::span<const Hand> all_hands();
/// Precondition: there is a hand of that name.
[[nodiscard]] const Hand& hand_named(std::string_view name);

/// The line as the hand draws it: `points` points. The same seed gives the same line. Precondition: at least two
/// points, not all at one place.
[[nodiscard]] std::vector<geometry::PxPoint> drawn_by(const Hand& hand, std::span<const geometry::PxPoint> meant,
                                                      std::uint64_t seed, std::size_t points = 40);

/// `count` points at equal distances along a line.
[[nodiscard]] std::vector<geometry::PxPoint> resampled(std::span<const geometry::PxPoint> line, std::size_t count);

/// A seed made of names and numbers, so that a case keeps its seed when others come and go.
[[nodiscard]] std::uint64_t seed_of(std::string_view rig, std::string_view of_case, std::uint64_t number = 0);

}  // namespace penpose::judges
