#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/byte_writer.h"
#include "core/base/json/json.h"
#include "core/base/result.h"

namespace penpose::io {

/// What a buffer view is bound to (glTF 2.0, section 5.11).
enum class BufferUse : std::uint8_t { plain, vertices, indices };

/// Gathers accessors and their bytes for a binary glTF file. All accessors are tightly packed, each in a buffer view of
/// its own, aligned to 4 bytes.
class GltfBuilder {
 public:
  /// The document without buffers, bufferViews and accessors; the caller fills it.
  json::Json root = json::Json::object();

  GltfBuilder() = default;
  /// Goes on with a document whose views and accessors stay. What is added lies in this buffer from this byte on, a
  /// multiple of 4.
  GltfBuilder(json::Json document, std::size_t buffer, std::size_t start)
      : root(std::move(document)), buffer_(buffer), start_(start) {}

  /// What lies in the buffer already: numbers of animations that are there are not added again, so that a file that is
  /// saved again and again does not grow. The bytes have to outlive this.
  void reuse(base::Bytes known) { known_ = known; }

  /// Adds an object to an array of the root and returns its index.
  std::size_t add(const char* array, json::Json object);

  /// `type` is SCALAR, VEC3, VEC4 or MAT4; `numbers` are whole elements. `bounds`: with minimum and maximum.
  std::size_t add_floats(std::span<const float> numbers, const char* type, BufferUse use, bool bounds);
  /// Corner numbers, in 16 bits where 65,534 is enough.
  std::size_t add_indices(std::span<const std::uint32_t> indices);
  /// VEC4 of joint numbers, in 8 bits where that is enough.
  std::size_t add_joints(std::span<const std::uint32_t> joints);
  /// VEC3 that is zero but at `elements`, strictly ascending, where it is `values`. Sparse where that is smaller or
  /// `keep_zeros` asks for elements that are zero to stay listed.
  std::size_t add_displacements(std::size_t count, std::span<const std::uint32_t> elements,
                                std::span<const float> values, bool keep_zeros, bool bounds);

  /// A view of bytes that no accessor reads, such as a picture.
  std::size_t add_bytes(base::Bytes bytes);
  /// A list of zeros, without a view: `type` as above.
  std::size_t add_zeros(std::size_t count, const char* type, bool bounds);

  /// What was added so far.
  [[nodiscard]] base::Bytes added() const { return binary_.bytes(); }

  /// The file. Errors: it would be larger than its 32-bit lengths can say.
  [[nodiscard]] base::Result<std::vector<std::uint8_t>> finish();

 private:
  std::size_t add_view(std::size_t start, BufferUse use);
  /// The accessor that reads these numbers from what is known, if any.
  [[nodiscard]] std::optional<std::size_t> known_floats(std::span<const float> numbers, const char* type,
                                                        bool bounds) const;
  std::size_t write_floats(std::span<const float> numbers, BufferUse use);

  base::ByteWriter binary_;
  base::Bytes known_;
  std::size_t buffer_ = 0;
  std::size_t start_ = 0;
};

/// A .glb file of its JSON text and the pieces of its one buffer, each a multiple of 4 bytes but the last; none: no
/// buffer. Errors: it would be larger than its 32-bit lengths can say.
[[nodiscard]] base::Result<std::vector<std::uint8_t>> pack_glb(std::string text, std::span<const base::Bytes> pieces);
/// In which order the members of a document are written: by their names, or as they were read.
enum class TextOrder : bool { by_name, as_made };
/// The text of a document. Errors: it cannot be written.
[[nodiscard]] base::Result<std::string> text_of(const json::Json& document, TextOrder order);

}  // namespace penpose::io
