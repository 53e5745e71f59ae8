#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace penpose::document {

/// A named path along vertices of a model.
struct VertexCurve {
  std::string name;
  std::vector<std::uint32_t> vertices;  ///< at least 2, in order along the curve
};

}  // namespace penpose::document
