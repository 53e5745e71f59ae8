#include "core/io/gltf/read/compression/draco_stream.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <draco/attributes/attribute_octahedron_transform.h>
#include <draco/attributes/attribute_quantization_transform.h>
#include <draco/compression/attributes/normal_compression_utils.h>
#include <draco/compression/mesh/mesh_edgebreaker_decoder.h>
#include <draco/compression/mesh/mesh_sequential_decoder.h>
#include <draco/core/varint_decoding.h>
#include <limits>
#include <string>

#include "core/io/remedies.h"

namespace penpose::io {
namespace {

/// What a triangle takes while its stream is read: three corners, and the library's tables of them.
constexpr std::uint64_t k_bytes_a_triangle = 12;

base::Error wrong_draco(std::string what, std::string remedy = k_copy_again) {
  return {std::move(what), "", std::move(remedy)};
}

base::Error too_much() {
  return wrong_draco("the file unpacks to far more than it has bytes",
                     "divide the model, or export it without compression");
}

/// An attribute as its stream describes it, before the library makes whole numbers of it.
struct Described {
  std::uint32_t unique_id = 0;
  draco::DataType type = draco::DT_INVALID;
  bool normalized = false;
};

/// One of the library's decoders that looks at what a stream claims before memory is taken for it.
template <typename Decoder>
class Careful : public Decoder {
 public:
  Careful(bool edge_breaker, std::uint64_t most) : edge_breaker_(edge_breaker), left_(most) {}

  [[nodiscard]] bool is_too_much() const { return too_much_; }
  [[nodiscard]] std::span<const Described> described() const { return described_; }

 protected:
  bool DecodeGeometryData() override {
    draco::DecoderBuffer ahead = *this->buffer();
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    if (!draco::DecodeVarint(&first, &ahead) || !draco::DecodeVarint(&second, &ahead)) return false;
    const std::uint64_t triangles = edge_breaker_ ? second : first;
    const std::uint64_t vertices = edge_breaker_ ? first : second;
    return spend(triangles * k_bytes_a_triangle) && vertices <= 3 * triangles && Decoder::DecodeGeometryData();
  }

  bool DecodeAllAttributes() override {
    const std::uint64_t points = this->point_cloud()->num_points();
    for (std::int32_t i = 0; i < this->point_cloud()->num_attributes(); ++i) {
      const draco::PointAttribute& attribute = *this->point_cloud()->attribute(i);
      described_.push_back({attribute.unique_id(), attribute.data_type(), attribute.normalized()});
      const auto size = static_cast<std::uint64_t>(std::max(draco::DataTypeLength(attribute.data_type()), 4));
      if (!spend(points * static_cast<std::uint64_t>(attribute.num_components()) * size)) return false;
    }
    return Decoder::DecodeAllAttributes();
  }

 private:
  bool spend(std::uint64_t bytes) {
    too_much_ = too_much_ || bytes > left_;
    if (!too_much_) left_ -= bytes;
    return !too_much_;
  }

  bool edge_breaker_;
  bool too_much_ = false;
  std::uint64_t left_;
  std::vector<Described> described_;
};

/// The numbers of one attribute of a mesh.
class Numbers {
 public:
  Numbers(const draco::PointAttribute& attribute, const Described& described)
      : attribute_(attribute), described_(described) {}

  /// Errors: another number of components, or numbers of a kind that glTF does not know.
  base::Status open(std::size_t components) {
    const draco::AttributeTransformData* how = attribute_.GetAttributeTransformData();
    auto have = static_cast<std::size_t>(attribute_.num_components());
    if (how != nullptr && how->transform_type() == draco::ATTRIBUTE_QUANTIZATION_TRANSFORM) {
      if (!steps_.InitFromAttribute(attribute_) || steps_.min_values().size() != have) return damaged();
      if (steps_.quantization_bits() < 1 || steps_.quantization_bits() > 31) return damaged();
      step_ = steps_.range() / static_cast<float>((std::uint32_t{1} << steps_.quantization_bits()) - 1U);
      quantized_ = true;
    } else if (how != nullptr && how->transform_type() == draco::ATTRIBUTE_OCTAHEDRON_TRANSFORM) {
      draco::AttributeOctahedronTransform transform;
      if (have != 2 || !transform.InitFromAttribute(attribute_)) return damaged();
      if (!octahedron_.SetQuantizationBits(transform.quantization_bits())) return damaged();
      directions_ = true;
      have = 3;
    }
    if (have != components || components > 4) {
      return wrong_draco("Draco's attribute " + std::to_string(described_.unique_id) + " has " + std::to_string(have) +
                             " numbers a vertex where " + std::to_string(components) + " were expected",
                         k_export_again);
    }
    return base::Done{};
  }

  /// All the numbers of a point; false: there are none.
  bool at(std::uint32_t point, std::array<double, 4>& out) const {
    const draco::AttributeValueIndex entry = attribute_.mapped_index(draco::PointIndex(point));
    if (entry.value() >= attribute_.size()) return false;
    const auto components = static_cast<std::size_t>(attribute_.num_components());
    if (quantized_ || directions_) {
      std::array<std::int32_t, 4> whole{};
      if (!raw(entry, std::span(whole).first(components))) return false;
      if (directions_) {
        std::array<float, 3> direction{};
        octahedron_.QuantizedOctahedralCoordsToUnitVector(whole[0], whole[1], direction.data());
        std::copy(direction.begin(), direction.end(), out.begin());
        return true;
      }
      for (std::size_t c = 0; c < components; ++c) {
        const float value = static_cast<float>(whole[c]) * step_ + steps_.min_value(static_cast<int>(c));
        out[c] = static_cast<double>(value);
      }
      return true;
    }
    switch (attribute_.data_type()) {
      case draco::DT_INT8:
        return plain<std::int8_t>(entry, components, out);
      case draco::DT_UINT8:
      case draco::DT_BOOL:
        return plain<std::uint8_t>(entry, components, out);
      case draco::DT_INT16:
        return plain<std::int16_t>(entry, components, out);
      case draco::DT_UINT16:
        return plain<std::uint16_t>(entry, components, out);
      case draco::DT_INT32:
        return plain<std::int32_t>(entry, components, out);
      case draco::DT_UINT32:
        return plain<std::uint32_t>(entry, components, out);
      case draco::DT_FLOAT32:
        return plain<float>(entry, components, out);
      case draco::DT_FLOAT64:
        return plain<double>(entry, components, out);
      default:
        return false;
    }
  }

  /// What 1 is of whole numbers that stand for 0..1 or -1..1; 1 for any others.
  [[nodiscard]] double one() const {
    if (!described_.normalized) return 1;
    switch (described_.type) {
      case draco::DT_INT8:
        return std::numeric_limits<std::int8_t>::max();
      case draco::DT_UINT8:
        return std::numeric_limits<std::uint8_t>::max();
      case draco::DT_INT16:
        return std::numeric_limits<std::int16_t>::max();
      case draco::DT_UINT16:
        return std::numeric_limits<std::uint16_t>::max();
      default:
        return 1;
    }
  }

 private:
  static base::Error damaged() { return wrong_draco("the Draco stream is cut off or damaged"); }

  template <typename T>
  bool raw(draco::AttributeValueIndex entry, std::span<T> out) const {
    const std::size_t size = out.size_bytes();
    const auto stride = static_cast<std::uint64_t>(attribute_.byte_stride());
    const auto offset = static_cast<std::uint64_t>(attribute_.byte_offset()) + stride * entry.value();
    if (stride < size || attribute_.buffer() == nullptr || offset + size > attribute_.buffer()->data_size())
      return false;
    std::memcpy(out.data(), attribute_.buffer()->data() + offset, size);
    return true;
  }
  template <typename T>
  bool plain(draco::AttributeValueIndex entry, std::size_t components, std::array<double, 4>& out) const {
    std::array<T, 4> values{};
    if (!raw(entry, std::span(values).first(components))) return false;
    for (std::size_t c = 0; c < components; ++c) out[c] = static_cast<double>(values[c]);
    return true;
  }

  const draco::PointAttribute& attribute_;
  const Described& described_;
  draco::AttributeQuantizationTransform steps_;
  draco::OctahedronToolBox octahedron_;
  float step_ = 0;
  bool quantized_ = false;
  bool directions_ = false;
};

template <typename T>
bool put(std::vector<std::uint8_t>& out, double value) {
  if constexpr (std::is_integral_v<T>) {
    // Not a number is not in the range either.
    if (!(value >= static_cast<double>(std::numeric_limits<T>::min()) &&
          value <= static_cast<double>(std::numeric_limits<T>::max())))
      return false;
  }
  const auto number = static_cast<T>(value);
  std::array<std::uint8_t, sizeof(T)> bytes{};
  std::memcpy(bytes.data(), &number, sizeof(T));
  out.insert(out.end(), bytes.begin(), bytes.end());
  return true;
}

bool put(int component_type, std::vector<std::uint8_t>& out, double value) {
  switch (component_type) {
    case 5120:
      return put<std::int8_t>(out, value);
    case 5121:
      return put<std::uint8_t>(out, value);
    case 5122:
      return put<std::int16_t>(out, value);
    case 5123:
      return put<std::uint16_t>(out, value);
    case 5125:
      return put<std::uint32_t>(out, value);
    case 5126:
      return put<float>(out, value);
    default:
      return false;
  }
}

base::Result<std::vector<std::uint8_t>> numbers_of(const draco::Mesh& mesh, std::span<const Described> described,
                                                   const DracoAttribute& wanted) {
  const auto found = std::find_if(described.begin(), described.end(),
                                  [&](const Described& one) { return one.unique_id == wanted.unique_id; });
  if (found == described.end()) {
    return wrong_draco("the Draco stream has no attribute " + std::to_string(wanted.unique_id), k_export_again);
  }
  const draco::PointAttribute* attribute = mesh.attribute(static_cast<int>(found - described.begin()));
  Numbers numbers(*attribute, *found);
  if (const auto opened = numbers.open(wanted.components); !opened) return opened.error();
  const double one = wanted.component_type == 5126 ? numbers.one() : 1.0;
  std::vector<std::uint8_t> bytes;
  bytes.reserve(std::size_t{mesh.num_points()} * wanted.components * 4);
  std::array<double, 4> values{};
  for (std::uint32_t point = 0; point < mesh.num_points(); ++point) {
    bool fits = numbers.at(point, values);
    for (std::size_t c = 0; fits && c < wanted.components; ++c) {
      fits = put(wanted.component_type, bytes, one == 1.0 ? values[c] : std::max(values[c] / one, -1.0));
    }
    if (!fits) {
      return wrong_draco("a number of Draco's attribute " + std::to_string(wanted.unique_id) +
                             " does not fit the accessor that names it",
                         k_export_again);
    }
  }
  return bytes;
}

template <typename Decoder>
base::Result<DracoMesh> unpack(base::Bytes stream, bool edge_breaker, std::span<const DracoAttribute> wanted,
                               std::uint64_t most) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(stream.data()), stream.size());
  draco::DecoderOptions options;
  for (int type = 0; type < draco::GeometryAttribute::NAMED_ATTRIBUTES_COUNT; ++type) {
    options.SetAttributeBool(static_cast<draco::GeometryAttribute::Type>(type), "skip_attribute_transform", true);
  }
  Careful<Decoder> decoder(edge_breaker, most);
  draco::Mesh mesh;
  const draco::Status status = decoder.Decode(options, &buffer, &mesh);
  if (decoder.is_too_much()) return too_much();
  if (!status.ok() || mesh.num_points() == 0 || mesh.num_faces() == 0) {
    return wrong_draco("the Draco stream is cut off or damaged");
  }
  DracoMesh result;
  result.points = mesh.num_points();
  result.corners.reserve(std::size_t{mesh.num_faces()} * 3);
  for (std::uint32_t f = 0; f < mesh.num_faces(); ++f) {
    for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(f))) {
      if (corner.value() >= result.points) return wrong_draco("the Draco stream is cut off or damaged");
      result.corners.push_back(corner.value());
    }
  }
  for (const DracoAttribute& one : wanted) {
    auto bytes = numbers_of(mesh, decoder.described(), one);
    if (!bytes) return bytes.error();
    result.attributes.push_back(std::move(bytes).value());
  }
  return result;
}

}  // namespace

base::Result<DracoMesh> unpack_draco(base::Bytes stream, std::span<const DracoAttribute> wanted, std::uint64_t most) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(stream.data()), stream.size());
  draco::DracoHeader header;
  if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) {
    return wrong_draco("the data is no Draco stream", "export the file again, or without compression");
  }
  if (header.version_major != 2 || header.version_minor != 2) {
    return wrong_draco("Draco's version " + std::to_string(header.version_major) + "." +
                           std::to_string(header.version_minor) + " is not the 2.2 that glTF has",
                       "export the file without compression");
  }
  if (header.encoder_type != draco::TRIANGULAR_MESH) {
    return wrong_draco("the Draco stream holds points and no triangles", "export the file without compression");
  }
  if (header.encoder_method == draco::MESH_SEQUENTIAL_ENCODING) {
    return unpack<draco::MeshSequentialDecoder>(stream, false, wanted, most);
  }
  if (header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING) {
    return unpack<draco::MeshEdgebreakerDecoder>(stream, true, wanted, most);
  }
  return wrong_draco("the Draco stream is cut off or damaged");
}

}  // namespace penpose::io
