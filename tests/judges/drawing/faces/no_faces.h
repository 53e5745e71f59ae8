#pragma once

#include <cstdint>
#include <span>

#include "tests/judges/drawing/faces/sheet.h"

namespace penpose::judges::drawn {

/// Something that is no face.
struct NoFace {
  const char* name;
  void (*draw)(Sheet& sheet);
};

/// A boat, a flower, a fish, a flight of stairs, writing, a spiral, a bottle, a plan of a flat.
[[nodiscard]] std::span<const NoFace> no_faces();

/// The same seed gives the same lines.
[[nodiscard]] portrait::Drawing drawn_thing(const NoFace& thing, std::uint64_t seed);

}  // namespace penpose::judges::drawn
