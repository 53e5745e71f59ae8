#include "core/sound/read/read_sound.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <sndfile.h>
#include <string>
#include <vector>

#include "core/sound/read/sound_container.h"

namespace penpose::sound {
namespace {

constexpr int k_most_channels = 32;
constexpr std::size_t k_block_frames = 16384;
constexpr const char* k_remedy = "give a sound that plays elsewhere, as WAV, FLAC, OGG or MP3";

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

/// A RIFF file whose chunk of data has no size, or one beyond the end, with the size that it has; empty: it has one.
std::vector<std::uint8_t> with_data_size(base::Bytes bytes) {
  constexpr std::size_t k_head = 12, k_chunk = 8;
  if (!base::as_text(bytes).starts_with("RIFF")) return {};
  const auto size_at = [&](std::size_t at) {
    std::size_t size = 0;
    for (std::size_t i = 4; i-- > 0;) size = size << 8 | bytes[at + i];
    return size;
  };
  for (std::size_t at = k_head; at + k_chunk <= bytes.size();) {
    const std::size_t size = size_at(at + 4), rest = bytes.size() - at - k_chunk;
    if (base::as_text(bytes).substr(at, 4) != "data") {
      at += k_chunk + size + size % 2;
      continue;
    }
    if (rest == 0 || (size > 0 && size <= rest)) return {};
    std::vector<std::uint8_t> out(bytes.begin(), bytes.end());
    const auto put = [&](std::size_t where, std::size_t value) {
      for (std::size_t i = 0; i < 4; ++i) out[where + i] = static_cast<std::uint8_t>(value >> (8 * i));
    };
    put(at + 4, rest);
    put(4, bytes.size() - k_chunk);
    return out;
  }
  return {};
}

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
  const auto container = sound_container(bytes);
  if (!container) return wrong_sound("the file is no sound that is read here");
  if (!container->is_read) {
    return base::Error{"this is " + std::string(container->name) + " sound, which is not read here", "",
                       "give WAV, FLAC, OGG or MP3"};
  }
  bytes = without_id3(bytes);
  const std::vector<std::uint8_t> sized = with_data_size(bytes);
  OpenBytes open{sized.empty() ? bytes : base::Bytes(sized)};
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
