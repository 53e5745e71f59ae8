#include "core/io/gltf/read/internal/look/gltf_look.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "core/base/math.h"
#include "core/base/text/utf8.h"
#include "core/io/gltf/read/internal/gltf_accessor.h"
#include "core/io/gltf/read/internal/look/picture_head.h"

namespace penpose::io {
namespace {

using document::AlphaMode;
using document::Surface;
using document::TextureUse;
using document::Wrap;

constexpr std::size_t k_most_surfaces = 60000;
/// Pictures of one model, together.
constexpr std::uint64_t k_most_picture_bytes = std::uint64_t{1} << 30;
/// A surface whose picture cannot be shown.
constexpr double k_grey = 0.6;
/// A picture of a few bytes may say that it is a huge one: px that are always taken, and px for each byte.
constexpr std::uint64_t k_always_px = 10'000'000;
constexpr std::uint64_t k_px_of_byte = 400;

const json::Json* member(const json::Json* object, const char* name) {
  return object == nullptr ? nullptr : json::find(*object, name);
}

const json::Json* item(const json::Json* list, std::size_t index) {
  return list == nullptr || !list->is_array() || index >= list->size() ? nullptr : &(*list)[index];
}

const json::Json* extension(const json::Json* object, const char* name) {
  return member(member(object, "extensions"), name);
}

std::optional<std::size_t> index_of(const json::Json* object, const char* name) {
  const json::Json* value = member(object, name);
  const auto whole = value == nullptr ? std::nullopt : json::whole_number(*value, 0, 0x7fffffff);
  return whole ? std::optional(static_cast<std::size_t>(*whole)) : std::nullopt;
}

double number_of(const json::Json* object, const char* name, double otherwise) {
  const json::Json* value = member(object, name);
  const auto number = value == nullptr ? std::nullopt : json::number(*value);
  return number ? *number : otherwise;
}

std::string text_of(const json::Json* object, const char* name) {
  const json::Json* value = member(object, name);
  return value != nullptr && value->is_string() ? base::valid_utf8(value->get_ref<const std::string&>())
                                                : std::string();
}

template <std::size_t n>
std::array<double, n> numbers_of(const json::Json* object, const char* name, std::array<double, n> otherwise) {
  const json::Json* value = member(object, name);
  if (value == nullptr || !value->is_array()) return otherwise;
  for (std::size_t i = 0; i < n && i < value->size(); ++i) {
    if (const auto number = json::number((*value)[i])) otherwise[i] = *number;
  }
  return otherwise;
}

/// Colours are 0..1; a hostile one must not reach the picture.
std::array<double, 4> clamped(std::array<double, 4> color) {
  for (double& c : color) c = std::clamp(c, 0.0, 1.0);
  return color;
}

/// IEC 61966-2-1.
double linear_of_srgb(double c) { return c <= 0.04045 ? c / 12.92 : base::pow((c + 0.055) / 1.055, 2.4); }

Wrap wrap_of(const json::Json* sampler, const char* name) {
  const double mode = number_of(sampler, name, 10497);
  return mode == 33071 ? Wrap::clamp : mode == 33648 ? Wrap::mirror : Wrap::repeat;
}

/// Pictures as surfaces ask for them; each is taken from the file once.
class Pictures {
 public:
  Pictures(GltfDocument& document, const FileResolver& resolve, document::Look& look)
      : document_(document), resolve_(resolve), look_(look) {}

  /// The number in Look::images of an image of the file; nothing where it cannot be shown.
  std::optional<std::size_t> find(std::size_t index) {
    const json::Json* images = member(&document_.json, "images");
    const json::Json* image = item(images, index);
    if (image == nullptr) return refuse("image " + std::to_string(index), "is not in the file");
    if (known_.empty()) known_.resize(images->size(), k_unknown);
    if (known_[index] == k_unknown) {
      const auto taken = take(*image, index);
      known_[index] = taken ? *taken : k_refused;
    }
    return known_[index] == k_refused ? std::nullopt : std::optional(known_[index]);
  }

  /// One line on all that cannot be shown.
  void add_note() const {
    if (refused_ == 0) return;
    const std::string more = refused_ > 1 ? ", and " + std::to_string(refused_ - 1) + " more" : "";
    document_.notes.push_back("shown grey: " + first_refused_ + more);
  }

  std::optional<std::size_t> refuse(const std::string& name, const std::string& why) {
    if (refused_++ == 0) first_refused_ = name + " " + why;
    return std::nullopt;
  }

 private:
  static constexpr std::size_t k_unknown = static_cast<std::size_t>(-1);
  static constexpr std::size_t k_refused = static_cast<std::size_t>(-2);

  base::Result<std::vector<std::uint8_t>> bytes_of(const json::Json& image, std::size_t index) const {
    const std::string pointer = json::child("/images", index);
    if (const auto view_index = index_of(&image, "bufferView")) {
      const auto& views = document_.model.bufferViews;
      if (*view_index >= views.size()) return base::Error{"has a buffer view that does not exist", pointer, ""};
      const tinygltf::BufferView& view = views[*view_index];
      const base::Bytes buffer = document_.buffers[static_cast<std::size_t>(view.buffer)];
      if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset)
        return base::Error{"reaches past the end of its buffer", pointer, ""};
      const base::Bytes bytes = buffer.subspan(view.byteOffset, view.byteLength);
      return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
    }
    const json::Json* uri = json::find(image, "uri");
    if (uri == nullptr || !uri->is_string()) return base::Error{"has no data", pointer, ""};
    auto read = read_uri(uri->get_ref<const std::string&>(), json::child(pointer, "uri"), resolve_);
    if (read) return read;
    const bool outer = !uri->get_ref<const std::string&>().starts_with("data:");
    return base::Error{outer ? "is another file that cannot be read" : "is a data: URI that cannot be read", pointer,
                       ""};
  }

  std::optional<std::size_t> take(const json::Json& image, std::size_t index) {
    std::string name = text_of(&image, "name");
    const std::string uri = text_of(&image, "uri");
    if (name.empty() && !uri.starts_with("data:")) name = uri;
    const std::string called = "image " + std::to_string(index) + (name.empty() ? "" : " \"" + name + "\"");
    auto bytes = bytes_of(image, index);
    if (!bytes) return refuse(called, bytes.error().what);
    const auto head = read_picture_head(*bytes);
    if (!head) return refuse(called, "is no PNG, JPEG or WebP picture");
    if (head->mime_type == "image/ktx2")
      return refuse(called, "is a KTX2 picture; export textures as PNG, JPEG or WebP to see it");
    if (!head->whole) return refuse(called, "is cut off");
    const std::uint64_t px = std::uint64_t{head->width} * head->height;
    if (px == 0 || px > k_most_picture_px || px > k_always_px + k_px_of_byte * bytes->size())
      return refuse(called, "is " + std::to_string(head->width) + " x " + std::to_string(head->height) +
                                " px, which is too large to be shown");
    if (held_ + bytes->size() > k_most_picture_bytes) return refuse(called, "is more than fits");
    held_ += bytes->size();
    look_.images.push_back({std::move(name), head->mime_type,
                            std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes).value()), head->width,
                            head->height});
    return look_.images.size() - 1;
  }

  GltfDocument& document_;
  const FileResolver& resolve_;
  document::Look& look_;
  std::vector<std::size_t> known_;
  std::uint64_t held_ = 0;
  std::size_t refused_ = 0;
  std::string first_refused_;
};

class Surfaces {
 public:
  Surfaces(const GltfDocument& document, Pictures& pictures) : document_(document), pictures_(pictures) {}

  /// The surface of a material of the file.
  Surface read(std::size_t index) {
    const json::Json* material = item(member(&document_.json, "materials"), index);
    Surface surface;
    surface.name = text_of(material, "name");
    surface.double_sided = is_true(material, "doubleSided");
    surface.unlit = extension(material, "KHR_materials_unlit") != nullptr;
    const std::string alpha = text_of(material, "alphaMode");
    surface.alpha = alpha == "MASK" ? AlphaMode::mask : alpha == "BLEND" ? AlphaMode::blend : AlphaMode::opaque;
    surface.alpha_cutoff = number_of(material, "alphaCutoff", 0.5);
    const json::Json* base = member(material, "pbrMetallicRoughness");
    const char* factor = "baseColorFactor";
    const char* texture = "baseColorTexture";
    if (const json::Json* glossy = extension(material, "KHR_materials_pbrSpecularGlossiness")) {
      base = glossy;
      factor = "diffuseFactor";
      texture = "diffuseTexture";
    }
    surface.base_color = clamped(numbers_of<4>(base, factor, {1, 1, 1, 1}));
    const json::Json* info = member(base, texture);
    if (info != nullptr) set_texture(*info, surface);
    const json::Json* properties = member(extension(&document_.json, "VRM"), "materialProperties");
    if (const json::Json* own = item(properties, index)) read_vrm0(*own, surface);
    if (!std::isfinite(surface.alpha_cutoff)) surface.alpha_cutoff = 0.5;
    return surface;
  }

 private:
  static bool is_true(const json::Json* object, const char* name) {
    const json::Json* value = member(object, name);
    return value != nullptr && value->is_boolean() && value->get<bool>();
  }

  std::optional<std::size_t> image_of(const json::Json& texture) {
    // The first that can be shown: WebP, the plain one, then KTX2, which says why it cannot.
    const json::Json* webp = extension(&texture, "EXT_texture_webp");
    if (const auto source = index_of(webp, "source")) return pictures_.find(*source);
    if (const auto source = index_of(&texture, "source")) return pictures_.find(*source);
    if (const auto source = index_of(extension(&texture, "KHR_texture_basisu"), "source"))
      return pictures_.find(*source);
    return pictures_.refuse("a texture", "has no picture that is known");
  }

  /// The texture of that number, as its sampler has it; nothing: it cannot be shown.
  std::optional<TextureUse> texture_of(std::size_t index) {
    const json::Json* texture = item(member(&document_.json, "textures"), index);
    if (texture == nullptr) return std::nullopt;
    const auto image = image_of(*texture);
    if (!image) return std::nullopt;
    TextureUse use;
    use.image = *image;
    if (const auto number = index_of(texture, "sampler")) {
      const json::Json* sampler = item(member(&document_.json, "samplers"), *number);
      use.wrap_u = wrap_of(sampler, "wrapS");
      use.wrap_v = wrap_of(sampler, "wrapT");
      use.nearest = number_of(sampler, "magFilter", 9729) == 9728;
    }
    return use;
  }

  static void set_grey(Surface& surface) {
    for (std::size_t i = 0; i < 3; ++i) surface.base_color[i] *= k_grey;
    surface.alpha = AlphaMode::opaque;
    surface.texture.reset();
  }

  void set_texture(const json::Json& info, Surface& surface) {
    const auto index = index_of(&info, "index");
    auto use = index ? texture_of(*index) : std::nullopt;
    if (!use) return set_grey(surface);
    auto set = index_of(&info, "texCoord");
    if (const json::Json* transform = extension(&info, "KHR_texture_transform")) {
      use->offset = numbers_of<2>(transform, "offset", {0, 0});
      use->scale = numbers_of<2>(transform, "scale", {1, 1});
      use->rotation = number_of(transform, "rotation", 0);
      if (const auto other = index_of(transform, "texCoord")) set = other;
    }
    use->coordinates = set.value_or(0);
    if (use->coordinates > 1) {
      pictures_.refuse("a surface", "whose texture lies by a third set of coordinates");
      return set_grey(surface);
    }
    surface.texture = *use;
  }

  /// Materials of VRM 0.x stand beside glTF's and are what its programs show: MToon and Unity's unlit ones.
  void read_vrm0(const json::Json& own, Surface& surface) {
    const std::string shader = text_of(&own, "shader");
    const bool unlit = shader.starts_with("VRM/Unlit");
    if (!unlit && shader != "VRM/MToon") return;
    surface.unlit = unlit;
    const json::Json* numbers = member(&own, "floatProperties");
    const json::Json* vectors = member(&own, "vectorProperties");
    // 0 opaque, 1 cut out, 2 and 3 translucent.
    double mode = number_of(numbers, "_BlendMode", 0);
    if (unlit) mode = shader == "VRM/UnlitCutout" ? 1 : shader.starts_with("VRM/UnlitTransparent") ? 2 : 0;
    surface.alpha = mode == 1 ? AlphaMode::mask : mode >= 2 ? AlphaMode::blend : AlphaMode::opaque;
    surface.alpha_cutoff = number_of(numbers, "_Cutoff", surface.alpha_cutoff);
    if (member(numbers, "_CullMode") != nullptr) surface.double_sided = number_of(numbers, "_CullMode", 2) == 0;
    // Unity keeps colours as they are shown, not as light.
    if (member(vectors, "_Color") != nullptr) {
      surface.base_color = clamped(numbers_of<4>(vectors, "_Color", {1, 1, 1, 1}));
      for (std::size_t i = 0; i < 3; ++i) surface.base_color[i] = linear_of_srgb(surface.base_color[i]);
    }
    const auto index = index_of(member(&own, "textureProperties"), "_MainTex");
    if (!index) return;
    auto use = texture_of(*index);
    if (!use) return set_grey(surface);
    // Offset and scale of Unity, whose v counts from the foot.
    const auto st = numbers_of<4>(vectors, "_MainTex", {0, 0, 1, 1});
    use->offset = {st[0], 1 - st[3] - st[1]};
    use->scale = {st[2], st[3]};
    surface.texture = *use;
  }

  const GltfDocument& document_;
  Pictures& pictures_;
};

/// Which nodes turn what hangs on them inside out: an odd number of scales below zero on the way to the root.
std::vector<bool> inverting_nodes(const GltfDocument& document) {
  const auto& nodes = document.model.nodes;
  std::vector<std::size_t> parent(nodes.size(), nodes.size());
  std::vector<bool> own(nodes.size(), false);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    for (const int child : nodes[n].children) parent[static_cast<std::size_t>(child)] = n;
    const auto transform = node_transform(document, n);
    own[n] = transform && transform->scale.x * transform->scale.y * transform->scale.z < 0;
  }
  // Nodes are few where one scales below zero, and the way up is short: a file of 64 levels at most is usual.
  std::vector<bool> inverting(nodes.size(), false);
  if (std::none_of(own.begin(), own.end(), [](bool is) { return is; })) return inverting;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    constexpr int k_most_levels = 256;
    bool odd = false;
    std::size_t at = n;
    for (int level = 0; at != nodes.size() && level < k_most_levels; ++level, at = parent[at]) odd = odd != own[at];
    inverting[n] = odd;
  }
  return inverting;
}

std::size_t surface_of_material(int material) {
  return material < 0 ? 0 : std::min(static_cast<std::size_t>(material) + 1, k_most_surfaces);
}

/// Triangles that a primitive of the vetted structure has.
std::size_t triangles_of(const GltfDocument& document, const tinygltf::Primitive& primitive, std::size_t vertex_count) {
  const std::size_t corners = primitive.indices < 0
                                  ? vertex_count
                                  : document.model.accessors[static_cast<std::size_t>(primitive.indices)].count;
  return primitive.mode == TINYGLTF_MODE_TRIANGLES ? corners / 3 : corners < 3 ? 0 : corners - 2;
}

/// Fills surface_of; tells which surfaces are seen, and whether a part has several.
bool set_surfaces(const GltfDocument& document, const GltfMeshes& meshes, document::Look& look,
                  std::set<std::size_t>& seen) {
  bool several = false;
  const auto& triangles = meshes.source.triangles;
  look.surface_of.reserve(triangles.size());
  for (std::size_t i = 0; i < meshes.origins.size(); ++i) {
    const PartOrigin& origin = meshes.origins[i];
    const mesh::Part& part = meshes.source.parts[i];
    std::size_t at = part.first_triangle;
    const std::size_t end = at + part.triangle_count;
    const std::size_t first = surface_of_material(origin.primitive(document).material);
    for (const std::size_t p : origin.primitives) {
      const auto& primitive = document.model.meshes[origin.mesh].primitives[p];
      const std::size_t surface = surface_of_material(primitive.material);
      several = several || surface != first;
      seen.insert(surface);
      const std::size_t stop = std::min(end, at + triangles_of(document, primitive, part.vertex_count));
      for (; at < stop; ++at) {
        const mesh::Triangle& t = triangles[at];
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
          look.surface_of.push_back(static_cast<std::uint32_t>(surface));
      }
    }
  }
  return several;
}

/// Reads an attribute of all parts that have it, `n` numbers a vertex; what a part lacks is `otherwise`.
template <std::size_t n>
void read_attribute(GltfDocument& document, const GltfMeshes& meshes, const char* name,
                    const std::array<float, n>& otherwise, std::vector<std::array<float, n>>& values) {
  for (std::size_t i = 0; i < meshes.origins.size(); ++i) {
    const auto& attributes = meshes.origins[i].primitive(document).attributes;
    const auto found = attributes.find(name);
    if (found == attributes.end()) continue;
    const mesh::Part& part = meshes.source.parts[i];
    ElementRule rule{.type = n == 2 ? TINYGLTF_TYPE_VEC2 : TINYGLTF_TYPE_VEC4, .count = part.vertex_count};
    const int type = document.model.accessors[static_cast<std::size_t>(found->second)].type;
    if (n == 4 && type == TINYGLTF_TYPE_VEC3) rule.type = type;
    const auto elements = read_elements(document, found->second, rule);
    if (!elements) {
      document.notes.push_back(std::string(name) + " is not shown: " + elements.error().what);
      return values.clear();
    }
    if (values.empty()) values.assign(meshes.source.positions.size(), otherwise);
    const std::vector<float> numbers = elements->dense();
    const std::size_t width = elements->components;
    for (std::size_t v = 0; v < elements->count; ++v) {
      for (std::size_t c = 0; c < std::min(width, n); ++c) {
        const float number = numbers[v * width + c];
        if (std::isfinite(number)) values[part.first_vertex + v][c] = number;
      }
    }
  }
}

}  // namespace

std::shared_ptr<const document::Look> read_look(GltfDocument& document, const GltfMeshes& meshes,
                                                const FileResolver& resolve) {
  auto look = std::make_shared<document::Look>();
  std::set<std::size_t> seen;
  const bool several = set_surfaces(document, meshes, *look, seen);
  look->surfaces.resize(*seen.rbegin() + 1);
  look->surfaces.front().base_color = {0.8, 0.8, 0.8, 1};
  std::set<std::size_t> inside_out;
  const std::vector<bool> inverting = inverting_nodes(document);
  for (const PartOrigin& origin : meshes.origins) {
    if (!inverting[origin.node] || document.model.nodes[origin.node].skin >= 0) continue;
    for (const std::size_t p : origin.primitives)
      inside_out.insert(surface_of_material(document.model.meshes[origin.mesh].primitives[p].material));
  }
  Pictures pictures(document, resolve, *look);
  Surfaces surfaces(document, pictures);
  bool textured = false;
  bool unlit = false;
  std::array<bool, 2> sets{};
  for (const std::size_t s : seen) {
    if (s == 0) continue;
    Surface& surface = look->surfaces[s];
    surface = surfaces.read(s - 1);
    surface.double_sided = surface.double_sided || inside_out.contains(s);
    textured = textured || surface.texture;
    unlit = unlit || surface.unlit;
    if (surface.texture) sets[surface.texture->coordinates] = true;
  }
  pictures.add_note();
  // What is only shown takes nothing from what the rest of the file may unfold to.
  const std::size_t budget = std::exchange(document.budget, document.budget / 4);
  for (const std::size_t set : {0U, 1U}) {
    const char* name = set == 0 ? "TEXCOORD_0" : "TEXCOORD_1";
    if (sets[set]) read_attribute<2>(document, meshes, name, {0, 0}, look->coordinates[set]);
  }
  read_attribute<4>(document, meshes, "COLOR_0", {1, 1, 1, 1}, look->colors);
  document.budget = budget;
  const bool white = std::all_of(look->colors.begin(), look->colors.end(), [](const auto& c) {
    return c == std::array<float, 4>{1, 1, 1, 1};
  });
  if (white) look->colors.clear();
  if (!textured && !several && !unlit && look->colors.empty()) return nullptr;
  return look;
}

std::shared_ptr<const document::Look> fitting_look(std::shared_ptr<const document::Look> look,
                                                   const mesh::TriangleMesh& mesh, std::vector<std::string>& notes) {
  if (!look) return look;
  const auto fits = [&](std::size_t size) { return size == 0 || size == mesh.vertex_count(); };
  if (look->surface_of.size() == mesh.triangle_count() && fits(look->coordinates[0].size()) &&
      fits(look->coordinates[1].size()) && fits(look->colors.size()))
    return look;
  notes.emplace_back("textures are not shown: the surface was cut");
  return nullptr;
}

}  // namespace penpose::io
