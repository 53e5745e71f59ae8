#include "core/document/features/model_paint.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"
#include "core/document/look.h"
#include "core/picture/decode_picture.h"

namespace penpose::document {
namespace {

/// A face fills a good part of its texture; brows are still many px wide.
constexpr int k_most_px = 1024;

using Rgba = std::array<double, 4>;

/// Display value of a linear one (IEC 61966-2-1).
double displayed(double linear) {
  const double clamped = std::clamp(linear, 0.0, 1.0);
  return clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * base::pow(clamped, 1.0 / 2.4) - 0.055;
}

int wrapped(double at, int size, Wrap wrap) {
  const double share = at / size;
  const double whole = std::floor(share);
  if (wrap == Wrap::clamp) return std::clamp(static_cast<int>(std::clamp(share, 0.0, 1.0) * size), 0, size - 1);
  const int px = std::clamp(static_cast<int>((share - whole) * size), 0, size - 1);
  const bool mirrored = wrap == Wrap::mirror && std::fmod(std::abs(whole), 2.0) == 1.0;
  return mirrored ? size - 1 - px : px;
}

class ModelPaint {
 public:
  explicit ModelPaint(const Model& model) : mesh_(model.mesh), look_(model.look), pictures_(look_->images.size()) {}

  [[nodiscard]] Rgba at(const mesh::MeshPoint& point) {
    const Surface& surface = look_->surfaces[look_->surface_of[point.triangle]];
    const mesh::Triangle& corners = mesh_->triangles()[point.triangle];
    Rgba color{};
    for (std::size_t c = 0; c < 4; ++c) {
      double linear = surface.base_color[c];
      if (!look_->colors.empty()) {
        double mixed = 0;
        for (std::size_t k = 0; k < 3; ++k)
          mixed += point.barycentric[k] * static_cast<double>(look_->colors[corners[k]][c]);
        linear *= mixed;
      }
      color[c] = c == 3 ? std::clamp(linear, 0.0, 1.0) : displayed(linear);
    }
    if (surface.texture) {
      // Display values are multiplied in place of linear ones: a tint changes all of a face alike.
      const Rgba texel = of_texture(*surface.texture, point, corners);
      for (std::size_t c = 0; c < 4; ++c) color[c] *= texel[c];
    }
    if (surface.alpha == AlphaMode::opaque) color[3] = 1.0;
    if (surface.alpha == AlphaMode::mask) color[3] = color[3] < surface.alpha_cutoff ? 0.0 : 1.0;
    return color;
  }

 private:
  [[nodiscard]] Rgba of_texture(const TextureUse& use, const mesh::MeshPoint& point, const mesh::Triangle& corners) {
    const auto& coordinates = look_->coordinates[use.coordinates < 2 ? use.coordinates : 0];
    const picture::Image& image = picture(use.image);
    if (coordinates.empty() || image.width == 0) return {1, 1, 1, 1};
    double u = 0, v = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      u += point.barycentric[k] * static_cast<double>(coordinates[corners[k]][0]);
      v += point.barycentric[k] * static_cast<double>(coordinates[corners[k]][1]);
    }
    // KHR_texture_transform.
    const double sine = base::sin(use.rotation), cosine = base::cos(use.rotation);
    const double su = u * use.scale[0], sv = v * use.scale[1];
    const double x = (cosine * su + sine * sv + use.offset[0]) * image.width;
    const double y = (cosine * sv - sine * su + use.offset[1]) * image.height;
    if (!std::isfinite(x + y)) return {1, 1, 1, 1};
    const std::uint8_t* px = image.at(wrapped(x, image.width, use.wrap_u), wrapped(y, image.height, use.wrap_v));
    Rgba texel{};
    for (std::size_t c = 0; c < 4; ++c) texel[c] = px[c] / 255.0;
    return texel;
  }

  [[nodiscard]] const picture::Image& picture(std::size_t number) {
    static const picture::Image none;
    if (number >= pictures_.size()) return none;
    auto& kept = pictures_[number];
    if (!kept) {
      auto decoded = picture::decode_picture(look_->images[number].bytes.view(), k_most_px);
      kept = decoded ? std::move(*decoded) : picture::Image{};
    }
    return *kept;
  }

  std::shared_ptr<const mesh::TriangleMesh> mesh_;
  std::shared_ptr<const Look> look_;
  std::vector<std::optional<picture::Image>> pictures_;
};

}  // namespace

portrait::SurfacePaint paint_of(const Model& model) {
  const Look* look = model.look.get();
  if (!look || look->surface_of.size() != model.mesh->triangle_count()) return {};
  if (look->images.empty() && look->colors.empty()) return {};
  auto paint = std::make_shared<ModelPaint>(model);
  return [paint](const mesh::MeshPoint& point) { return paint->at(point); };
}

}  // namespace penpose::document
