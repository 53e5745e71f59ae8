#include "core/io/gltf/read/internal/look/gltf_surfaces.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/math.h"
#include "core/io/gltf/read/internal/look/lenient_json.h"

namespace penpose::io {
namespace {

using document::AlphaMode;
using document::Surface;
using document::TextureUse;
using document::Wrap;

/// A surface whose picture cannot be shown.
constexpr double k_grey = 0.6;

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

class Surfaces {
 public:
  Surfaces(const GltfDocument& document, GltfPictures& pictures) : document_(document), pictures_(pictures) {}

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
    return pictures_.refuse("a texture", "no picture that is known");
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
      pictures_.refuse(surface.name.empty() ? "a surface" : surface.name, "a third set of coordinates");
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
  GltfPictures& pictures_;
};

}  // namespace

Surface read_surface(const GltfDocument& document, std::size_t material, GltfPictures& pictures) {
  return Surfaces(document, pictures).read(material);
}

}  // namespace penpose::io
