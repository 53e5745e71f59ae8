#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/math.h"

namespace penpose::tests {

/// A tone of a frequency.
inline std::vector<float> tone(double frequency_hz, int rate_hz, double duration_s, double loudness = 0.5) {
  std::vector<float> out;
  const auto count = static_cast<std::size_t>(duration_s * rate_hz + 0.5);
  for (std::size_t i = 0; i < count; ++i)
    out.push_back(
        static_cast<float>(loudness * base::sin(2 * base::k_pi * frequency_hz * static_cast<double>(i) / rate_hz)));
  return out;
}

/// How a WAV file holds its samples.
enum class WavForm : std::uint8_t { pcm16, float32 };

/// A WAV file; samples of its channels by turns.
inline std::vector<std::uint8_t> wav_bytes(const std::vector<float>& samples, int rate_hz, int channels = 1,
                                           WavForm form = WavForm::pcm16) {
  const std::uint32_t width = form == WavForm::pcm16 ? 2 : 4;
  const auto size = static_cast<std::uint32_t>(samples.size()) * width;
  std::vector<std::uint8_t> out;
  const auto text = [&](std::string_view piece) { out.insert(out.end(), piece.begin(), piece.end()); };
  const auto number = [&](std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  };
  text("RIFF");
  number(36 + size, 4);
  text("WAVEfmt ");
  number(16, 4);
  number(form == WavForm::pcm16 ? 1 : 3, 2);
  number(static_cast<std::uint32_t>(channels), 2);
  number(static_cast<std::uint32_t>(rate_hz), 4);
  number(static_cast<std::uint32_t>(rate_hz * channels) * width, 4);
  number(static_cast<std::uint32_t>(channels) * width, 2);
  number(width * 8, 2);
  text("data");
  number(size, 4);
  for (const float sample : samples) {
    if (form == WavForm::float32) {
      number(std::bit_cast<std::uint32_t>(sample), 4);
    } else {
      const auto level = static_cast<std::int16_t>(std::lround(std::clamp(sample, -1.0F, 1.0F) * 32767));
      number(static_cast<std::uint16_t>(level), 2);
    }
  }
  return out;
}

}  // namespace penpose::tests
