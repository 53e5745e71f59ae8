#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace penpose::document {

/// Bytes that stay as long as somebody has them: a vector, or some of what it holds.
class KeptBytes {
 public:
  using Owner = std::shared_ptr<const std::vector<std::uint8_t>>;

  KeptBytes() = default;
  KeptBytes(Owner owner) : owner_(std::move(owner)), view_(*owner_) {}
  /// `view` is of what `owner` holds.
  KeptBytes(Owner owner, std::span<const std::uint8_t> view) : owner_(std::move(owner)), view_(view) {}

  [[nodiscard]] std::span<const std::uint8_t> view() const { return view_; }

 private:
  Owner owner_;
  std::span<const std::uint8_t> view_;
};

/// A picture of a model's surface, encoded as it was in the file.
struct Image {
  std::string name;
  std::string mime_type;  ///< "image/png", "image/jpeg", "image/webp", "image/ktx2" or what the file says
  KeptBytes bytes;
  std::uint32_t width = 0, height = 0;  ///< px, as its head says; 0: not known
};

enum class Wrap : std::uint8_t { repeat, mirror, clamp };

/// How a picture lies on a surface: u, v of the file, scaled, turned and shifted as by KHR_texture_transform.
struct TextureUse {
  std::size_t image = 0;
  std::size_t coordinates = 0;  ///< which set of Look::coordinates
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  bool nearest = false;  ///< no filter when it is enlarged
  std::array<double, 2> offset{0, 0}, scale{1, 1};
  double rotation = 0;  ///< radians, counter-clockwise
};

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// In which measure an outline is wide: not at all, in model units, or in heights of the picture.
enum class OutlineWidth : std::uint8_t { none, world, screen };

/// A surface in two tones with a line around it, as in drawn films (MToon of VRM 0.x and VRM 1.0). Colours are linear
/// RGB, 0..1.
struct Toon {
  std::array<double, 3> shade_color{1, 1, 1};
  std::optional<TextureUse> shade_texture;  ///< multiplies the shade; a picture of the base colour does not
  double shift = 0;                         ///< where the tones meet, -1..1: above zero more of it is lit
  double toony = 0.9;                       ///< 0 a soft change between them .. 1 a sharp one
  OutlineWidth outline = OutlineWidth::none;
  double outline_width = 0;                     ///< in the measure of `outline`
  std::optional<TextureUse> outline_texture{};  ///< its green says how much of the width
  std::array<double, 3> outline_color{0, 0, 0};
  double outline_mix = 1;  ///< 0: the outline has its colour alone .. 1: times that of the surface
};

/// What some triangles look like. Colour is linear RGBA, 0..1.
struct Surface {
  std::string name;
  std::array<double, 4> base_color{1, 1, 1, 1};
  std::optional<TextureUse> texture;  ///< of the base colour
  AlphaMode alpha = AlphaMode::opaque;
  double alpha_cutoff = 0.5;  ///< of AlphaMode::mask
  bool double_sided = false;
  bool unlit = false;
  std::optional<Toon> toon{};  ///< in place of light
};

/// What a model looks like beyond its shape.
struct Look {
  std::vector<Image> images;
  std::vector<Surface> surfaces;
  std::vector<std::uint32_t> surface_of;                         ///< one a triangle of the mesh
  std::array<std::vector<std::array<float, 2>>, 2> coordinates;  ///< one a vertex of the mesh; empty: none
  std::vector<std::array<float, 4>> colors;                      ///< linear RGBA, one a vertex; empty: none
  std::vector<std::string> undrawn;                              ///< textures that cannot be drawn: "NAME (why)"
};

/// The one line that tells of textures which cannot be drawn, each "NAME (why)"; empty where there are none.
[[nodiscard]] std::string undrawn_note(std::span<const std::string> undrawn);

}  // namespace penpose::document
