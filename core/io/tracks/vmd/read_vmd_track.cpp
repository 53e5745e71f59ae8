#include <algorithm>
#include <cmath>
#include <map>

#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "core/io/tracks/vmd/shift_jis.h"
#include "core/io/tracks/vmd/vmd_layout.h"

namespace penpose::io {
namespace {

base::Error wrong(std::string what, std::size_t offset) {
  return {std::move(what), "byte offset " + std::to_string(offset),
          "export the motion again as .vmd with its morph keys"};
}

struct VmdKey {
  std::uint32_t frame = 0;
  double weight = 0;
};

/// The keys of one morph at every frame, linear between them as MikuMikuDance has them.
void fill(std::vector<VmdKey>& keys, std::size_t column, std::vector<animation::WeightFrame>& frames) {
  std::stable_sort(keys.begin(), keys.end(), [](const VmdKey& a, const VmdKey& b) { return a.frame < b.frame; });
  std::size_t after = 0;
  for (std::size_t f = 0; f < frames.size(); ++f) {
    while (after < keys.size() && keys[after].frame <= f) ++after;
    double value = after == 0 ? keys.front().weight : keys[after - 1].weight;
    if (after > 0 && after < keys.size()) {
      const VmdKey& a = keys[after - 1];
      const VmdKey& b = keys[after];
      value += (b.weight - a.weight) * static_cast<double>(f - a.frame) / static_cast<double>(b.frame - a.frame);
    }
    frames[f].values[column] = value;
  }
}

}  // namespace

base::Result<animation::WeightTrack> read_vmd_track(base::Bytes bytes) {
  if (!base::as_text(bytes).starts_with(k_vmd_mark)) return wrong("this is no motion of MikuMikuDance", 0);
  base::ByteReader reader(bytes);
  const bool old = base::as_text(bytes).starts_with(k_vmd_old_header);
  if (!reader.take(VmdSizes::header) || !reader.take(old ? VmdSizes::old_model : VmdSizes::model)) {
    return wrong("the file ends in its header", bytes.size());
  }
  const auto bones = reader.read<std::uint32_t>();
  if (!bones || *bones > reader.remaining() / VmdSizes::bone) {
    return wrong("the file ends in its keys of bones", bytes.size());
  }
  (void)reader.take(*bones * VmdSizes::bone);
  const auto morphs = reader.read<std::uint32_t>();
  const std::size_t begin = reader.offset();
  if (morphs && *morphs > reader.remaining() / VmdSizes::morph) {
    return wrong("the file ends in its keys of morphs", bytes.size());
  }
  if (!morphs || *morphs == 0) return wrong("the motion has no keys of morphs", begin);
  std::map<std::string, std::vector<VmdKey>, std::less<>> keys;
  std::uint32_t last = 0;
  bool moves = false;
  for (std::uint32_t i = 0; i < *morphs; ++i) {
    const std::size_t offset = reader.offset();
    const auto name = reader.take(VmdSizes::morph_name);
    const auto frame = reader.read<std::uint32_t>();
    const auto weight = reader.read_f32();
    if (!name || !frame || !weight) return wrong("the file ends in its keys of morphs", offset);
    if (*frame >= k_most_track_frames) return wrong("a track has at most 1,000,000 frames", offset);
    if (!(std::abs(*weight) < 1e6F)) return wrong("the weight is no number", offset);
    keys[utf8_of_shift_jis(*name)].push_back({*frame, static_cast<double>(*weight)});
    last = std::max(last, *frame);
    moves = moves || *weight != 0;
  }
  // Programs write a key for every morph that the model has.
  if (moves) {
    std::erase_if(keys, [](const auto& morph) {
      return std::all_of(morph.second.begin(), morph.second.end(), [](const VmdKey& key) { return key.weight == 0; });
    });
  }
  constexpr double k_most_vmd_values = 5e7;
  if ((1.0 + last) * static_cast<double>(keys.size()) > k_most_vmd_values) {
    return wrong("the motion has over 50,000,000 values", begin);
  }
  animation::WeightTrack track;
  for (std::size_t f = 0; f <= last; ++f) {
    track.frames.push_back({static_cast<double>(f) / k_vmd_fps, true, std::vector<double>(keys.size())});
  }
  for (auto& [name, list] : keys) {
    fill(list, track.names.size(), track.frames);
    track.names.push_back(name);
  }
  if (*bones > 0) track.notes.push_back(std::to_string(*bones) + " keys of bones are left out; only morphs are read");
  return track;
}

TrackFormat vmd_format() {
  return {"vmd", 7, true, [](const TrackText& text) { return text.text.starts_with(k_vmd_mark); },
          [](base::Bytes bytes, std::optional<PictureSize>) { return as_track(read_vmd_track(bytes)); }};
}

}  // namespace penpose::io
