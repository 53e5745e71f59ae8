#pragma once

#include "tests/judges/rigs/builder.h"
#include "tests/judges/rigs/random/dice.h"
#include "tests/judges/rigs/random/landmarks.h"

namespace penpose::judges {

/// Pieces of a figure under a head, each of which a joint of its own carries.
struct BodyPiece {
  std::string name;
  std::string above;  ///< the piece that it hangs on; empty: none
  ModelPoint at;      ///< its joint
  std::vector<std::uint32_t> vertices;
};

/// Adds a body to the end of the mesh; muscles do not move it.
[[nodiscard]] std::vector<BodyPiece> add_body(Parts& parts, Dice dice);

}  // namespace penpose::judges
