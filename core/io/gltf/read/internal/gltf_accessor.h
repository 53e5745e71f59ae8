#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/gltf/read/internal/gltf_document.h"

namespace penpose::io {

/// The numbers of an accessor. A sparse accessor without a base buffer view is zero but for its sparse elements.
struct Elements {
  std::size_t count = 0;
  std::size_t components = 0;         ///< numbers an element
  bool has_base = false;              ///< false: `base` is empty and means zeros
  std::vector<float> base;            ///< count * components, sparse elements not yet in it
  std::vector<std::uint32_t> sparse;  ///< elements that have another value, strictly ascending
  std::vector<float> sparse_values;   ///< sparse.size() * components

  /// All count * components numbers, sparse elements put in.
  [[nodiscard]] std::vector<float> dense() const;
};

/// What the caller can use.
struct ElementRule {
  int type = TINYGLTF_TYPE_VEC3;       ///< tinygltf's number of the type
  std::optional<std::size_t> count{};  ///< how many elements there have to be
  bool float_only = false;
  bool needs_data = false;    ///< zeros alone make no sense
  bool stays_sparse = false;  ///< the caller never makes it dense, so that zeros cost nothing
  std::uint64_t cost = 1;     ///< what a number of it counts for against the document's budget
};

/// Corners of triangles and places of vertices are kept with neighbours, edges and parts: a number of them takes some
/// 42 bytes, any other one some 14.
inline constexpr std::uint64_t k_cost_of_geometry = 3;

/// Reads an accessor; integers that are marked normalized become -1..1 or 0..1 (glTF 2.0, section 3.11). Bounds are
/// checked before anything is read, and what is read counts against the document's budget.
/// Errors: place is the JSON pointer of the accessor.
[[nodiscard]] base::Result<Elements> read_elements(GltfDocument& document, int accessor, const ElementRule& rule);

/// Reads an accessor of unsigned integers: indices of primitives. Same errors.
[[nodiscard]] base::Result<std::vector<std::uint32_t>> read_indices(GltfDocument& document, int accessor);

/// The pointer "/accessors/N".
[[nodiscard]] std::string accessor_pointer(int accessor);

}  // namespace penpose::io
