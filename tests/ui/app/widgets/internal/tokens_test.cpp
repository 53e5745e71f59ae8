#include "ui/app/widgets/internal/tokens.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

// Every ink can be read on every ground that it stands on, in both looks (WCAG 2.1, level AA).

namespace penpose::app {
namespace {

double luminance(Rgb color) {
  const auto part = [&](int shift) {
    const double value = ((color >> shift) & 255U) / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * part(16) + 0.7152 * part(8) + 0.0722 * part(0);
}

double contrast(Rgb a, Rgb b) {
  const double one = luminance(a);
  const double other = luminance(b);
  return (std::max(one, other) + 0.05) / (std::min(one, other) + 0.05);
}

struct Pair {
  const char* what;
  Rgb ink;
  Rgb ground;
};

constexpr double k_words = 4.5, k_signs = 3;

std::vector<Pair> words_of(const Palette& p) {
  std::vector<Pair> out;
  for (const Rgb ground : {p.panel, p.popup, p.field, p.button, p.hovered, p.chosen}) {
    out.push_back({"ink", p.ink, ground});
    out.push_back({"faint ink", p.faint, ground});
  }
  out.push_back({"on the accent", p.on_accent, p.accent});
  out.push_back({"on the accent under the pen", p.on_accent, p.accent_hovered});
  out.push_back({"on a pressed key", p.on_lit, p.lit});
  out.push_back({"what a tour asks again", p.asks, p.panel});
  return out;
}

std::vector<Pair> signs_of(const Palette& p) {
  std::vector<Pair> out{{"recording", p.record, p.panel},  {"not recording", p.idle, p.panel},
                        {"an error", p.error, p.popup},    {"the accent on a panel", p.accent, p.panel},
                        {"a notice", p.accent, p.popup},   {"a tour's card", p.asks, p.panel},
                        {"performing", p.record, p.field}, {"performing on the canvas", p.record, p.popup}};
  for (const Rgb key : {p.key, p.key_here, p.key_selected, p.key_group, p.key_camera, p.key_camera_here})
    out.push_back({"a key", key, p.field});
  for (const Rgb curve : p.curves) out.push_back({"a curve", curve, p.field});
  return out;
}

TEST(Tokens, WordsCanBeReadOnEveryGround) {
  for (const bool light : {false, true}) {
    for (const Pair& one : words_of(palette_of(light)))
      EXPECT_GE(contrast(one.ink, one.ground), k_words)
          << one.what << std::hex << " " << one.ink << " on " << one.ground << (light ? ", light" : ", dark");
  }
}

TEST(Tokens, SignsAreSeenOnEveryGround) {
  for (const bool light : {false, true}) {
    for (const Pair& one : signs_of(palette_of(light)))
      EXPECT_GE(contrast(one.ink, one.ground), k_signs)
          << one.what << std::hex << " " << one.ink << " on " << one.ground << (light ? ", light" : ", dark");
  }
}

TEST(Tokens, WhatIsOnThePictureCanBeReadInEveryLook) {
  const CanvasColors& c = k_canvas_colors;
  for (const Rgb ground : {c.axis_x, c.axis_y, c.axis_z, c.name_known, c.name_guess})
    EXPECT_GE(contrast(c.ink, ground), k_words) << std::hex << ground;
}

TEST(Tokens, TheCanvasIsAsLightAsTheLook) {
  EXPECT_LT(luminance(k_dark_palette.canvas_top), 0.2);
  EXPECT_GT(luminance(k_light_palette.canvas_foot), 0.5);
}

TEST(Tokens, KeysAreToldApart) {
  for (const bool light : {false, true}) {
    const Palette& p = palette_of(light);
    EXPECT_GE(contrast(p.key, p.key_here), 1.3) << light;
    EXPECT_GE(contrast(p.key, p.key_selected), 1.6) << light;
    EXPECT_GE(contrast(p.key_camera, p.key_camera_here), 1.6) << light;
  }
}

}  // namespace
}  // namespace penpose::app
