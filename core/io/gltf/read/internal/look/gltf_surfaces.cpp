#include "core/io/gltf/read/internal/look/gltf_surfaces.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/math.h"
#include "core/io/gltf/read/internal/look/lenient_json.h"

namespace penpose::io {
namespace {

using document::AlphaMode;
using document::OutlineWidth;
using document::Surface;
using document::TextureUse;
using document::Toon;
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
    if (const json::Json* toon = extension(material, "VRMC_materials_mtoon")) read_vrm1_toon(*toon, surface);
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

  /// Which coordinates a texture has, and how it lies there.
  static void place(const json::Json& info, TextureUse& use) {
    auto set = index_of(&info, "texCoord");
    if (const json::Json* transform = extension(&info, "KHR_texture_transform")) {
      use.offset = numbers_of<2>(transform, "offset", {0, 0});
      use.scale = numbers_of<2>(transform, "scale", {1, 1});
      use.rotation = number_of(transform, "rotation", 0);
      if (const auto other = index_of(transform, "texCoord")) set = other;
    }
    use.coordinates = set.value_or(0);
  }

  /// A texture that one can do without.
  std::optional<TextureUse> further_texture(const json::Json* info) {
    const auto index = index_of(info, "index");
    auto use = index ? texture_of(*index) : std::nullopt;
    if (!use) return std::nullopt;
    place(*info, *use);
    return use->coordinates > 1 ? std::nullopt : use;
  }

  static void set_grey(Surface& surface) {
    for (std::size_t i = 0; i < 3; ++i) surface.base_color[i] *= k_grey;
    surface.alpha = AlphaMode::opaque;
    surface.texture.reset();
    surface.toon.reset();
  }

  void set_texture(const json::Json& info, Surface& surface) {
    const auto index = index_of(&info, "index");
    auto use = index ? texture_of(*index) : std::nullopt;
    if (!use) return set_grey(surface);
    place(info, *use);
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
    surface.toon.reset();
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
    const json::Json* textures = member(&own, "textureProperties");
    // Offset and scale of Unity, whose v counts from the foot; all textures lie as the first one.
    const auto st = numbers_of<4>(vectors, "_MainTex", {0, 0, 1, 1});
    const auto unity_texture = [&](const char* name) -> std::optional<TextureUse> {
      const auto index = index_of(textures, name);
      auto use = index ? texture_of(*index) : std::nullopt;
      if (!use) return std::nullopt;
      use->offset = {st[0], 1 - st[3] - st[1]};
      use->scale = {st[2], st[3]};
      return use;
    };
    if (index_of(textures, "_MainTex")) {
      surface.texture = unity_texture("_MainTex");
      if (!surface.texture) return set_grey(surface);
    }
    if (unlit) return;
    surface.toon = vrm0_toon(numbers, vectors);
    surface.toon->shade_texture = unity_texture("_ShadeTexture");
    if (surface.toon->outline != OutlineWidth::none)
      surface.toon->outline_texture = unity_texture("_OutlineWidthTexture");
  }

  /// Numbers of MToon 0.x in the words of MToon 1.0, by its rules for such files.
  static Toon vrm0_toon(const json::Json* numbers, const json::Json* vectors) {
    Toon toon;
    const auto color_of = [&](const char* name, std::array<double, 4> otherwise) {
      const auto color = clamped(numbers_of<4>(vectors, name, otherwise));
      return std::array{linear_of_srgb(color[0]), linear_of_srgb(color[1]), linear_of_srgb(color[2])};
    };
    toon.shade_color = color_of("_ShadeColor", {0.97, 0.81, 0.86, 1});
    const double shift = bounded(numbers, "_ShadeShift", 0, -1, 1);
    const double toony = bounded(numbers, "_ShadeToony", 0.9, 0, 1);
    toon.toony = toony + (1 - toony) * (0.5 + 0.5 * shift);
    toon.shift = -shift - (1 - toon.toony);
    const double mode = number_of(numbers, "_OutlineWidthMode", 0);
    toon.outline = mode == 1 ? OutlineWidth::world : mode == 2 ? OutlineWidth::screen : OutlineWidth::none;
    // Centimetres; hundredths of half of the height.
    toon.outline_width = bounded(numbers, "_OutlineWidth", 0.5, 0, 10) * (mode == 2 ? 0.005 : 0.01);
    toon.outline_color = color_of("_OutlineColor", {0, 0, 0, 1});
    toon.outline_mix =
        number_of(numbers, "_OutlineColorMode", 0) == 1 ? bounded(numbers, "_OutlineLightingMix", 1, 0, 1) : 0;
    return toon;
  }

  static double bounded(const json::Json* object, const char* name, double otherwise, double least, double most) {
    const double value = number_of(object, name, otherwise);
    return std::isfinite(value) ? std::clamp(value, least, most) : otherwise;
  }

  static std::array<double, 3> color_of(const json::Json& own, const char* name, std::array<double, 3> otherwise) {
    auto color = numbers_of<3>(&own, name, otherwise);
    for (double& c : color) c = std::clamp(c, 0.0, 1.0);
    return color;
  }

  /// VRMC_materials_mtoon 1.0. Programs that do not know it show glTF's material, mostly unlit.
  void read_vrm1_toon(const json::Json& own, Surface& surface) {
    surface.unlit = false;
    Toon toon;
    toon.shade_color = color_of(own, "shadeColorFactor", {1, 1, 1});
    toon.shade_texture = further_texture(member(&own, "shadeMultiplyTexture"));
    toon.shift = bounded(&own, "shadingShiftFactor", 0, -1, 1);
    toon.toony = bounded(&own, "shadingToonyFactor", 0.9, 0, 1);
    const std::string mode = text_of(&own, "outlineWidthMode");
    toon.outline = mode == "worldCoordinates"    ? OutlineWidth::world
                   : mode == "screenCoordinates" ? OutlineWidth::screen
                                                 : OutlineWidth::none;
    toon.outline_width = bounded(&own, "outlineWidthFactor", 0, 0, 0.1);
    if (toon.outline != OutlineWidth::none)
      toon.outline_texture = further_texture(member(&own, "outlineWidthMultiplyTexture"));
    toon.outline_color = color_of(own, "outlineColorFactor", {0, 0, 0});
    toon.outline_mix = bounded(&own, "outlineLightingMixFactor", 1, 0, 1);
    surface.toon = toon;
  }

  const GltfDocument& document_;
  GltfPictures& pictures_;
};

}  // namespace

Surface read_surface(const GltfDocument& document, std::size_t material, GltfPictures& pictures) {
  return Surfaces(document, pictures).read(material);
}

}  // namespace penpose::io
