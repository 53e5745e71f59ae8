#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::io {

/// An attribute that is wanted of a Draco mesh, and how glTF wants its numbers.
struct DracoAttribute {
  std::uint32_t unique_id = 0;
  int component_type = 5126;   ///< glTF's: 5120 to 5123, 5125, 5126
  std::size_t components = 3;  ///< 1 to 4 numbers a point
};

struct DracoMesh {
  std::size_t points = 0;
  std::vector<std::uint32_t> corners;                 ///< three points a triangle
  std::vector<std::vector<std::uint8_t>> attributes;  ///< of those wanted, in their order; little-endian, no gaps
};

/// Unpacks a mesh of Draco's bit stream 2.2 (KHR_draco_mesh_compression). Whole numbers come from the library; what
/// they stand for is worked out here, so that the bits are the same everywhere. `most`: bytes that triangles and
/// attributes may take, checked before they are unpacked. Errors (without a place): no Draco mesh, another version, too
/// many bytes, an attribute that is not there or does not fit, a stream that is damaged.
[[nodiscard]] base::Result<DracoMesh> unpack_draco(base::Bytes stream, std::span<const DracoAttribute> wanted,
                                                   std::uint64_t most);

}  // namespace penpose::io
