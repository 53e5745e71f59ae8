#pragma once

#include <cstddef>
#include <map>

#include "core/io/gltf/write/patch/patch_state.h"

namespace penpose::io {

/// Gives primitives whose triangles and attributes stand in Draco streams accessors with the same numbers, in the order
/// in which they come out of the stream: the one of their morph targets.
class PlainPrimitives {
 public:
  explicit PlainPrimitives(PatchState& state) : state_(state) {}

  /// `mesh` and `primitive`: in the file that was read; `object`: the primitive in the file that is written, which
  /// loses its stream. One without a stream stays as it is. Accessors keep their numbers where nobody else names them,
  /// their names and extras.
  void write(std::size_t mesh, std::size_t primitive, json::Json& object);
  /// Takes the extension off the lists of those that the file uses and requires, where no primitive has a stream.
  void forget_unused();

 private:
  [[nodiscard]] base::Bytes unpacked(int index) const;
  [[nodiscard]] json::Json attribute(int index, base::Bytes bytes, bool bounds);
  [[nodiscard]] json::Json corners(base::Bytes bytes, bool wide);
  void put(int index, json::Json& named, json::Json made);

  PatchState& state_;
  bool took_streams_ = false;
  std::map<int, std::size_t> written_;  ///< accessors as they were unpacked, and what they are in the file
};

}  // namespace penpose::io
