#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/base/result.h"

namespace penpose::io {

enum class MeshoptMode : std::uint8_t { attributes, triangles, indices };
enum class MeshoptFilter : std::uint8_t { none, octahedral, quaternion, exponential };

/// What a buffer view says of its compressed bytes (EXT_meshopt_compression).
struct MeshoptLayout {
  MeshoptMode mode = MeshoptMode::attributes;
  MeshoptFilter filter = MeshoptFilter::none;  ///< of attributes alone
  std::uint64_t count = 0;                     ///< elements
  std::uint64_t stride = 0;                    ///< bytes an element, once unpacked
};

/// The stand-ins for meshoptimizer's codecs return this in a build without them.
inline constexpr int k_meshopt_left_out = -1000;

/// The count * stride bytes that a stream unpacks to. Codecs by meshoptimizer; filters by the formulas of the
/// extension, so that they give the same bits everywhere. `most`: bytes that may be taken. A stream that claims more
/// than its bytes can say is refused before memory is taken. Errors (without a place): a layout that the extension does
/// not allow, too many bytes, a stream that is damaged or of a newer version, and a build without the codecs.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> unpack_meshopt(base::Bytes stream, const MeshoptLayout& layout,
                                                                     std::uint64_t most);

}  // namespace penpose::io
