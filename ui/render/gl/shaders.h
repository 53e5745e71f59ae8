#pragma once

#include <string_view>

// This file is above the usual size because the shaders share their conventions and are compared side by side.
// GlProgram gives these words a meaning: GLSL 1.40, ES 3.00, 1.20 and ES 1.00 have others for
// `from_buffer`, `to_fragment`, `from_vertex`, `sample_picture` and `result`.
namespace penpose::render {

/// The triangle of ScreenFill, which covers the viewport.
inline constexpr std::string_view k_screen_vertex = R"(
from_buffer vec2 corner;
to_fragment vec2 place;
void main() {
  place = corner * 0.5 + 0.5;
  gl_Position = vec4(corner, 0.0, 1.0);
}
)";

/// A picture as it is.
inline constexpr std::string_view k_copy_fragment = R"(
from_vertex vec2 place;
uniform sampler2D picture;
void main() {
  result = sample_picture(picture, place);
}
)";

/// A soft gradient, a little brighter behind the middle. Noise of half a step hides the bands of 8 bits.
inline constexpr std::string_view k_background_fragment = R"(
from_vertex vec2 place;
uniform vec3 top;
uniform vec3 bottom;
uniform float vignette;
void main() {
  vec3 color = mix(bottom, top, smoothstep(0.0, 1.0, place.y));
  vec2 d = place - vec2(0.5, 0.55);
  color *= 1.12 - vignette * dot(d, d);
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  result = vec4(color + (noise - 0.5) / 255.0, 1.0);
}
)";

/// Before the vertex shaders of surfaces: places a vertex. Positions are moved to the middle of the model and scaled to
/// about one before any arithmetic, so that units, size and distance from the origin do not matter.
inline constexpr std::string_view k_place_functions = R"(
from_buffer vec3 position;
from_buffer vec3 normal;
uniform vec3 middle;
uniform float scale;
uniform mat4 to_view;
uniform mat4 to_clip;
to_fragment vec3 view_position;
to_fragment vec3 view_normal;
void place_vertex() {
  vec4 p = to_view * vec4((position - middle) * scale, 1.0);
  view_position = p.xyz;
  view_normal = mat3(to_view) * normal;
  gl_Position = to_clip * p;
}
)";

/// Surfaces of materials, after k_place_functions.
inline constexpr std::string_view k_mesh_vertex = R"(
from_buffer vec4 base_color;
from_buffer vec4 finish;
from_buffer vec4 overlay;
from_buffer vec4 light;
to_fragment vec4 albedo;
to_fragment vec3 surface;
to_fragment float sky;
void main() {
  place_vertex();
  sky = light.x;
  albedo = vec4(mix(base_color.rgb, overlay.rgb, overlay.a), base_color.a * finish.w);
  surface = vec3(finish.x, finish.y, overlay.a > 0.5 ? 1.0 : finish.z);
}
)";

/// Surfaces with pictures and colours of their own, after k_place_functions.
inline constexpr std::string_view k_look_vertex = R"(
from_buffer vec4 overlay;
from_buffer vec4 coordinates;
from_buffer vec4 tint;
from_buffer vec4 light;
uniform float second_set;
uniform vec2 along_u;
uniform vec2 along_v;
uniform vec2 shift;
uniform vec2 outline;  // how far it stands out: everywhere, and for each unit of distance
#ifdef VERTICES_SEE_PICTURES
uniform sampler2D outline_picture;
uniform float outline_textured;
#endif
to_fragment vec4 color;
to_fragment vec4 over;
to_fragment vec2 at;
to_fragment vec2 sky_and_coat;
void main() {
  place_vertex();
  sky_and_coat = light.xy;
  color = vec4(tint.rgb * tint.rgb, tint.a);
  over = overlay;
  vec2 uv = second_set > 0.5 ? coordinates.zw : coordinates.xy;
  at = along_u * uv.x + along_v * uv.y + shift;
  if (outline.x + outline.y > 0.0) {
    float wide = outline.x - outline.y * view_position.z;
#ifdef VERTICES_SEE_PICTURES
    if (outline_textured > 0.5) wide *= sqrt(textureLod(outline_picture, at, 0.0).g);
#endif
    view_position += normalize(view_normal) * wide;
    gl_Position = to_clip * vec4(view_position, 1.0);
  }
}
)";

/// Three lights that move with the camera (key from the upper left, cool fill from the right, rim from behind above), a
/// sky-and-ground ambient and a GGX highlight (Walter et al. 2007; visibility after Hammon 2017). Sums are made in
/// linear light. What is seen from its back is the inside of something: it is drawn dim.
inline constexpr std::string_view k_lights = R"(
vec3 lit(vec3 n, vec3 v, vec3 l, vec3 light, vec3 diffuse, vec3 f0, float alpha, float wrap) {
  float raw = dot(n, l);
  float soft = max((raw + wrap) / (1.0 + wrap), 0.0);
  float nl = max(raw, 0.0);
  float nv = max(dot(n, v), 0.02);
  vec3 h = normalize(l + v);
  float nh = max(dot(n, h), 0.0);
  float a2 = alpha * alpha;
  float d = nh * nh * (a2 - 1.0) + 1.0;
  float spread = a2 / (3.14159265 * d * d);
  float visible = 0.5 / mix(2.0 * nl * nv, nl + nv, alpha);
  vec3 fresnel = f0 + (1.0 - f0) * pow(1.0 - max(dot(v, h), 0.0), 5.0);
  return light * (diffuse * soft + fresnel * min(spread * visible, 8.0) * nl);
}

vec3 to_display(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  return mix(c * 12.92, 1.055 * pow(max(c, vec3(0.0031308)), vec3(1.0 / 2.4)) - 0.055, step(vec3(0.0031308), c));
}

const vec3 k_key = vec3(-0.465684, 0.577448, 0.670585);  // length one

vec3 lighted(vec3 n, vec3 v, vec3 base, float roughness, float metallic, float occlude, float sky) {
  float alpha = max(roughness * roughness, k_least_alpha);
  vec3 f0 = mix(vec3(0.035), base, metallic);
  vec3 diffuse = base * (1.0 - metallic);
  vec3 ambient = mix(vec3(0.085, 0.072, 0.064), vec3(0.20, 0.215, 0.24), n.y * 0.5 + 0.5);
  vec3 color = sky * ambient * (diffuse + f0 * (1.0 - 0.7 * roughness));
  color += (0.6 + 0.4 * sky) * lit(n, v, k_key, vec3(0.86, 0.81, 0.75), diffuse, f0, alpha, 0.18);
  color += sky * lit(n, v, normalize(vec3(0.85, 0.10, 0.50)), vec3(0.11, 0.125, 0.15), diffuse, f0, max(alpha, 0.2),
                     0.3);
  color += sky * lit(n, v, normalize(vec3(0.45, 0.55, -0.75)), vec3(0.40, 0.44, 0.50), diffuse, f0, max(alpha, 0.25),
                     0.0);
  color *= 1.15 * occlude;
  // A soft shoulder: white things keep their shading.
  return color * (1.0 + color * 0.35) / (1.0 + color * 0.62);
}

// The window that an eye mirrors, and a little of the floor.
float catchlight(vec3 n, vec3 v) {
  float key = smoothstep(0.9900, 0.9965, dot(n, normalize(k_key + v)));
  float floor_light = smoothstep(0.955, 0.995, dot(n, normalize(vec3(0.4716, -0.4716, 0.7451) + v)));
  return 0.85 * key + 0.05 * floor_light;
}
)";

/// Plain surfaces, after k_lights.
inline constexpr std::string_view k_mesh_fragment = R"(
from_vertex vec3 view_position;
from_vertex vec3 view_normal;
from_vertex vec4 albedo;
from_vertex vec3 surface;
from_vertex float sky;
uniform float opaque_pass;
uniform float matcap;

// Light that lies on a ball: what looks the same way on the screen is equally bright wherever it is. One lamp above
// on the left, a cool edge on the right.
vec3 ball(vec3 n, vec3 v) {
  vec3 x = normalize(vec3(v.z, 0.0, -v.x));
  vec2 at = vec2(dot(x, n), dot(cross(v, x), n));
  float up = smoothstep(-1.05, 0.95, dot(at, vec2(-0.6, 0.8)));
  float edge = length(at);
  vec3 color = mix(vec3(0.030, 0.026, 0.034), vec3(0.50, 0.37, 0.31), up);
  color += vec3(0.42, 0.37, 0.32) * (1.0 - smoothstep(0.0, 0.75, length(at - vec2(-0.33, 0.42))));
  color += vec3(0.35) * (1.0 - smoothstep(0.04, 0.22, length(at - vec2(-0.36, 0.48))));
  color *= 1.0 - 0.55 * smoothstep(0.80, 1.0, edge);
  return color + vec3(0.10, 0.16, 0.26) * smoothstep(0.70, 0.98, edge) * max(at.x, 0.0);
}

void main() {
  vec3 n = normalize(view_normal);
  vec3 v = normalize(-view_position);
  float inside = gl_FrontFacing ? 0.0 : 1.0;
  if (inside > 0.5) n = -n;
  vec3 base = albedo.rgb * albedo.rgb;  // stored as square roots: finer steps in the dark
  float roughness = surface.x;
  float coat = 0.0;
  if (surface.z < 0.999) {
    // Eye: pupil, iris with a dark rim and a lighter ring, then the white with a hint of pink far out.
    float d = surface.z;
    float w = max(change_per_px(d), 0.004);
    coat = 1.0 - smoothstep(0.90, 0.97, d);
    vec3 iris = mix(vec3(0.17, 0.10, 0.045), vec3(0.05, 0.032, 0.02), smoothstep(0.30, 0.46, d));
    vec3 color = mix(base, iris, 1.0 - smoothstep(0.46 - w - 0.015, 0.46 + w + 0.015, d));
    base = mix(color, vec3(0.006), 1.0 - smoothstep(0.19 - w, 0.19 + w, d));
    roughness = 0.12;
  }
  vec3 diffuse = base * (1.0 - surface.y);
  vec3 color = lighted(n, v, base, roughness, surface.y, mix(1.0, 0.22, inside), sky);
  if (coat > 0.0) color += coat * catchlight(n, v);
  if (matcap > 0.5) color = base * ball(n, v) * mix(0.5 + 0.5 * sky, 0.22, inside);
  float opacity = 1.0;
  if (opaque_pass < 0.5) {
    // A clear film hides little of what is behind it, but its highlight is as bright as on anything else.
    float shine = max(color.r - dot(diffuse, vec3(0.4)), 0.0);
    opacity = clamp(albedo.a + shine * 0.5, 0.0, 1.0);
  }
  result = vec4(to_display(color), opacity);
}
)";

/// Surfaces with pictures and colours of their own, after k_lights. What is fainter than `least_alpha` is not there;
/// the picture is sRGB and comes as linear light, or as it is where there are no textures of sRGB.
inline constexpr std::string_view k_look_fragment = R"(
from_vertex vec3 view_position;
from_vertex vec3 view_normal;
from_vertex vec4 color;
from_vertex vec4 over;
from_vertex vec2 at;
from_vertex vec2 sky_and_coat;
uniform sampler2D picture;
uniform sampler2D shade_picture;
uniform float textured;
uniform vec3 factor;
uniform float opacity;
uniform float least_alpha;
uniform float unlit;
uniform float roughness;
uniform float metallic;
uniform vec3 toon;  // whether it is one, where its tones meet, how sharply
uniform vec3 shade_factor;
uniform float shade_textured;
uniform vec3 outline_color;
uniform float outline_mix;  // below zero: no outline

vec3 linear_light(vec3 texel) {
#ifdef PICTURES_ARE_ENCODED
  return mix(texel / 12.92, pow((texel + 0.055) / 1.055, vec3(2.4)), step(vec3(0.04045), texel));
#else
  return texel;
#endif
}

vec3 toned(vec3 n, vec3 base, vec4 over_it) {
  vec3 shade = color.rgb * shade_factor;
  if (shade_textured > 0.5) shade *= linear_light(sample_picture(shade_picture, at).rgb);
  shade = mix(shade, base, over_it.a);
  float t = (dot(n, k_key) + toon.y + 1.0 - toon.z) / max(2.0 - 2.0 * toon.z, 0.02);
  return mix(shade, base, clamp(t, 0.0, 1.0));
}

void main() {
  vec4 own = color * vec4(factor, opacity);
  if (textured > 0.5) {
    vec4 texel = sample_picture(picture, at);
    own *= vec4(linear_light(texel.rgb), texel.a);
  }
  if (own.a < least_alpha) discard;
  vec3 mixed = mix(sqrt(max(own.rgb, vec3(0.0))), over.rgb, over.a);
  vec3 base = mixed * mixed;
  vec3 n = normalize(view_normal);
  if (!gl_FrontFacing && outline_mix < 0.0) n = -n;
  vec3 v = normalize(-view_position);
  vec3 shown = base;
  if (toon.x > 0.5) {
    shown = toned(n, base, over);
    if (outline_mix >= 0.0) shown = outline_color * mix(vec3(1.0), shown, outline_mix);
  } else if (unlit < 0.5 || over.a >= 0.01) {
    float coat = sky_and_coat.y;
    shown = lighted(n, v, base, mix(roughness, 0.12, coat), metallic, 1.0, sky_and_coat.x);
    if (coat > 0.0) shown += coat * catchlight(n, v);
  }
  result = vec4(to_display(shown), own.a);
}
)";

/// The edges of the triangles.
inline constexpr std::string_view k_wire_fragment = R"(
from_vertex vec3 view_position;
from_vertex vec3 view_normal;
from_vertex vec4 albedo;
from_vertex vec3 surface;
void main() {
  result = vec4(0.04, 0.05, 0.07, 0.32);
}
)";

/// How much of the sky each visible point sees, from the depth buffer: creases, nostrils and open mouths go dark. The
/// result multiplies the picture. After the horizon-free estimator of McGuire et al., "The Alchemy screen-space ambient
/// obscurance algorithm" (2011).
inline constexpr std::string_view k_occlusion_fragment = R"(
from_vertex vec2 place;
uniform sampler2D depths;
uniform vec2 depth_to_z;   // z = 1 / (x * depth + y)
uniform vec2 image_plane;  // half width and half height at distance 1
uniform vec2 size_px;
uniform float radius;

vec3 point(vec2 at, float depth) {
  float z = 1.0 / (depth_to_z.x * depth + depth_to_z.y);
  return vec3((at * 2.0 - 1.0) * image_plane * z, -z);
}

void main() {
  float depth = sample_picture(depths, place).r;
  if (depth >= 1.0) { result = vec4(1.0); return; }
  vec3 p = point(place, depth);
  vec2 px = 1.0 / size_px;
  vec3 right = point(place + vec2(px.x, 0.0), sample_picture(depths, place + vec2(px.x, 0.0)).r) - p;
  vec3 left = p - point(place - vec2(px.x, 0.0), sample_picture(depths, place - vec2(px.x, 0.0)).r);
  vec3 up = point(place + vec2(0.0, px.y), sample_picture(depths, place + vec2(0.0, px.y)).r) - p;
  vec3 down = p - point(place - vec2(0.0, px.y), sample_picture(depths, place - vec2(0.0, px.y)).r);
  vec3 dx = abs(right.z) < abs(left.z) ? right : left;
  vec3 dy = abs(up.z) < abs(down.z) ? up : down;
  vec3 n = normalize(cross(dx, dy));
  float reach = radius / (-p.z * image_plane.y) * 0.5;
  float turn = 6.2831853 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  float sum = 0.0;
  const int count = 20;
  for (int i = 0; i < count; ++i) {
    float t = (float(i) + 0.5) / float(count);
    float angle = turn + t * 6.2831853 * 7.0;
    vec2 at = place + vec2(cos(angle) * size_px.y / size_px.x, sin(angle)) * reach * t;
    if (at.x < 0.0 || at.y < 0.0 || at.x > 1.0 || at.y > 1.0) continue;
    float other = sample_picture(depths, at).r;
    if (other >= 1.0) continue;
    vec3 d = point(at, other) - p;
    float dd = dot(d, d);
    float near = max(1.0 - dd / (radius * radius), 0.0);
    sum += near * max(dot(d, n) - 0.012 * radius, 0.0) / (dd + 0.0004 * radius * radius) * radius;
  }
  // What is only a little curved is no crease.
  float open = clamp(1.08 - 0.75 * sum / float(count), 0.0, 1.0);
  result = vec4(vec3(open), 1.0);
}
)";

/// Averages the occlusion over 4 x 4 px, which is what its noise was made for, without crossing edges of depth.
inline constexpr std::string_view k_occlusion_blur_fragment = R"(
from_vertex vec2 place;
uniform sampler2D depths;
uniform sampler2D occlusion;
uniform vec2 depth_to_z;
uniform vec2 size_px;
uniform float radius;
float z_at(vec2 at) { return 1.0 / (depth_to_z.x * sample_picture(depths, at).r + depth_to_z.y); }
void main() {
  float z = z_at(place);
  float sum = 0.0;
  float weights = 0.0;
  for (int y = -2; y <= 2; ++y) {
    for (int x = -2; x <= 2; ++x) {
      vec2 at = place + vec2(float(x), float(y)) / size_px;
      float w = max(1.0 - abs(z_at(at) - z) / (0.25 * radius), 0.0) + 0.0001;
      sum += w * sample_picture(occlusion, at).r;
      weights += w;
    }
  }
  float open = sum / weights;
  // Light that bounces out of a crease is warm, and never quite gone.
  result = vec4(mix(vec3(0.14, 0.07, 0.06), vec3(1.0), vec3(pow(open, 0.82), open, open)), 1.0);
}
)";

/// Curves are unions of round cones; each quad carries one. Depth is the signed distance, so that of overlapping quads
/// the nearest to the middle of the curve wins and nothing is blended twice.
inline constexpr std::string_view k_curve_vertex = R"(
from_buffer vec2 corner;
from_buffer vec4 ends;
from_buffer vec2 radii;
from_buffer vec4 color;
from_buffer float order;
uniform vec2 size_px;
to_fragment vec2 at;
flat to_fragment vec4 segment;
flat to_fragment vec2 radius;
flat to_fragment float layer;
to_fragment vec4 ink;
void main() {
  at = corner;
  segment = ends;
  radius = radii;
  layer = order;
  ink = color;
  gl_Position = vec4(corner.x / size_px.x * 2.0 - 1.0, 1.0 - corner.y / size_px.y * 2.0, 0.0, 1.0);
}
)";

inline constexpr std::string_view k_curve_fragment = R"(
from_vertex vec2 at;
flat from_vertex vec4 segment;
flat from_vertex vec2 radius;
flat from_vertex float layer;
from_vertex vec4 ink;
uniform float outline_px;
uniform float halo_px;
uniform float slice;
uniform float first_depth;
void main() {
  vec2 along = segment.zw - segment.xy;
  float t = clamp(dot(at - segment.xy, along) / max(dot(along, along), 1e-6), 0.0, 1.0);
  float d = length(at - segment.xy - along * t) - mix(radius.x, radius.y, t);
  float edge = outline_px + halo_px;
  float cover = clamp(0.5 + edge - d, 0.0, 1.0);
  if (cover <= 0.0) discard;
  float rank = clamp((d + 64.0) / 128.0, 0.0, 1.0);
  gl_FragDepth = first_depth - slice * (1.0 - rank) + layer;
  vec3 dark = ink.rgb * 0.10 + 0.01;
  vec3 color = mix(ink.rgb, dark, clamp(0.5 + d, 0.0, 1.0));
  if (halo_px > 0.0) color = mix(color, vec3(1.0, 0.93, 0.62), clamp(0.5 + d - outline_px, 0.0, 1.0));
  float strength = halo_px > 0.0 ? mix(1.0, 0.75, clamp(0.5 + d - outline_px, 0.0, 1.0)) : 1.0;
  strength *= d > -0.5 && halo_px <= 0.0 ? mix(1.0, 0.8, clamp(0.5 + d, 0.0, 1.0)) : 1.0;
  result = vec4(color, ink.a * cover * strength);
}
)";

}  // namespace penpose::render
