#include "core/io/gltf/read/compression/meshopt_stream.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <meshoptimizer.h>
#include <string>

#include "core/io/remedies.h"

namespace penpose::io {
namespace {

/// An element of attributes takes a 64th of its bytes at least: a header of 2 bits for 16 bytes that are all alike.
constexpr std::uint64_t k_most_for_a_byte = 64;
/// A triangle takes a byte at least; so does an index.
constexpr std::uint64_t k_most_indices_for_a_byte = 3;

base::Error no_stream(std::string what, std::string remedy = k_export_again) {
  return {std::move(what), "", std::move(remedy)};
}

template <typename T>
T number_at(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

/// Halves away from zero, within the type.
template <typename T>
void put_rounded(std::uint8_t* bytes, float value) {
  const auto most = static_cast<float>(std::numeric_limits<T>::max());
  const float kept = std::isfinite(value) ? std::clamp(value, -most, most) : 0.0F;
  const auto whole = static_cast<T>(static_cast<int>(kept + (kept >= 0.0F ? 0.5F : -0.5F)));
  std::memcpy(bytes, &whole, sizeof(T));
}

/// A direction from the octahedron x, y, one (Meyer, Süßmuth, Sußner, Stamminger and Greiner 2010).
template <typename T>
void octahedral(std::uint8_t* element) {
  auto x = static_cast<float>(number_at<T>(element));
  auto y = static_cast<float>(number_at<T>(element + sizeof(T)));
  const float z = static_cast<float>(number_at<T>(element + 2 * sizeof(T))) - std::abs(x) - std::abs(y);
  const float folded = z >= 0.0F ? 0.0F : z;
  x += x >= 0.0F ? folded : -folded;
  y += y >= 0.0F ? folded : -folded;
  const float scale = static_cast<float>(std::numeric_limits<T>::max()) / std::sqrt(x * x + y * y + z * z);
  put_rounded<T>(element, x * scale);
  put_rounded<T>(element + sizeof(T), y * scale);
  put_rounded<T>(element + 2 * sizeof(T), z * scale);
}

/// A quaternion from its three smaller numbers, the scale and the place of the largest.
void quaternion(std::uint8_t* element) {
  const auto last = number_at<std::int16_t>(element + 6);
  const float unit = (1.0F / std::sqrt(2.0F)) / static_cast<float>(last | 3);
  const float x = static_cast<float>(number_at<std::int16_t>(element)) * unit;
  const float y = static_cast<float>(number_at<std::int16_t>(element + 2)) * unit;
  const float z = static_cast<float>(number_at<std::int16_t>(element + 4)) * unit;
  const float rest = 1.0F - x * x - y * y - z * z;
  const auto largest = static_cast<std::size_t>(last & 3);
  const auto put = [&](std::size_t after, float value) {
    put_rounded<std::int16_t>(element + 2 * ((largest + after) & 3U), value * 32767.0F);
  };
  put(1, x);
  put(2, y);
  put(3, z);
  put(0, rest >= 0.0F ? std::sqrt(rest) : 0.0F);
}

/// m * 2^e of 24 and 8 bits.
void exponential(std::uint8_t* element) {
  const auto packed = number_at<std::uint32_t>(element);
  const auto mantissa = static_cast<std::int32_t>(packed << 8) >> 8;
  const auto exponent = static_cast<std::int32_t>(packed) >> 24;
  const auto power = std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
  const auto value = static_cast<float>(static_cast<double>(mantissa) * power);
  std::memcpy(element, &value, sizeof value);
}

void apply(MeshoptFilter filter, std::size_t stride, std::vector<std::uint8_t>& bytes) {
  if (filter == MeshoptFilter::none) return;
  const std::size_t step = filter == MeshoptFilter::exponential ? 4 : stride;
  for (std::size_t at = 0; at + step <= bytes.size(); at += step) {
    std::uint8_t* element = bytes.data() + at;
    if (filter == MeshoptFilter::quaternion) {
      quaternion(element);
    } else if (filter == MeshoptFilter::exponential) {
      exponential(element);
    } else if (stride == 4) {
      octahedral<std::int8_t>(element);
    } else {
      octahedral<std::int16_t>(element);
    }
  }
}

base::Status check_layout(const MeshoptLayout& layout) {
  const bool attributes = layout.mode == MeshoptMode::attributes;
  const std::uint64_t stride = layout.stride;
  if (layout.count == 0) return no_stream("a compressed buffer view of no elements");
  if (attributes ? stride == 0 || stride % 4 != 0 || stride > 256 : stride != 2 && stride != 4) {
    return no_stream("compressed elements of " + std::to_string(stride) + " bytes");
  }
  if (layout.mode == MeshoptMode::triangles && layout.count % 3 != 0) {
    return no_stream(std::to_string(layout.count) + " indices of compressed triangles, which is no multiple of three");
  }
  const bool fits = layout.filter == MeshoptFilter::none ||
                    (attributes && (layout.filter == MeshoptFilter::exponential ||
                                    (layout.filter == MeshoptFilter::quaternion && stride == 8) ||
                                    (layout.filter == MeshoptFilter::octahedral && (stride == 4 || stride == 8))));
  if (!fits) return no_stream("a filter that compressed elements of " + std::to_string(stride) + " bytes cannot have");
  return base::Done{};
}

}  // namespace

base::Result<std::vector<std::uint8_t>> unpack_meshopt(base::Bytes stream, const MeshoptLayout& layout,
                                                       std::uint64_t most) {
  if (const auto checked = check_layout(layout); !checked) return checked.error();
  const bool attributes = layout.mode == MeshoptMode::attributes;
  const std::uint64_t for_a_byte = attributes ? k_most_for_a_byte : k_most_indices_for_a_byte * layout.stride;
  const std::uint64_t claimable = for_a_byte * (std::uint64_t{stream.size()} + 64);
  if (layout.count > claimable / layout.stride) {
    return no_stream(std::to_string(layout.count) + " elements from " + std::to_string(stream.size()) +
                     " compressed bytes, which cannot hold so many");
  }
  if (layout.count * layout.stride > most) {
    return no_stream("the file unpacks to far more than it has bytes",
                     "divide the model, or export it without compression");
  }
  // The low half of the first byte is the version (0; indices also know 1).
  const unsigned version = stream.empty() ? 0 : stream.front() & 15U;
  if (version > (attributes ? 0U : 1U)) {
    return no_stream(
        "compressed data of meshopt's version " + std::to_string(version) + ", which is newer than this program",
        "export the file without compression, or with an older gltfpack");
  }
  const auto count = static_cast<std::size_t>(layout.count);
  const auto stride = static_cast<std::size_t>(layout.stride);
  std::vector<std::uint8_t> bytes(count * stride);
  const int failed = attributes ? meshopt_decodeVertexBuffer(bytes.data(), count, stride, stream.data(), stream.size())
                     : layout.mode == MeshoptMode::triangles
                         ? meshopt_decodeIndexBuffer(bytes.data(), count, stride, stream.data(), stream.size())
                         : meshopt_decodeIndexSequence(bytes.data(), count, stride, stream.data(), stream.size());
  if (failed == k_meshopt_left_out) {
    return no_stream("the file is compressed by meshopt, which this build does not unpack",
                     "export it without compression");
  }
  if (failed != 0) return no_stream("the meshopt stream is cut off or damaged", k_copy_again);
  apply(layout.filter, stride, bytes);
  return bytes;
}

}  // namespace penpose::io
