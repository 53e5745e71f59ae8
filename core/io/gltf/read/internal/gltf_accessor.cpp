#include "core/io/gltf/read/internal/gltf_accessor.h"

#include <algorithm>
#include <bit>
#include <type_traits>

#include "core/io/remedies.h"

namespace penpose::io {
namespace {

/// Zeros that no byte of the file stands for are dear: whoever writes them has nothing to say.
constexpr std::uint64_t k_cost_of_zeros = 16;

base::Error wrong_accessor(std::string what, std::string pointer, std::string remedy = k_export_again) {
  return {std::move(what), std::move(pointer), std::move(remedy)};
}

/// Elements in a buffer: element i starts at data + i * stride. All of them lie inside the buffer; of none there is no
/// data.
struct Run {
  const std::uint8_t* data = nullptr;
  std::size_t stride = 0;
};

base::Result<Run> locate(const GltfDocument& document, int view_index, std::uint64_t offset, std::uint64_t count,
                         std::uint64_t element_size, const std::string& pointer) {
  if (count == 0) return Run{};
  const tinygltf::BufferView& view = document.model.bufferViews[static_cast<std::size_t>(view_index)];
  const base::Bytes buffer = document.buffers[static_cast<std::size_t>(view.buffer)];
  if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset) {
    return wrong_accessor(
        "the buffer view reaches past the end of its buffer (" + std::to_string(buffer.size()) + " bytes)",
        "/bufferViews/" + std::to_string(view_index));
  }
  const std::uint64_t stride = view.byteStride == 0 ? element_size : view.byteStride;
  if (stride < element_size) {
    return wrong_accessor(
        "a byteStride of " + std::to_string(stride) + " for elements of " + std::to_string(element_size) + " bytes",
        "/bufferViews/" + std::to_string(view_index) + "/byteStride");
  }
  // count < 2^31 and stride <= 252, or an element size of 64 at most: no overflow.
  const std::uint64_t needed = (count - 1) * stride + element_size;
  if (offset > view.byteLength || needed > view.byteLength - offset) {
    return wrong_accessor(std::to_string(count) + " elements need " + std::to_string(needed) + " bytes at byte " +
                              std::to_string(offset) + " of a buffer view of " + std::to_string(view.byteLength),
                          pointer);
  }
  return Run{buffer.data() + view.byteOffset + offset, static_cast<std::size_t>(stride)};
}

template <typename T>
T load(const std::uint8_t* bytes) {
  using Raw = std::make_unsigned_t<std::conditional_t<std::is_floating_point_v<T>, std::int32_t, T>>;
  Raw raw = 0;
  for (std::size_t i = 0; i < sizeof(Raw); ++i) raw = static_cast<Raw>(raw | (static_cast<Raw>(bytes[i]) << (8 * i)));
  return std::bit_cast<T>(raw);
}

template <typename T>
float to_float(T value, bool normalized) {
  if constexpr (std::is_floating_point_v<T>) {
    return value;
  } else {
    if (!normalized) return static_cast<float>(value);
    const double unit = static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max());
    return static_cast<float>(std::max(unit, -1.0));
  }
}

template <typename T>
void copy_run(const Run& run, std::size_t count, std::size_t components, bool normalized, std::vector<float>& out) {
  out.resize(count * components);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* element = run.data + i * run.stride;
    for (std::size_t c = 0; c < components; ++c) {
      out[i * components + c] = to_float(load<T>(element + c * sizeof(T)), normalized);
    }
  }
}

void copy_run(const Run& run, std::size_t count, std::size_t components, int component_type, bool normalized,
              std::vector<float>& out) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return copy_run<std::int8_t>(run, count, components, normalized, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return copy_run<std::uint8_t>(run, count, components, normalized, out);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return copy_run<std::int16_t>(run, count, components, normalized, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return copy_run<std::uint16_t>(run, count, components, normalized, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return copy_run<std::uint32_t>(run, count, components, normalized, out);
    default:
      return copy_run<float>(run, count, components, normalized, out);
  }
}

std::vector<std::uint32_t> copy_indices(const Run& run, std::size_t count, int component_type) {
  std::vector<std::uint32_t> indices(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* element = run.data + i * run.stride;
    if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) {
      indices[i] = *element;
    } else if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) {
      indices[i] = load<std::uint16_t>(element);
    } else {
      indices[i] = load<std::uint32_t>(element);
    }
  }
  return indices;
}

bool is_index_type(int type) {
  return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

std::size_t size_of(int component_type) {
  return static_cast<std::size_t>(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_type)));
}

base::Status spend(GltfDocument& document, std::uint64_t numbers, const std::string& pointer) {
  if (numbers > document.budget) {
    return wrong_accessor("the file unfolds to far more numbers than it has bytes", pointer,
                          "it is damaged or hostile; export it again without shared data");
  }
  document.budget -= static_cast<std::size_t>(numbers);
  return base::Done{};
}

base::Status read_sparse(GltfDocument& document, const tinygltf::Accessor& accessor, const std::string& pointer,
                         Elements& elements) {
  const auto& sparse = accessor.sparse;
  const std::string here = pointer + "/sparse";
  const auto count = static_cast<std::size_t>(sparse.count);
  if (count > elements.count) return wrong_accessor("more sparse elements than elements", here + "/count");
  if (!is_index_type(sparse.indices.componentType)) {
    return wrong_accessor("sparse indices of a type that is no unsigned integer", here + "/indices/componentType");
  }
  const std::size_t size = size_of(accessor.componentType) * elements.components;
  const auto indices =
      locate(document, sparse.indices.bufferView, static_cast<std::uint64_t>(sparse.indices.byteOffset), count,
             size_of(sparse.indices.componentType), here + "/indices");
  if (!indices) return indices.error();
  const auto values = locate(document, sparse.values.bufferView, static_cast<std::uint64_t>(sparse.values.byteOffset),
                             count, size, here + "/values");
  if (!values) return values.error();
  if (auto spent = spend(document, count * elements.components, pointer); !spent) return spent;
  elements.sparse = copy_indices(*indices, count, sparse.indices.componentType);
  for (std::size_t i = 0; i < count; ++i) {
    if (elements.sparse[i] >= elements.count || (i > 0 && elements.sparse[i] <= elements.sparse[i - 1])) {
      return wrong_accessor("sparse index " + std::to_string(i) + " (" + std::to_string(elements.sparse[i]) +
                                ") is out of range or out of order",
                            here + "/indices");
    }
  }
  copy_run(*values, count, elements.components, accessor.componentType, accessor.normalized, elements.sparse_values);
  return base::Done{};
}

const char* type_name(int type) {
  switch (type) {
    case TINYGLTF_TYPE_SCALAR:
      return "SCALAR";
    case TINYGLTF_TYPE_VEC3:
      return "VEC3";
    case TINYGLTF_TYPE_VEC4:
      return "VEC4";
    case TINYGLTF_TYPE_MAT4:
      return "MAT4";
    default:
      return "another type";
  }
}

}  // namespace

std::vector<float> Elements::dense() const {
  std::vector<float> all = base;
  all.resize(count * components, 0.0F);
  for (std::size_t i = 0; i < sparse.size(); ++i) {
    std::copy_n(sparse_values.begin() + static_cast<std::ptrdiff_t>(i * components), components,
                all.begin() + static_cast<std::ptrdiff_t>(sparse[i] * components));
  }
  return all;
}

std::string accessor_pointer(int accessor) { return "/accessors/" + std::to_string(accessor); }

base::Result<Elements> read_elements(GltfDocument& document, int index, const ElementRule& rule) {
  const tinygltf::Accessor& accessor = document.model.accessors[static_cast<std::size_t>(index)];
  const std::string pointer = accessor_pointer(index);
  if (accessor.type != rule.type) {
    return wrong_accessor(std::string(type_name(rule.type)) + " was expected", pointer + "/type");
  }
  const bool is_float = accessor.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT;
  const bool is_known = is_float || is_index_type(accessor.componentType) ||
                        accessor.componentType == TINYGLTF_COMPONENT_TYPE_BYTE ||
                        accessor.componentType == TINYGLTF_COMPONENT_TYPE_SHORT;
  if (!is_known || (rule.float_only && !is_float)) {
    return wrong_accessor("component type " + std::to_string(accessor.componentType) + " cannot be used here",
                          pointer + "/componentType");
  }
  Elements elements;
  elements.count = accessor.count;
  elements.components =
      static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(rule.type)));
  if (rule.count && elements.count != *rule.count) {
    return wrong_accessor(
        std::to_string(elements.count) + " elements where " + std::to_string(*rule.count) + " were expected",
        pointer + "/count");
  }
  const bool is_zeros = accessor.bufferView < 0;
  if (!is_zeros || !rule.stays_sparse) {
    const std::uint64_t numbers = std::uint64_t{elements.count} * elements.components;
    if (auto spent = spend(document, numbers * (is_zeros ? k_cost_of_zeros : rule.cost), pointer); !spent) {
      return spent.error();
    }
  }
  if (accessor.bufferView >= 0) {
    const auto run = locate(document, accessor.bufferView, accessor.byteOffset, elements.count,
                            size_of(accessor.componentType) * elements.components, pointer);
    if (!run) return run.error();
    elements.has_base = true;
    copy_run(*run, elements.count, elements.components, accessor.componentType, accessor.normalized, elements.base);
  } else if (rule.needs_data && !accessor.sparse.isSparse) {
    return wrong_accessor("the accessor has no data", pointer);
  }
  if (accessor.sparse.isSparse) {
    if (const auto read = read_sparse(document, accessor, pointer, elements); !read) return read.error();
  }
  return elements;
}

base::Result<std::vector<std::uint32_t>> read_indices(GltfDocument& document, int index) {
  const tinygltf::Accessor& accessor = document.model.accessors[static_cast<std::size_t>(index)];
  const std::string pointer = accessor_pointer(index);
  if (accessor.type != TINYGLTF_TYPE_SCALAR) return wrong_accessor("SCALAR was expected", pointer + "/type");
  if (!is_index_type(accessor.componentType)) {
    return wrong_accessor("indices of a type that is no unsigned integer", pointer + "/componentType");
  }
  if (accessor.bufferView < 0 || accessor.sparse.isSparse) return wrong_accessor("indices without plain data", pointer);
  if (auto spent = spend(document, k_cost_of_geometry * accessor.count, pointer); !spent) return spent.error();
  const auto run = locate(document, accessor.bufferView, accessor.byteOffset, accessor.count,
                          size_of(accessor.componentType), pointer);
  if (!run) return run.error();
  return copy_indices(*run, accessor.count, accessor.componentType);
}

}  // namespace penpose::io
