#include "ui/render/cpu/shading/surface_points.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "ui/render/cpu/mixing.h"

namespace penpose::render {
namespace {

constexpr std::array<float, 256> k_units = [] {
  std::array<float, 256> made{};
  for (std::size_t i = 0; i < made.size(); ++i) made[i] = static_cast<float>(i) / 255.0F;
  return made;
}();

float unit(std::uint8_t byte) { return k_units[byte]; }

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

/// Px of a row that are taken at once, by GCC's and Clang's vectors.
constexpr int k_lanes = 4;
using Lanes = float __attribute__((vector_size(k_lanes * sizeof(float))));
using Wholes = std::int32_t __attribute__((vector_size(k_lanes * sizeof(std::int32_t))));
static_assert(k_lanes <= Fragments::k_beyond);

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

ScreenTriangle screen_triangle(std::uint32_t item, std::span<const ScreenVertex> vertices, const DrawItems& items,
                               const Segment* near) {
  ScreenTriangle made;
  made.piece = (item & DrawItems::k_piece) != 0 ? &items.piece(item) : nullptr;
  const std::uint32_t number = made.piece != nullptr ? made.piece->item : item;
  const bool has_it =
      near != nullptr && number >= near->first_item && number - near->first_item < near->triangles.size();
  made.segment = has_it ? near : &items.segment_of(number);
  made.vertices = made.segment->triangles[number - made.segment->first_item];
  made.corners = made.piece != nullptr ? made.piece->corners : corners_of(*made.segment, made.vertices, vertices);
  made.area = twice_area(made.corners);
  // Fronts run against the clock; what is drawn runs with it.
  made.front = made.area < 0;
  made.turned = made.front;
  if (made.turned) {
    std::swap(made.corners[1], made.corners[2]);
    made.area = -made.area;
  }
  return made;
}

void SurfacePoints::forget() {
  for (Prepared& one : recent_) one.item = k_none;
}

void SurfacePoints::prepare(std::uint32_t item) {
  prepare(item, screen_triangle(item, vertices_, items_, chosen_->triangle.segment));
}

void SurfacePoints::prepare(std::uint32_t item, const ScreenTriangle& triangle) {
  Prepared& p = *chosen_;
  p.item = item;
  p.triangle = triangle;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner& from = triangle.corners[(k + 1) % 3];
    const Corner& to = triangle.corners[(k + 2) % 3];
    const std::int64_t dx = to.x - from.x;
    const std::int64_t dy = to.y - from.y;
    constexpr std::int64_t k_half = k_subpixels / 2;
    const std::size_t vertex = triangle.turned && k > 0 ? 3 - k : k;
    p.edges[vertex] = {dx * (k_half - from.y) - dy * (k_half - from.x), -dy * k_subpixels, dx * k_subpixels};
    p.inverse_depths[vertex] = triangle.corners[k].inverse_depth;
  }
  p.even = false;
  if (triangle.segment->surface != nullptr) return;
  const auto same = [&](std::size_t a, std::size_t b) {
    const std::uint32_t u = triangle.vertices[a];
    const std::uint32_t v = triangle.vertices[b];
    return paint_.finish[u] == paint_.finish[v] && (paint_.overlay.empty() || paint_.overlay[u] == paint_.overlay[v]);
  };
  p.plain_paint = same(0, 1) && same(0, 2);
  p.paints[0] = paint_of(triangle.vertices[0]);
  p.base = p.paints[0].albedo * p.paints[0].albedo;
  p.even = p.plain_paint && p.paints[0].surface.z >= 0.999F && triangle.piece == nullptr &&
           internal::is_small(px_around(triangle.corners));
  if (p.plain_paint) return;
  p.paints[1] = paint_of(triangle.vertices[1]);
  p.paints[2] = paint_of(triangle.vertices[2]);
}

SurfacePoints::Shares SurfacePoints::unscaled_shares(int x, int y) const {
  const Prepared& p = *chosen_;
  const auto part = [&](std::size_t k) {
    const Edge& edge = p.edges[k];
    return static_cast<float>(edge.at_origin + edge.by_x * x + edge.by_y * y) * p.inverse_depths[k];
  };
  const Shares shares{part(0), part(1), part(2)};
  const Piece* piece = p.triangle.piece;
  if (piece == nullptr) return shares;
  return piece->shares[0] * shares.x + piece->shares[1] * shares.y + piece->shares[2] * shares.z;
}

SurfacePoints::Shares SurfacePoints::shares(int x, int y) const {
  const Shares unscaled = unscaled_shares(x, y);
  return unscaled * (1.0F / (unscaled.x + unscaled.y + unscaled.z));
}

float SurfacePoints::add(int x, int y, Fragments& fragments) const {
  const auto at = static_cast<std::size_t>(fragments.count);
  const ScreenTriangle& triangle = chosen_->triangle;
  const Shares s = unscaled_shares(x, y);
  const glm::vec3& a = vertices_[triangle.vertices[0]].normal;
  const glm::vec3& b = vertices_[triangle.vertices[1]].normal;
  const glm::vec3& c = vertices_[triangle.vertices[2]].normal;
  // Of any length, but its direction counts.
  const float sign = triangle.front || triangle.segment->outline ? 1.0F : -1.0F;
  fragments.normal_x[at] = (a.x * s.x + b.x * s.y + c.x * s.z) * sign;
  fragments.normal_y[at] = (a.y * s.x + b.y * s.y + c.y * s.z) * sign;
  fragments.normal_z[at] = (a.z * s.x + b.z * s.y + c.z * s.z) * sign;
  fragments.eye_x[at] = static_cast<float>(x) + 0.5F;
  fragments.eye_y[at] = static_cast<float>(y) + 0.5F;
  add_light(s, fragments);
  const float alpha =
      triangle.segment->surface != nullptr ? add_of_look(x, y, fragments) : add_plain(x, y, s, fragments);
  ++fragments.count;
  return alpha;
}

void SurfacePoints::add_light(const Shares& unscaled, Fragments& fragments) const {
  const auto at = static_cast<std::size_t>(fragments.count);
  fragments.sky[at] = 1.0F;
  fragments.coat[at] = 0.0F;
  fragments.tones[at].toon = nullptr;
  if (paint_.light.empty()) return;
  const Shares s = unscaled * (1.0F / (unscaled.x + unscaled.y + unscaled.z));
  const mesh::Triangle& corners = chosen_->triangle.vertices;
  const auto mixed_byte = [&](std::size_t byte) {
    return unit(paint_.light[corners[0]][byte]) * s.x + unit(paint_.light[corners[1]][byte]) * s.y +
           unit(paint_.light[corners[2]][byte]) * s.z;
  };
  fragments.sky[at] = mixed_byte(0);
  fragments.coat[at] = mixed_byte(1);
  if (fragments.coat[at] > 0) fragments.some_coat = true;
}

void SurfacePoints::add_run(int x, int y, int count, Fragments& fragments) const {
  const Prepared& p = *chosen_;
  const ScreenTriangle& triangle = p.triangle;
  if (!p.even) {
    for (int i = 0; i < count; ++i) add(x + i, y, fragments);
    return;
  }
  const float sign = triangle.front ? 1.0F : -1.0F;
  std::array<Wholes, 3> edge{};
  std::array<Wholes, 3> step{};
  constexpr Wholes k_lane_numbers{0, 1, 2, 3};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto by_x = static_cast<std::int32_t>(p.edges[k].by_x);
    edge[k] = static_cast<std::int32_t>(p.edges[k].at_origin + p.edges[k].by_x * x + p.edges[k].by_y * y) +
              k_lane_numbers * by_x;
    step[k] = Wholes{} + by_x * k_lanes;
  }
  const glm::vec3& a = vertices_[triangle.vertices[0]].normal;
  const glm::vec3& b = vertices_[triangle.vertices[1]].normal;
  const glm::vec3& c = vertices_[triangle.vertices[2]].normal;
  const float eye_y = static_cast<float>(y) + 0.5F;
  const float open = triangle.front ? 1.0F : k_inside;
  const bool shaded = !paint_.light.empty();
  std::array<float, 3> skies{1, 1, 1};
  for (std::size_t k = 0; shaded && k < 3; ++k) skies[k] = unit(paint_.light[triangle.vertices[k]][0]);
  for (int first = 0; first < count; first += k_lanes) {
    const auto at = static_cast<std::size_t>(fragments.count + first);
    const auto put = [at](Fragments::Numbers& numbers, const Lanes& lanes) {
      std::memcpy(numbers.data() + at, &lanes, sizeof lanes);
    };
    const Lanes s0 = __builtin_convertvector(edge[0], Lanes) * p.inverse_depths[0];
    const Lanes s1 = __builtin_convertvector(edge[1], Lanes) * p.inverse_depths[1];
    const Lanes s2 = __builtin_convertvector(edge[2], Lanes) * p.inverse_depths[2];
    for (std::size_t k = 0; k < 3; ++k) edge[k] += step[k];
    put(fragments.normal_x, (a.x * s0 + b.x * s1 + c.x * s2) * sign);
    put(fragments.normal_y, (a.y * s0 + b.y * s1 + c.y * s2) * sign);
    put(fragments.normal_z, (a.z * s0 + b.z * s1 + c.z * s2) * sign);
    put(fragments.eye_x, __builtin_convertvector(k_lane_numbers + (x + first), Lanes) + 0.5F);
    put(fragments.eye_y, Lanes{} + eye_y);
    put(fragments.red, Lanes{} + p.base.x);
    put(fragments.green, Lanes{} + p.base.y);
    put(fragments.blue, Lanes{} + p.base.z);
    put(fragments.roughness, Lanes{} + p.paints[0].surface.x);
    put(fragments.metallic, Lanes{} + p.paints[0].surface.y);
    put(fragments.open, Lanes{} + open);
    put(fragments.lit, Lanes{} + 1.0F);
    put(fragments.coat, Lanes{});
    Lanes sky = Lanes{} + 1.0F;
    if (shaded) sky = (s0 * skies[0] + s1 * skies[1] + s2 * skies[2]) / (s0 + s1 + s2);
    put(fragments.sky, sky);
  }
  for (int i = 0; i < count; ++i) fragments.tones[static_cast<std::size_t>(fragments.count + i)].toon = nullptr;
  fragments.count += count;
}

float SurfacePoints::add_plain(int x, int y, const Shares& unscaled, Fragments& fragments) const {
  const auto at = static_cast<std::size_t>(fragments.count);
  const Prepared& p = *chosen_;
  const std::array<Paint, 3>& paints = p.paints;
  glm::vec3 base = p.base;
  float alpha = paints[0].alpha;
  glm::vec3 surface = paints[0].surface;
  if (!p.plain_paint) {
    const Shares s = unscaled * (1.0F / (unscaled.x + unscaled.y + unscaled.z));
    const glm::vec3 albedo = paints[0].albedo * s.x + paints[1].albedo * s.y + paints[2].albedo * s.z;
    base = albedo * albedo;
    alpha = paints[0].alpha * s.x + paints[1].alpha * s.y + paints[2].alpha * s.z;
    surface = paints[0].surface * s.x + paints[1].surface * s.y + paints[2].surface * s.z;
  }
  if (surface.z < 0.999F) {
    float per_px = 0;
    if (!p.plain_paint) {
      const auto gaze_at = [&](int px_x, int px_y) {
        const Shares there = shares(px_x, px_y);
        return paints[0].surface.z * there.x + paints[1].surface.z * there.y + paints[2].surface.z * there.z;
      };
      per_px = std::abs(gaze_at(x + 1, y) - surface.z) + std::abs(gaze_at(x, y + 1) - surface.z);
    }
    base = eye_color(base, surface.z, per_px);
    surface.x = k_polished_eye;
  } else {
    fragments.coat[at] = 0;
  }
  fragments.red[at] = base.x;
  fragments.green[at] = base.y;
  fragments.blue[at] = base.z;
  fragments.roughness[at] = surface.x;
  fragments.metallic[at] = surface.y;
  fragments.open[at] = p.triangle.front ? 1.0F : k_inside;
  fragments.lit[at] = 1.0F;
  return alpha;
}

glm::vec4 SurfacePoints::tint_at(const Shares& s) const {
  const auto tint = [&](std::size_t k) {
    const Bytes4& t = paint_.tint[chosen_->triangle.vertices[k]];
    return glm::vec4(unit(t[0]) * unit(t[0]), unit(t[1]) * unit(t[1]), unit(t[2]) * unit(t[2]), unit(t[3]));
  };
  return tint(0) * s.x + tint(1) * s.y + tint(2) * s.z;
}

glm::vec4 SurfacePoints::texel(const document::TextureUse& use, const TextureMap& map, const TextureTransform& place,
                               int x, int y) const {
  const auto& coordinates = paint_.look->coordinates[use.coordinates == 1 ? 1 : 0];
  const auto place_of = [&](const Shares& of) {
    glm::vec2 uv{0, 0};
    if (!coordinates.empty()) {
      for (int k = 0; k < 3; ++k) {
        const auto& c = coordinates[chosen_->triangle.vertices[static_cast<std::size_t>(k)]];
        uv += glm::vec2(c[0], c[1]) * of[k];
      }
    }
    return place.along_u * uv.x + place.along_v * uv.y + place.shift;
  };
  const glm::vec2 here = place_of(shares(x, y));
  return map.sample(use, here, place_of(shares(x + 1, y)) - here, place_of(shares(x, y + 1)) - here);
}

glm::vec4 SurfacePoints::own_color(int x, int y) const {
  glm::vec4 color = tint_at(shares(x, y));
  const document::Surface& surface = *chosen_->triangle.segment->surface;
  const bool lost =
      surface.texture && chosen_->triangle.segment->texture == nullptr;  // its picture cannot be read: grey
  const float share = lost ? 0.6F : 1.0F;
  color.r *= static_cast<float>(surface.base_color[0]) * share;
  color.g *= static_cast<float>(surface.base_color[1]) * share;
  color.b *= static_cast<float>(surface.base_color[2]) * share;
  color.a *= lost ? 1.0F : static_cast<float>(surface.base_color[3]);
  const TextureMap* map = chosen_->triangle.segment->texture;
  return map == nullptr ? color : color * texel(*surface.texture, *map, chosen_->triangle.segment->place, x, y);
}

void SurfacePoints::add_tones(int x, int y, const glm::vec3& base, float over_alpha, Fragments& fragments) const {
  const Segment& segment = *chosen_->triangle.segment;
  const document::Toon& toon = *segment.surface->toon;
  glm::vec3 shade = glm::vec3(tint_at(shares(x, y))) * glm::vec3(static_cast<float>(toon.shade_color[0]),
                                                                 static_cast<float>(toon.shade_color[1]),
                                                                 static_cast<float>(toon.shade_color[2]));
  if (segment.shade_texture != nullptr)
    shade *= glm::vec3(texel(*toon.shade_texture, *segment.shade_texture, segment.shade_place, x, y));
  shade = mixed(shade, base, over_alpha);
  fragments.tones[static_cast<std::size_t>(fragments.count)] = {&toon, segment.outline, shade.r, shade.g, shade.b};
  fragments.some_tones = true;
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
      const Bytes4& one = paint_.overlay[chosen_->triangle.vertices[static_cast<std::size_t>(k)]];
      over += glm::vec4(unit(one[0]), unit(one[1]), unit(one[2]), unit(one[3])) * s[k];
    }
    over_alpha = over.a;
    const glm::vec3 root =
        mixed(glm::vec3(std::sqrt(base.x), std::sqrt(base.y), std::sqrt(base.z)), glm::vec3(over), over_alpha);
    base = root * root;
  }
  const document::Surface& surface = *chosen_->triangle.segment->surface;
  const bool lost = surface.texture && chosen_->triangle.segment->texture == nullptr;
  fragments.red[at] = base.x;
  fragments.green[at] = base.y;
  fragments.blue[at] = base.z;
  fragments.roughness[at] = chosen_->triangle.segment->roughness;
  fragments.metallic[at] = chosen_->triangle.segment->metallic;
  fragments.open[at] = 1.0F;
  fragments.lit[at] = surface.unlit && !lost && over_alpha < 0.01F ? 0.0F : 1.0F;
  if (surface.toon) add_tones(x, y, base, over_alpha, fragments);
  const float coat = surface.unlit || surface.toon ? 0.0F : fragments.coat[at];
  fragments.coat[at] = coat;
  fragments.roughness[at] += (k_polished_eye - fragments.roughness[at]) * coat;
  return own.a;
}

}  // namespace penpose::render
