#include "core/sound/read/read_sound.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sndfile.h>
#include <string>

namespace penpose::sound {
namespace {

constexpr int k_most_channels = 32;
constexpr std::size_t k_block_frames = 16384;
constexpr const char* k_remedy = "give a sound that plays elsewhere, as WAV, FLAC or OGG";

/// Bytes as the file that libsndfile reads.
struct OpenBytes {
  base::Bytes bytes;
  sf_count_t at = 0;

  [[nodiscard]] sf_count_t size() const { return static_cast<sf_count_t>(bytes.size()); }
};

sf_count_t length_of(void* file) { return static_cast<const OpenBytes*>(file)->size(); }

sf_count_t seek_in(sf_count_t offset, int whence, void* file) {
  OpenBytes& open = *static_cast<OpenBytes*>(file);
  // Offsets come from the file: added without overflow.
  const sf_count_t from = whence == SF_SEEK_CUR ? open.at : whence == SF_SEEK_END ? open.size() : 0;
  open.at = std::clamp(offset, -from, open.size() - from) + from;
  return open.at;
}

sf_count_t read_from(void* to, sf_count_t count, void* file) {
  OpenBytes& open = *static_cast<OpenBytes*>(file);
  const sf_count_t taken = std::clamp<sf_count_t>(count, 0, open.size() - open.at);
  std::copy_n(open.bytes.begin() + open.at, taken, static_cast<std::uint8_t*>(to));
  open.at += taken;
  return taken;
}

sf_count_t write_nothing(const void*, sf_count_t, void*) { return 0; }
sf_count_t place_in(void* file) { return static_cast<const OpenBytes*>(file)->at; }

struct Close {
  void operator()(SNDFILE* file) const { sf_close(file); }
};

base::Error wrong_sound(std::string what) { return {std::move(what), "", k_remedy}; }

base::Error too_long() {
  return {"the sound is longer than 67,108,864 samples (23 minutes at 48 kHz)", "", "cut it into scenes"};
}

}  // namespace

bool reads_sounds() { return true; }

base::Result<Sound> read_sound(base::Bytes bytes) {
  if (!looks_like_sound(bytes)) return wrong_sound("the file is no WAV, FLAC or OGG sound");
  OpenBytes open{bytes};
  SF_VIRTUAL_IO calls{length_of, seek_in, read_from, write_nothing, place_in};
  SF_INFO info{};
  const std::unique_ptr<SNDFILE, Close> file(sf_open_virtual(&calls, SFM_READ, &info, &open));
  if (!file) {
    std::string why = sf_strerror(nullptr);
    std::replace(why.begin(), why.end(), '\n', ' ');
    while (why.ends_with('.') || why.ends_with(' ')) why.pop_back();
    return wrong_sound("the sound cannot be read (libsndfile: " + why + ")");
  }
  if (info.channels < 1 || info.channels > k_most_channels) return wrong_sound("the sound has more than 32 channels");
  if (info.samplerate < k_least_rate_hz || info.samplerate > k_most_rate_hz)
    return wrong_sound("the sound has " + std::to_string(info.samplerate) + " samples a second, not 4000 to 384000");
  // What the header says of its length is not believed: blocks are read until there is no more.
  Sound sound{info.samplerate, {}};
  const auto channels = static_cast<std::size_t>(info.channels);
  std::vector<float> block(k_block_frames * channels);
  while (true) {
    const sf_count_t got = sf_readf_float(file.get(), block.data(), k_block_frames);
    if (got <= 0) break;
    const auto frames = std::min(static_cast<std::size_t>(got), k_block_frames);
    if (sound.samples.size() + frames > k_most_samples) return too_long();
    for (std::size_t f = 0; f < frames; ++f) {
      float sum = 0;
      for (std::size_t c = 0; c < channels; ++c) {
        const float sample = block[f * channels + c];
        if (!std::isnan(sample)) sum += std::clamp(sample, -1.0F, 1.0F);
      }
      sound.samples.push_back(sum / static_cast<float>(channels));
    }
  }
  if (sound.samples.empty()) return wrong_sound("the sound has no samples");
  return sound;
}

}  // namespace penpose::sound
