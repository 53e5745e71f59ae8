#include "core/io/gltf/write/internal/gltf_builder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <new>
#include <string_view>

#include "core/base/byte_reader.h"

namespace penpose::io {
namespace {

std::size_t components_of(std::string_view type) {
  if (type == "VEC3") return 3;
  if (type == "VEC4") return 4;
  return type == "MAT4" ? 16 : 1;
}

constexpr int k_byte = 5121;
constexpr int k_short = 5123;
constexpr int k_int = 5125;
constexpr int k_float = 5126;

void set_bounds(json::Json& accessor, std::span<const float> numbers, std::size_t components, bool with_zero) {
  std::vector<float> low(components, with_zero ? 0.0F : numbers[0]);
  std::vector<float> high = low;
  if (!with_zero) {
    std::copy_n(numbers.begin(), components, low.begin());
    high = low;
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    low[i % components] = std::min(low[i % components], numbers[i]);
    high[i % components] = std::max(high[i % components], numbers[i]);
  }
  accessor["min"] = std::vector<double>(low.begin(), low.end());
  accessor["max"] = std::vector<double>(high.begin(), high.end());
}

}  // namespace

std::size_t GltfBuilder::add(const char* array, json::Json object) {
  json::Json& list = root[array];
  list.push_back(std::move(object));
  return list.size() - 1;
}

std::size_t GltfBuilder::add_view(std::size_t start, BufferUse use) {
  json::Json view = {{"buffer", buffer_}, {"byteOffset", start_ + start}, {"byteLength", binary_.size() - start}};
  if (use == BufferUse::vertices) view["target"] = 34962;
  if (use == BufferUse::indices) view["target"] = 34963;
  binary_.align(4);
  return add("bufferViews", std::move(view));
}

std::size_t GltfBuilder::write_floats(std::span<const float> numbers, BufferUse use) {
  const std::size_t start = binary_.size();
  for (const float n : numbers) binary_.write_f32(n);
  return add_view(start, use);
}

std::optional<std::size_t> GltfBuilder::known_floats(std::span<const float> numbers, const char* type,
                                                     bool bounds) const {
  const json::Json* accessors = known_.empty() ? nullptr : json::find(root, "accessors");
  const json::Json* views = json::find(root, "bufferViews");
  if (accessors == nullptr || views == nullptr || numbers.empty()) return std::nullopt;
  const std::size_t length = numbers.size() * 4;
  const json::Json wanted = {
      {"componentType", k_float}, {"count", numbers.size() / components_of(type)}, {"type", type}};
  for (std::size_t i = 0; i < accessors->size(); ++i) {
    json::Json accessor = (*accessors)[i];
    const json::Json* named = json::find(accessor, "bufferView");
    const auto view_number =
        named == nullptr ? std::nullopt : json::whole_number(*named, 0, static_cast<std::int64_t>(views->size()) - 1);
    if (!view_number || (bounds && json::find(accessor, "min") == nullptr)) continue;
    for (const char* name : {"bufferView", "min", "max"}) accessor.erase(name);
    if (accessor != wanted) continue;
    json::Json view = (*views)[static_cast<std::size_t>(*view_number)];
    const json::Json* from = json::find(view, "byteOffset");
    const auto offset = from == nullptr ? std::optional<std::int64_t>(0)
                                        : json::whole_number(*from, 0, static_cast<std::int64_t>(known_.size()));
    view.erase("byteOffset");
    if (!offset || view != json::Json{{"buffer", buffer_}, {"byteLength", length}}) continue;
    const auto first = static_cast<std::size_t>(*offset);
    if (first > known_.size() || length > known_.size() - first) continue;
    base::ByteReader reader(known_.subspan(first, length));
    const bool same = std::all_of(numbers.begin(), numbers.end(), [&](float number) {
      return std::bit_cast<std::uint32_t>(*reader.read_f32()) == std::bit_cast<std::uint32_t>(number);
    });
    if (same) return i;
  }
  return std::nullopt;
}

std::size_t GltfBuilder::add_floats(std::span<const float> numbers, const char* type, BufferUse use, bool bounds) {
  if (use == BufferUse::plain) {
    if (const auto known = known_floats(numbers, type, bounds)) return *known;
  }
  const std::size_t components = components_of(type);
  json::Json accessor = {{"bufferView", write_floats(numbers, use)},
                         {"componentType", k_float},
                         {"count", numbers.size() / components},
                         {"type", type}};
  if (bounds) set_bounds(accessor, numbers, components, false);
  return add("accessors", std::move(accessor));
}

std::size_t GltfBuilder::add_indices(std::span<const std::uint32_t> indices) {
  // 65535 would restart the primitive.
  const bool is_short = *std::max_element(indices.begin(), indices.end()) < 0xffff;
  const std::size_t start = binary_.size();
  for (const std::uint32_t i : indices) {
    if (is_short) {
      binary_.write(static_cast<std::uint16_t>(i));
    } else {
      binary_.write(i);
    }
  }
  return add("accessors", {{"bufferView", add_view(start, BufferUse::indices)},
                           {"componentType", is_short ? k_short : k_int},
                           {"count", indices.size()},
                           {"type", "SCALAR"}});
}

std::size_t GltfBuilder::add_joints(std::span<const std::uint32_t> joints) {
  const bool is_byte = *std::max_element(joints.begin(), joints.end()) <= 0xff;
  const std::size_t start = binary_.size();
  for (const std::uint32_t j : joints) {
    if (is_byte) {
      binary_.write(static_cast<std::uint8_t>(j));
    } else {
      binary_.write(static_cast<std::uint16_t>(j));
    }
  }
  return add("accessors", {{"bufferView", add_view(start, BufferUse::vertices)},
                           {"componentType", is_byte ? k_byte : k_short},
                           {"count", joints.size() / 4},
                           {"type", "VEC4"}});
}

std::size_t GltfBuilder::add_displacements(std::size_t count, std::span<const std::uint32_t> elements,
                                           std::span<const float> values, bool keep_zeros, bool bounds) {
  json::Json accessor = {{"componentType", k_float}, {"count", count}, {"type", "VEC3"}};
  const std::size_t index_size = count <= 0xffff ? 2 : 4;
  const bool sparse = keep_zeros || elements.size() * (index_size + 12) < count * 12;
  if (elements.empty()) {
    // Neither a view nor sparse elements: all zero.
    if (bounds) accessor["min"] = accessor["max"] = {0.0, 0.0, 0.0};
  } else if (sparse) {
    const std::size_t start = binary_.size();
    for (const std::uint32_t i : elements) {
      if (index_size == 2) {
        binary_.write(static_cast<std::uint16_t>(i));
      } else {
        binary_.write(i);
      }
    }
    const std::size_t indices = add_view(start, BufferUse::plain);
    accessor["sparse"] = {{"count", elements.size()},
                          {"indices", {{"bufferView", indices}, {"componentType", index_size == 2 ? k_short : k_int}}},
                          {"values", {{"bufferView", write_floats(values, BufferUse::plain)}}}};
    if (bounds) set_bounds(accessor, values, 3, elements.size() < count);
  } else {
    std::vector<float> dense(count * 3, 0.0F);
    for (std::size_t i = 0; i < elements.size(); ++i) {
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(3 * i), 3,
                  dense.begin() + static_cast<std::ptrdiff_t>(3 * std::size_t{elements[i]}));
    }
    accessor["bufferView"] = write_floats(dense, BufferUse::vertices);
    if (bounds) set_bounds(accessor, dense, 3, false);
  }
  return add("accessors", std::move(accessor));
}

std::size_t GltfBuilder::add_bytes(base::Bytes bytes) {
  const std::size_t start = binary_.size();
  binary_.append(bytes);
  return add_view(start, BufferUse::plain);
}

std::size_t GltfBuilder::add_zeros(std::size_t count, const char* type, bool bounds) {
  json::Json accessor = {{"componentType", k_float}, {"count", count}, {"type", type}};
  if (bounds) accessor["min"] = accessor["max"] = std::vector<double>(components_of(type), 0.0);
  return add("accessors", std::move(accessor));
}

base::Result<std::vector<std::uint8_t>> GltfBuilder::finish() {
  if (binary_.size() > 0) root["buffers"] = json::Json::array({{{"byteLength", binary_.size()}}});
  auto text = text_of(root, TextOrder::by_name);
  if (!text) return text.error();
  const std::array<base::Bytes, 1> pieces{base::Bytes(binary_.bytes())};
  return pack_glb(std::move(text).value(), pieces);
}

base::Result<std::string> text_of(const json::Json& document, TextOrder order) {
  try {
    return order == TextOrder::as_made ? document.dump_as_made() : document.dump();
  } catch (const std::bad_alloc&) {
    throw;  // no fault of what is written
  } catch (const std::exception&) {
    return base::Error{"the document cannot be written as JSON", "", "rename parts with unusual names"};
  }
}

base::Result<std::vector<std::uint8_t>> pack_glb(std::string text, std::span<const base::Bytes> pieces) {
  while (text.size() % 4 != 0) text += ' ';
  std::uint64_t length = 0;
  for (const base::Bytes piece : pieces) length += piece.size();
  const std::uint64_t padding = (4 - length % 4) % 4;
  const std::uint64_t total = std::uint64_t{20} + text.size() + (length > 0 ? 8 + length + padding : 0);
  if (total > 0xffffffffULL) return base::Error{"the model is too large for a binary glTF file", "", "reduce it"};
  base::ByteWriter file;
  file.append("glTF");
  file.write(std::uint32_t{2});
  file.write(static_cast<std::uint32_t>(total));
  file.write(static_cast<std::uint32_t>(text.size()));
  file.append("JSON");
  file.append(text);
  if (length > 0) {
    file.write(static_cast<std::uint32_t>(length + padding));
    file.append(std::string_view("BIN\0", 4));
    for (const base::Bytes piece : pieces) file.append(piece);
    file.align(4);
  }
  return file.take();
}

}  // namespace penpose::io
