#pragma once

#include <array>
#include <cstdint>

// All measures and colours of the interface: panels and widgets take them from here and have none of their own. Private
// to the module; theme.h makes ImGui's style and colours of them.

namespace penpose::app {

// Type, px at scale 1: of what stands beside, of what is read at all times, and of titles.
inline constexpr float k_small_px = 13;
inline constexpr float k_text_px = 16;
inline constexpr float k_title_px = 20;

// Space, px at scale 1, in steps of one half.
inline constexpr float k_hair_px = 1;       ///< lines between groups
inline constexpr float k_half_gap_px = 3;   ///< an icon and its word
inline constexpr float k_gap_px = 6;        ///< neighbours, and what is in a panel and its edge
inline constexpr float k_wide_gap_px = 12;  ///< groups

// Corners, px at scale 1: of buttons and fields, and of what lies above the panels.
inline constexpr float k_corner_px = 5;
inline constexpr float k_wide_corner_px = 8;
inline constexpr float k_thin_corner_px = 2;  ///< of grabs

/// What a pen hits for certain, px at scale 1, in both directions: no target is smaller.
inline constexpr float k_least_target_px = 32;

/// 0xRRGGBB, as displays show it.
using Rgb = std::uint32_t;

/// The colours of a look, by what they are for. Words on their grounds have a contrast of 4.5 at least, signs and lines
/// that say something one of 3 (WCAG 2.1, AA).
struct Palette {
  bool light;
  // Grounds.
  Rgb panel;    ///< of panels
  Rgb popup;    ///< of what lies above them: menus, dialogs, tips
  Rgb field;    ///< of what is typed into or dragged
  Rgb button;   ///< of ordinary buttons
  Rgb hovered;  ///< of buttons under the pen
  Rgb chosen;   ///< of what is on
  Rgb line;     ///< between groups
  // The one accent.
  Rgb accent;          ///< the ground of the one thing to do now, the playhead, the fill of a slider
  Rgb accent_hovered;  ///< under the pen
  Rgb on_accent;       ///< ink on it
  // Ink.
  Rgb ink;
  Rgb faint;  ///< of what stands beside: hints, units, keys of the keyboard
  // Signs.
  Rgb record;  ///< something is recorded or performed
  Rgb idle;    ///< nothing is
  Rgb error;
  Rgb lit;     ///< a key of a tablet that is pressed; a step of a tour
  Rgb on_lit;  ///< ink on it
  Rgb asks;    ///< ink of what a tour asks again
  // Keys of the timeline.
  Rgb key;
  Rgb key_here;      ///< under the playhead, or dragged
  Rgb key_selected;  ///< in the sheet and in the curves
  Rgb key_group;     ///< of a whole group
  Rgb key_edge;
  Rgb key_camera;  ///< of the camera
  Rgb key_camera_here;
  std::array<Rgb, 6> curves;  ///< of controls in the editor, told apart by all eyes
  // The canvas.
  Rgb canvas_top;
  Rgb canvas_foot;
};

inline constexpr Palette k_dark_palette{
    .light = false,
    .panel = 0x1d1d22,
    .popup = 0x26262d,
    .field = 0x27272e,
    .button = 0x34343e,
    .hovered = 0x40404b,
    .chosen = 0x433a76,
    .line = 0x3a3a44,
    .accent = 0x7459e6,
    .accent_hovered = 0x7a60e6,
    .on_accent = 0xffffff,
    .ink = 0xececf1,
    .faint = 0xb0b0bc,
    .record = 0xe8483a,
    .idle = 0x8a8a96,
    .error = 0xe8604a,
    .lit = 0xffb020,
    .on_lit = 0x141414,
    .asks = 0xffb020,
    .key = 0xffa800,
    .key_here = 0xffd65c,
    .key_selected = 0xffffff,
    .key_group = 0xbe8c3c,
    .key_edge = 0x3c2800,
    .key_camera = 0x58b0f0,
    .key_camera_here = 0xb4e0ff,
    .curves = {0xe69f00, 0x56b4e9, 0x00a57c, 0xdf6a10, 0xcc79a7, 0x5f8fe0},
    .canvas_top = 0x50535c,
    .canvas_foot = 0x2b2c32,
};

inline constexpr Palette k_light_palette{
    .light = true,
    .panel = 0xf3f3f6,
    .popup = 0xffffff,
    .field = 0xe6e6ec,
    .button = 0xdedee6,
    .hovered = 0xd0d0da,
    .chosen = 0xd6cefa,
    .line = 0xcfcfd8,
    .accent = 0x5f45d4,
    .accent_hovered = 0x553bc6,
    .on_accent = 0xffffff,
    .ink = 0x1b1b21,
    .faint = 0x555562,
    .record = 0xcf2f22,
    .idle = 0x7c7c88,
    .error = 0xc43c26,
    .lit = 0xffb020,
    .on_lit = 0x141414,
    .asks = 0x964a00,
    .key = 0xb86a00,
    .key_here = 0x7d3f00,
    .key_selected = 0x1b1b21,
    .key_group = 0x8f6a2c,
    .key_edge = 0x3c2800,
    .key_camera = 0x1f6fae,
    .key_camera_here = 0x123f66,
    .curves = {0x8a5f00, 0x1f78b0, 0x00785a, 0xb84c00, 0xa8467f, 0x3f63b8},
    .canvas_top = 0xe9eaee,
    .canvas_foot = 0xc4c8cf,
};

[[nodiscard]] constexpr const Palette& palette_of(bool light) { return light ? k_light_palette : k_dark_palette; }

/// Colours on the picture, whose ground no look decides.
struct CanvasColors {
  Rgb ink = 0xffffff;     ///< on all of these
  Rgb axis_x = 0xc8394a;  ///< ends of the axes
  Rgb axis_y = 0x3a7d1a;
  Rgb axis_z = 0x2a69c4;
  Rgb name_known = 0x1c3e6e;  ///< the ground of a line's name
  Rgb name_guess = 0x784a0a;  ///< of one that is guessed
  Rgb tour = 0xff9500;   ///< the line that a tour draws: seen on skin, on hair and on both looks, and no curve has it
  Rgb shade = 0x14100a;  ///< around what is drawn for the eye
};
inline constexpr CanvasColors k_canvas_colors;

}  // namespace penpose::app
