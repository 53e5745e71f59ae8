#pragma once

#include <cstdint>
#include <string_view>

#include "core/base/byte_reader.h"
#include "core/base/result.h"
#include "core/document/model.h"

namespace penpose::io {

enum class Up : std::uint8_t { y, z };

/// How the coordinates of a file are meant that does not say it itself: OBJ, PLY, OFF, STL. Models here have y up and
/// are right-handed.
struct Orientation {
  Up up = Up::y;
  bool left_handed = false;  ///< its x runs the other way

  [[nodiscard]] bool is_usual() const { return up == Up::y && !left_handed; }
};

/// Whether a file is of a format that leaves open how its coordinates are meant, told by content, then by name.
[[nodiscard]] bool has_open_orientation(base::Bytes bytes, std::string_view file_name);

/// The model of a surface as it stands here: (x, y, z) becomes (x, z, -y) where z is up; where it is left-handed x
/// changes its sign, and triangles turn round, so that they still face outwards. Vertices keep their numbers. Errors:
/// the model has controls or joints.
[[nodiscard]] base::Result<document::Model> oriented(const document::Model& model, const Orientation& orientation);

/// Whether a surface with y up looks as if it lay: it is longer from back to front than it is high.
[[nodiscard]] bool looks_as_if_z_were_up(const document::Model& model);

}  // namespace penpose::io
