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
};

Light light(float x, float y, float z, float red, float green, float blue, float least_alpha, float wrap) {
  const float size = std::sqrt(x * x + y * y + z * z);
  return {x / size, y / size, z / size, red, green, blue, least_alpha, wrap};
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
    p.red[i] = (0.085F + up * (0.20F - 0.085F)) * (p.diffuse_red[i] + p.f0_red[i] * film);
    p.green[i] = (0.072F + up * (0.215F - 0.072F)) * (p.diffuse_green[i] + p.f0_green[i] * film);
    p.blue[i] = (0.064F + up * (0.24F - 0.064F)) * (p.diffuse_blue[i] + p.f0_blue[i] * film);
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
    p.red[i] += light.red * (p.diffuse_red[i] * soft + (p.f0_red[i] + (1.0F - p.f0_red[i]) * grazing) * peak);
    p.green[i] += light.green * (p.diffuse_green[i] * soft + (p.f0_green[i] + (1.0F - p.f0_green[i]) * grazing) * peak);
    p.blue[i] += light.blue * (p.diffuse_blue[i] * soft + (p.f0_blue[i] + (1.0F - p.f0_blue[i]) * grazing) * peak);
  }
}

/// A soft shoulder keeps the shading of white things; then the square root, by which the table of sRGB goes.
inline float shoulder(float color, float open) {
  const float c = color * open;
  return c * (1.0F + c * 0.35F) / (1.0F + c * 0.62F);
}

}  // namespace

void shade(Fragments& f, const PxToEye& eye) {
  static const Light key = light(-0.50F, 0.62F, 0.72F, 0.86F, 0.81F, 0.75F, 0.0F, 0.18F);
  static const Light fill = light(0.85F, 0.10F, 0.50F, 0.11F, 0.125F, 0.15F, 0.2F, 0.3F);
  static const Light rim = light(0.45F, 0.55F, -0.75F, 0.40F, 0.44F, 0.50F, 0.25F, 0.0F);
  Prepared p;
  prepare(f, p, eye);
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
