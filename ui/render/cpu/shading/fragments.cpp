#include "ui/render/cpu/shading/fragments.h"

#include <cmath>

#include "ui/render/cpu/shading/srgb_tables.h"

namespace penpose::render {
namespace {

using Numbers = Fragments::Numbers;

// Spelled without choices, so that compilers take several numbers at once.
inline float above_zero(float a) { return 0.5F * (a + std::fabs(a)); }
inline float larger(float a, float b) { return b + above_zero(a - b); }
inline float smaller(float a, float b) { return b - above_zero(b - a); }

/// 0..1; zero for what is no number.
inline float clamped(float a) {
  const float positive = a > 0.0F ? a : 0.0F;
  return positive < 1.0F ? positive : 1.0F;
}

struct Light {
  float x, y, z;           ///< towards it, length one
  float red, green, blue;  ///< linear
  float least_alpha;       ///< of the highlight
  float wrap;              ///< how far it reaches around the edge of shadow
  float direct;            ///< the share of it that comes from one place, which no soft shadow takes
};

Light light(float x, float y, float z, float red, float green, float blue, float least_alpha, float wrap,
            float direct) {
  const float size = std::sqrt(x * x + y * y + z * z);
  return {x / size, y / size, z / size, red, green, blue, least_alpha, wrap, direct};
}

/// A surface before light, for the fragments of one call.
struct Prepared {
  alignas(32) Numbers alpha;
  alignas(32) Numbers eye_z;
  alignas(32) Numbers facing;  ///< n . v
  alignas(32) Numbers f0_red, f0_green, f0_blue;
  alignas(32) Numbers diffuse_red, diffuse_green, diffuse_blue;
  alignas(32) Numbers red, green, blue;  ///< light that leaves, so far
};

void prepare(Fragments& f, Prepared& p, const PxToEye& eye) {
  for (int i = 0; i < f.count; ++i) {
    const float nn = f.normal_x[i] * f.normal_x[i] + f.normal_y[i] * f.normal_y[i] + f.normal_z[i] * f.normal_z[i];
    const float n = 1.0F / std::sqrt(nn + 1e-30F);
    f.normal_x[i] *= n;
    f.normal_y[i] *= n;
    f.normal_z[i] *= n;
    const float x = f.eye_x[i] * eye.scale_x + eye.shift_x;
    const float y = f.eye_y[i] * eye.scale_y + eye.shift_y;
    const float v = 1.0F / std::sqrt(x * x + y * y + 1.0F);
    f.eye_x[i] = x * v;
    f.eye_y[i] = y * v;
    p.eye_z[i] = v;
    p.facing[i] = f.normal_x[i] * f.eye_x[i] + f.normal_y[i] * f.eye_y[i] + f.normal_z[i] * p.eye_z[i];
  }
  for (int i = 0; i < f.count; ++i) {
    const float dull = 1.0F - f.metallic[i];
    const float least = 0.035F * dull;
    p.alpha[i] = larger(f.roughness[i] * f.roughness[i], 0.01F);
    p.f0_red[i] = least + f.red[i] * f.metallic[i];
    p.f0_green[i] = least + f.green[i] * f.metallic[i];
    p.f0_blue[i] = least + f.blue[i] * f.metallic[i];
    p.diffuse_red[i] = f.red[i] * dull;
    p.diffuse_green[i] = f.green[i] * dull;
    p.diffuse_blue[i] = f.blue[i] * dull;
    const float up = f.normal_y[i] * 0.5F + 0.5F;
    const float film = 1.0F - 0.7F * f.roughness[i];
    p.red[i] = f.sky[i] * (0.085F + up * (0.20F - 0.085F)) * (p.diffuse_red[i] + p.f0_red[i] * film);
    p.green[i] = f.sky[i] * (0.072F + up * (0.215F - 0.072F)) * (p.diffuse_green[i] + p.f0_green[i] * film);
    p.blue[i] = f.sky[i] * (0.064F + up * (0.24F - 0.064F)) * (p.diffuse_blue[i] + p.f0_blue[i] * film);
  }
}

/// Whether a light reaches some of the fragments; what it does not reach gets nothing of it.
bool reaches(const Fragments& f, const Light& light, int from, int end) {
  float most = 0;
  for (int i = from; i < end; ++i) {
    const float raw = f.normal_x[i] * light.x + f.normal_y[i] * light.y + f.normal_z[i] * light.z;
    most += above_zero(raw + light.wrap);
  }
  return most != 0;
}

void add_light(const Fragments& f, Prepared& p, const Light& light, int from, int end) {
  const float wrapped = 1.0F / (1.0F + light.wrap);
  for (int i = from; i < end; ++i) {
    const float raw = f.normal_x[i] * light.x + f.normal_y[i] * light.y + f.normal_z[i] * light.z;
    const float soft = above_zero((raw + light.wrap) * wrapped);
    const float nl = above_zero(raw);
    const float nv = larger(p.facing[i], 0.02F);
    // Half way between light and eye: h = (l + v) / |l + v|, of which only products are needed.
    const float lv = f.eye_x[i] * light.x + f.eye_y[i] * light.y + p.eye_z[i] * light.z;
    const float half = 1.0F / std::sqrt(2.0F + 2.0F * lv + 1e-6F);
    const float nh = above_zero((raw + p.facing[i]) * half);
    const float vh = above_zero((1.0F + lv) * half);
    const float alpha = larger(p.alpha[i], light.least_alpha);
    const float a2 = alpha * alpha;
    const float d = nh * nh * (a2 - 1.0F) + 1.0F;
    const float product = 2.0F * nl * nv;
    const float shadowing = product + alpha * (nl + nv - product);
    // An edge seen from its back has none; any number will do, because it is multiplied by nl.
    const float peak = smaller(a2 * 0.5F / (3.14159265F * d * d * shadowing + 1e-12F), 8.0F) * nl;
    const float away = 1.0F - vh;
    const float away2 = away * away;
    const float grazing = away2 * away2 * away;
    const float seen = light.direct + (1.0F - light.direct) * f.sky[i];
    p.red[i] += light.red * seen * (p.diffuse_red[i] * soft + (p.f0_red[i] + (1.0F - p.f0_red[i]) * grazing) * peak);
    p.green[i] +=
        light.green * seen * (p.diffuse_green[i] * soft + (p.f0_green[i] + (1.0F - p.f0_green[i]) * grazing) * peak);
    p.blue[i] +=
        light.blue * seen * (p.diffuse_blue[i] * soft + (p.f0_blue[i] + (1.0F - p.f0_blue[i]) * grazing) * peak);
  }
}

/// A soft shoulder keeps the shading of white things; then the square root, by which the table of sRGB goes.
inline float shoulder(float color, float open) {
  const float c = 1.15F * color * open;
  return c * (1.0F + c * 0.35F) / (1.0F + c * 0.62F);
}

inline float smooth_step(float from, float to, float x) {
  const float t = clamped((x - from) / (to - from));
  return t * t * (3.0F - 2.0F * t);
}

/// Two tones: which of them is seen goes into the base colour, which is not lit any more.
void add_tones(Fragments& f, const Light& key) {
  for (int i = 0; i < f.count; ++i) {
    const Fragments::Tones& tones = f.tones[static_cast<std::size_t>(i)];
    if (tones.toon == nullptr) continue;
    const auto shift = static_cast<float>(tones.toon->shift);
    const auto toony = static_cast<float>(tones.toon->toony);
    const float nl = f.normal_x[i] * key.x + f.normal_y[i] * key.y + f.normal_z[i] * key.z;
    const float width = 2.0F - 2.0F * toony;
    const float t = clamped((nl + shift + 1.0F - toony) / (width > 0.02F ? width : 0.02F));
    const auto finish = [&](float base, float shade, std::size_t channel) {
      const float shown = shade + (base - shade) * t;
      if (!tones.outline) return shown;
      const auto mix = static_cast<float>(tones.toon->outline_mix);
      return static_cast<float>(tones.toon->outline_color[channel]) * (1.0F - mix + shown * mix);
    };
    f.red[i] = finish(f.red[i], tones.red, 0);
    f.green[i] = finish(f.green[i], tones.green, 1);
    f.blue[i] = finish(f.blue[i], tones.blue, 2);
    f.lit[i] = 0;
  }
}

/// How well a normal points half way between a light and the eye: 1 exactly.
float halfway(const Fragments& f, const Prepared& p, int i, float x, float y, float z) {
  const float hx = f.eye_x[i] + x;
  const float hy = f.eye_y[i] + y;
  const float hz = p.eye_z[i] + z;
  return (f.normal_x[i] * hx + f.normal_y[i] * hy + f.normal_z[i] * hz) /
         std::sqrt(hx * hx + hy * hy + hz * hz + 1e-12F);
}

/// The window that an eye mirrors, and a little of the floor.
void add_catchlights(const Fragments& f, Prepared& p, const Light& key) {
  for (int i = 0; i < f.count; ++i) {
    if (f.coat[i] <= 0) continue;
    const float window = smooth_step(0.9900F, 0.9965F, halfway(f, p, i, key.x, key.y, key.z));
    const float floor_light = smooth_step(0.955F, 0.995F, halfway(f, p, i, 0.4716F, -0.4716F, 0.7451F));
    const float mirrored = f.coat[i] * (0.85F * window + 0.05F * floor_light);
    p.red[i] += mirrored;
    p.green[i] += mirrored;
    p.blue[i] += mirrored;
  }
}

/// The light of a ball (`ball` in k_mesh_fragment).
void light_as_ball(const Fragments& f, Prepared& p) {
  for (int i = 0; i < f.count; ++i) {
    const float vx = f.eye_x[i], vy = f.eye_y[i], vz = p.eye_z[i];
    const float flat = 1.0F / std::sqrt(vx * vx + vz * vz + 1e-12F);
    const float xx = vz * flat, xz = -vx * flat;  // across the view; up is v cross x
    const float at_x = xx * f.normal_x[i] + xz * f.normal_z[i];
    const float at_y = vy * xz * f.normal_x[i] + (vz * xx - vx * xz) * f.normal_y[i] - vy * xx * f.normal_z[i];
    const auto away_from = [&](float x, float y) {
      return std::sqrt((at_x - x) * (at_x - x) + (at_y - y) * (at_y - y));
    };
    const float up = smooth_step(-1.05F, 0.95F, -0.6F * at_x + 0.8F * at_y);
    const float lobe = 1.0F - smooth_step(0.0F, 0.75F, away_from(-0.33F, 0.42F));
    const float spot = 0.35F * (1.0F - smooth_step(0.04F, 0.22F, away_from(-0.36F, 0.48F)));
    const float edge = away_from(0, 0);
    const float dim = 1.0F - 0.55F * smooth_step(0.80F, 1.0F, edge);
    const float rim = smooth_step(0.70F, 0.98F, edge) * above_zero(at_x);
    const float open = f.open[i] * (0.5F + 0.5F * f.sky[i]);
    p.red[i] = f.red[i] * open * ((0.030F + up * (0.50F - 0.030F) + 0.42F * lobe + spot) * dim + 0.10F * rim);
    p.green[i] = f.green[i] * open * ((0.026F + up * (0.37F - 0.026F) + 0.37F * lobe + spot) * dim + 0.16F * rim);
    p.blue[i] = f.blue[i] * open * ((0.034F + up * (0.31F - 0.034F) + 0.32F * lobe + spot) * dim + 0.26F * rim);
  }
}

}  // namespace

void shade(Fragments& f, const PxToEye& eye) {
  static const Light key = light(-0.50F, 0.62F, 0.72F, 0.86F, 0.81F, 0.75F, 0.0F, 0.18F, 0.6F);
  static const Light fill = light(0.85F, 0.10F, 0.50F, 0.11F, 0.125F, 0.15F, 0.2F, 0.3F, 0.0F);
  static const Light rim = light(0.45F, 0.55F, -0.75F, 0.40F, 0.44F, 0.50F, 0.25F, 0.0F, 0.0F);
  Prepared p;
  prepare(f, p, eye);
  if (f.some_tones) add_tones(f, key);
  constexpr int k_together = 32;
  for (int i = 0; i < f.count; i += k_together) {
    const int end = i + k_together < f.count ? i + k_together : f.count;
    for (const Light* one : {&key, &fill, &rim}) {
      // The rim's light comes from behind, and most of a face does not see it.
      if (one != &rim || reaches(f, rim, i, end)) add_light(f, p, *one, i, end);
    }
  }
  for (int i = 0; i < f.count; ++i) {
    const float dark = 1.0F - f.lit[i];
    p.red[i] = shoulder(p.red[i], f.open[i]) * f.lit[i] + f.red[i] * dark;
    p.green[i] = shoulder(p.green[i], f.open[i]) * f.lit[i] + f.green[i] * dark;
    p.blue[i] = shoulder(p.blue[i], f.open[i]) * f.lit[i] + f.blue[i] * dark;
  }
  if (f.some_coat) add_catchlights(f, p, key);
  if (f.matcap) light_as_ball(f, p);
  f.some_coat = false;
  f.some_tones = false;
  for (int i = 0; i < f.count; ++i) {
    f.shine[i] = above_zero(p.red[i] - 0.4F * (p.diffuse_red[i] + p.diffuse_green[i] + p.diffuse_blue[i]));
  }
  for (int i = 0; i < f.count; ++i) {
    f.shown_red[i] = std::sqrt(clamped(p.red[i]));
    f.shown_green[i] = std::sqrt(clamped(p.green[i]));
    f.shown_blue[i] = std::sqrt(clamped(p.blue[i]));
  }
  const SrgbTables& srgb = SrgbTables::get();
  for (int i = 0; i < f.count; ++i) {
    f.shown_red[i] = srgb.display_of_root(f.shown_red[i]);
    f.shown_green[i] = srgb.display_of_root(f.shown_green[i]);
    f.shown_blue[i] = srgb.display_of_root(f.shown_blue[i]);
  }
}

}  // namespace penpose::render
