#pragma once

#include <cstddef>
#include <string_view>

namespace penpose::io {

// MikuMikuDance's motion: a header of 30 bytes, the model's name, then runs of keys that each start with their number,
// u32: bones of 111 bytes, morphs of 23 (a name of 15, the frame u32, the weight f32), cameras, lights, shadows. Names
// are Shift-JIS and end with a zero byte where they are shorter. Numbers are little-endian; 30 frames make a second.

inline constexpr std::string_view k_vmd_mark = "Vocaloid Motion Data";
inline constexpr std::string_view k_vmd_header = "Vocaloid Motion Data 0002";
inline constexpr std::string_view k_vmd_old_header = "Vocaloid Motion Data file";
/// How many bytes each part has.
struct VmdSizes {
  static constexpr std::size_t header = 30, model = 20, old_model = 10;
  static constexpr std::size_t bone = 111, morph_name = 15, morph = 23;
};
inline constexpr double k_vmd_fps = 30;

}  // namespace penpose::io
