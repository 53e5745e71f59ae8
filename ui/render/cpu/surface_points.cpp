#include "ui/render/cpu/surface_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/render/cpu/mixing.h"

namespace penpose::render {
namespace {

float unit(std::uint8_t byte) { return static_cast<float>(byte) / 255.0F; }

float smoothstep(float from, float to, float x) {
  const float t = std::clamp((x - from) / (to - from), 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

glm::vec3 mixed(const glm::vec3& a, const glm::vec3& b, float t) { return a * (1.0F - t) + b * t; }

/// Pupil, iris with a dark rim and a lighter ring, then the white (k_mesh_fragment in ui/render/gl/shaders.h).
/// `d`: distance from the gaze axis in radii of the eyeball; `per_px`: how much it changes by a px.
glm::vec3 eye_color(const glm::vec3& white, float d, float per_px) {
  const float w = std::max(per_px, 0.004F);
  const glm::vec3 iris =
      mixed(glm::vec3(0.17F, 0.10F, 0.045F), glm::vec3(0.05F, 0.032F, 0.02F), smoothstep(0.30F, 0.46F, d));
  const glm::vec3 color = mixed(white, iris, 1.0F - smoothstep(0.46F - w - 0.015F, 0.46F + w + 0.015F, d));
  return mixed(color, glm::vec3(0.006F), 1.0F - smoothstep(0.19F - w, 0.19F + w, d));
}

constexpr float k_polished_eye = 0.12F;
/// The inside of something is this dim.
constexpr float k_inside = 0.22F;

}  // namespace

SurfacePoints::Paint SurfacePoints::paint_of(std::uint32_t vertex) const {
  const VertexFinish& finish = paint_.finish[vertex];
  Paint paint;
  paint.albedo = {unit(finish[0][0]), unit(finish[0][1]), unit(finish[0][2])};
  paint.alpha = unit(finish[0][3]) * unit(finish[1][3]);
  paint.surface = {unit(finish[1][0]), unit(finish[1][1]), unit(finish[1][2])};
  if (!paint_.overlay.empty()) {
    const Bytes4& over = paint_.overlay[vertex];
    const float alpha = unit(over[3]);
    paint.albedo = mixed(paint.albedo, glm::vec3(unit(over[0]), unit(over[1]), unit(over[2])), alpha);
    if (alpha > 0.5F) paint.surface.z = 1.0F;
  }
  return paint;
}

void SurfacePoints::choose(std::uint32_t item) {
  if (item == item_) return;
  item_ = item;
  piece_ = (item & DrawItems::k_piece) != 0 ? &items_.piece(item) : nullptr;
  const std::uint32_t number = piece_ != nullptr ? piece_->item : item;
  const bool same_segment = segment_ != nullptr && number >= segment_->first_item &&
                            number - segment_->first_item < segment_->triangles.size();
  if (!same_segment) segment_ = &items_.segment_of(number);
  triangle_ = segment_->triangles[number - segment_->first_item];
  corners_ = piece_ != nullptr ? piece_->corners
                               : Corners{vertices_[triangle_[0]].corner, vertices_[triangle_[1]].corner,
                                         vertices_[triangle_[2]].corner};
  area_ = twice_area(corners_);
  // Fronts run against the clock; what is drawn runs with it.
  front_ = area_ < 0;
  turned_ = area_ < 0;
  if (turned_) {
    std::swap(corners_[1], corners_[2]);
    area_ = -area_;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner& p = corners_[(k + 1) % 3];
    const Corner& q = corners_[(k + 2) % 3];
    const std::int64_t dx = q.x - p.x;
    const std::int64_t dy = q.y - p.y;
    constexpr std::int64_t k_half = k_subpixels / 2;
    edges_[k] = {dx * (k_half - p.y) - dy * (k_half - p.x), -dy * k_subpixels, dx * k_subpixels};
  }
  if (segment_->surface != nullptr) return;
  const auto same = [&](std::size_t a, std::size_t b) {
    const std::uint32_t u = triangle_[a];
    const std::uint32_t v = triangle_[b];
    return paint_.finish[u] == paint_.finish[v] && (paint_.overlay.empty() || paint_.overlay[u] == paint_.overlay[v]);
  };
  plain_paint_ = same(0, 1) && same(0, 2);
  paints_[0] = paint_of(triangle_[0]);
  if (plain_paint_) return;
  paints_[1] = paint_of(triangle_[1]);
  paints_[2] = paint_of(triangle_[2]);
}

SurfacePoints::Shares SurfacePoints::unscaled_shares(int x, int y) const {
  std::array<float, 3> part{};
  for (std::size_t k = 0; k < 3; ++k) {
    const Edge& edge = edges_[k];
    part[k] = static_cast<float>(edge.at_origin + edge.by_x * x + edge.by_y * y) * corners_[k].inverse_depth;
  }
  if (turned_) std::swap(part[1], part[2]);
  if (piece_ == nullptr) return {part[0], part[1], part[2]};
  return piece_->shares[0] * part[0] + piece_->shares[1] * part[1] + piece_->shares[2] * part[2];
}

SurfacePoints::Shares SurfacePoints::shares(int x, int y) const {
  const Shares unscaled = unscaled_shares(x, y);
  return unscaled * (1.0F / (unscaled.x + unscaled.y + unscaled.z));
}

float SurfacePoints::add(int x, int y, Fragments& fragments) const {
  const int i = fragments.count;
  const auto at = static_cast<std::size_t>(i);
  const Shares s = unscaled_shares(x, y);
  const glm::vec3& a = vertices_[triangle_[0]].normal;
  const glm::vec3& b = vertices_[triangle_[1]].normal;
  const glm::vec3& c = vertices_[triangle_[2]].normal;
  const float sign = front_ ? 1.0F : -1.0F;
  fragments.normal_x[at] = (a.x * s.x + b.x * s.y + c.x * s.z) * sign;
  fragments.normal_y[at] = (a.y * s.x + b.y * s.y + c.y * s.z) * sign;
  fragments.normal_z[at] = (a.z * s.x + b.z * s.y + c.z * s.z) * sign;
  fragments.eye_x[at] = raster_.eye_x(static_cast<float>(x) + 0.5F);
  fragments.eye_y[at] = raster_.eye_y(static_cast<float>(y) + 0.5F);
  fragments.eye_z[at] = 1.0F;
  const float alpha = segment_->surface != nullptr ? add_of_look(x, y, fragments) : add_plain(x, y, s, fragments);
  ++fragments.count;
  return alpha;
}

float SurfacePoints::add_plain(int x, int y, const Shares& unscaled, Fragments& fragments) const {
  const auto at = static_cast<std::size_t>(fragments.count);
  Paint paint = paints_[0];
  Shares s{1, 0, 0};
  if (!plain_paint_) {
    s = unscaled * (1.0F / (unscaled.x + unscaled.y + unscaled.z));
    paint.albedo = paints_[0].albedo * s.x + paints_[1].albedo * s.y + paints_[2].albedo * s.z;
    paint.alpha = paints_[0].alpha * s.x + paints_[1].alpha * s.y + paints_[2].alpha * s.z;
    paint.surface = paints_[0].surface * s.x + paints_[1].surface * s.y + paints_[2].surface * s.z;
  }
  glm::vec3 base = paint.albedo * paint.albedo;
  float roughness = paint.surface.x;
  const float gaze = paint.surface.z;
  if (gaze < 0.999F) {
    float per_px = 0;
    if (!plain_paint_) {
      const auto gaze_at = [&](int px_x, int px_y) {
        const Shares there = shares(px_x, px_y);
        return paints_[0].surface.z * there.x + paints_[1].surface.z * there.y + paints_[2].surface.z * there.z;
      };
      per_px = std::abs(gaze_at(x + 1, y) - gaze) + std::abs(gaze_at(x, y + 1) - gaze);
    }
    base = eye_color(base, gaze, per_px);
    roughness = k_polished_eye;
  }
  fragments.red[at] = base.x;
  fragments.green[at] = base.y;
  fragments.blue[at] = base.z;
  fragments.roughness[at] = roughness;
  fragments.metallic[at] = paint.surface.y;
  fragments.open[at] = front_ ? 1.0F : k_inside;
  fragments.lit[at] = 1.0F;
  return paint.alpha;
}

glm::vec4 SurfacePoints::own_color(int x, int y) const {
  const Shares s = shares(x, y);
  const auto tint = [&](std::size_t k) {
    const Bytes4& t = paint_.tint[triangle_[k]];
    return glm::vec4(unit(t[0]) * unit(t[0]), unit(t[1]) * unit(t[1]), unit(t[2]) * unit(t[2]), unit(t[3]));
  };
  glm::vec4 color = tint(0) * s.x + tint(1) * s.y + tint(2) * s.z;
  const document::Surface& surface = *segment_->surface;
  const bool lost = surface.texture && segment_->texture == nullptr;  // its picture cannot be read: grey
  const float share = lost ? 0.6F : 1.0F;
  color.r *= static_cast<float>(surface.base_color[0]) * share;
  color.g *= static_cast<float>(surface.base_color[1]) * share;
  color.b *= static_cast<float>(surface.base_color[2]) * share;
  color.a *= lost ? 1.0F : static_cast<float>(surface.base_color[3]);
  if (segment_->texture == nullptr) return color;
  const document::TextureUse& use = *surface.texture;
  const auto& coordinates = paint_.look->coordinates[use.coordinates == 1 ? 1 : 0];
  const TextureTransform& place = segment_->place;
  const auto place_of = [&](const Shares& of) {
    glm::vec2 uv{0, 0};
    if (!coordinates.empty()) {
      for (int k = 0; k < 3; ++k) {
        const auto& c = coordinates[triangle_[static_cast<std::size_t>(k)]];
        uv += glm::vec2(c[0], c[1]) * of[k];
      }
    }
    return place.along_u * uv.x + place.along_v * uv.y + place.shift;
  };
  const glm::vec2 here = place_of(s);
  return color *
         segment_->texture->sample(use, here, place_of(shares(x + 1, y)) - here, place_of(shares(x, y + 1)) - here);
}

float SurfacePoints::add_of_look(int x, int y, Fragments& fragments) const {
  const auto at = static_cast<std::size_t>(fragments.count);
  const glm::vec4 own = own_color(x, y);
  glm::vec3 base(std::max(own.r, 0.0F), std::max(own.g, 0.0F), std::max(own.b, 0.0F));
  float over_alpha = 0;
  if (!paint_.overlay.empty()) {
    const Shares s = shares(x, y);
    glm::vec4 over(0);
    for (int k = 0; k < 3; ++k) {
      const Bytes4& one = paint_.overlay[triangle_[static_cast<std::size_t>(k)]];
      over += glm::vec4(unit(one[0]), unit(one[1]), unit(one[2]), unit(one[3])) * s[k];
    }
    over_alpha = over.a;
    const glm::vec3 root =
        mixed(glm::vec3(std::sqrt(base.x), std::sqrt(base.y), std::sqrt(base.z)), glm::vec3(over), over_alpha);
    base = root * root;
  }
  const document::Surface& surface = *segment_->surface;
  const bool lost = surface.texture && segment_->texture == nullptr;
  fragments.red[at] = base.x;
  fragments.green[at] = base.y;
  fragments.blue[at] = base.z;
  fragments.roughness[at] = segment_->roughness;
  fragments.metallic[at] = segment_->metallic;
  fragments.open[at] = 1.0F;
  fragments.lit[at] = surface.unlit && !lost && over_alpha < 0.01F ? 0.0F : 1.0F;
  return own.a;
}

}  // namespace penpose::render
