#include "ui/film/film_sound.h"

#include <bit>
#include <string_view>

#include "core/sound/mix.h"

namespace penpose::film {
namespace {

void put_text(std::vector<std::uint8_t>& bytes, std::string_view text) {
  bytes.insert(bytes.end(), text.begin(), text.end());
}

void put(std::vector<std::uint8_t>& bytes, std::uint32_t number, int width) {
  for (int i = 0; i < width; ++i) bytes.push_back(static_cast<std::uint8_t>(number >> (8 * i)));
}

}  // namespace

base::Result<sound::Sound> sound_of_frames(const sound::Sound& sound, double offset_s, int first, std::size_t frames,
                                           double rate) {
  const int rate_hz = sound.rate_hz;
  const std::int64_t begin = sound::sample_of(first / rate, rate_hz);
  const std::int64_t end = sound::sample_of((first + static_cast<double>(frames)) / rate, rate_hz);
  if (end - begin > k_most_film_samples) {
    return base::Error{"the sound of so long a film finds no room", "", "film fewer frames, or without the sound"};
  }
  sound::Sound part;
  part.rate_hz = rate_hz;
  part.samples.resize(static_cast<std::size_t>(end - begin));
  sound::mix(sound, offset_s, begin, part.samples);
  return part;
}

std::vector<std::uint8_t> wav_bytes(const sound::Sound& sound) {
  constexpr std::uint32_t k_sample_bytes = 4, k_format_bytes = 16, k_float = 3, k_channels = 1;
  const auto data = static_cast<std::uint32_t>(sound.samples.size() * k_sample_bytes);
  const auto rate = static_cast<std::uint32_t>(sound.rate_hz);
  std::vector<std::uint8_t> bytes;
  bytes.reserve(44 + std::size_t{data});
  put_text(bytes, "RIFF");
  put(bytes, 36 + data, 4);
  put_text(bytes, "WAVEfmt ");
  put(bytes, k_format_bytes, 4);
  put(bytes, k_float, 2);
  put(bytes, k_channels, 2);
  put(bytes, rate, 4);
  put(bytes, rate * k_sample_bytes, 4);
  put(bytes, k_sample_bytes, 2);
  put(bytes, 8 * k_sample_bytes, 2);
  put_text(bytes, "data");
  put(bytes, data, 4);
  for (const float sample : sound.samples) put(bytes, std::bit_cast<std::uint32_t>(sample), 4);
  return bytes;
}

}  // namespace penpose::film
