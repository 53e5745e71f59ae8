#include <algorithm>
#include <cmath>

#include "core/io/tracks/cues/cue_file.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "core/io/tracks/track_rows.h"

namespace penpose::io {
namespace {

constexpr std::size_t k_most_cue_shapes = 200;

base::Error wrong_track(std::string what, std::string place) {
  return {std::move(what), std::move(place), "cut the file into shorter ones"};
}

/// "mouth cue D" of Rhubarb's shapes A to H and X, "mouth cue MBP" of those of Preston Blair, whose E is "mouth cue
/// E.".
std::string cue_name(const CueFile& cues, const CueFile::Cue& cue) {
  return "mouth cue " + cue.shape + (cues.blair && cue.shape == "E" ? "." : "");
}

/// How far the shape of a cue is taken at a time, 0..1: one goes over into the next over `k_fade_s` to each side, or
/// less between short ones.
class Fade {
 public:
  Fade(const std::vector<CueFile::Cue>& cues, double end) : cues_(cues), end_(end) {}
  [[nodiscard]] double begun(std::size_t cue, double time) const {
    if (cue == 0) return 1;
    if (cue >= cues_.size()) return 0;
    const double at = cues_[cue].start_s;
    const double after = (cue + 1 < cues_.size() ? cues_[cue + 1].start_s : std::max(end_, at)) - at;
    const double half = std::min({k_fade_s, (at - cues_[cue - 1].start_s) / 2, after / 2});
    if (half <= 0) return time >= at ? 1 : 0;
    return std::clamp((time - at + half) / (2 * half), 0.0, 1.0);
  }

 private:
  static constexpr double k_fade_s = 0.04;
  const std::vector<CueFile::Cue>& cues_;
  double end_;
};

base::Result<animation::WeightTrack> make_track(const CueFile& cues) {
  animation::WeightTrack track;
  std::vector<std::size_t> shapes;
  for (const CueFile::Cue& cue : cues.list) {
    const std::string name = cue_name(cues, cue);
    auto at = std::find(track.names.begin(), track.names.end(), name);
    if (at == track.names.end()) {
      if (track.names.size() == k_most_cue_shapes) return wrong_track("there are over 200 mouth shapes", cue.place);
      at = track.names.insert(at, name);
    }
    shapes.push_back(static_cast<std::size_t>(at - track.names.begin()));
  }
  const double end = std::clamp(cues.end_s, cues.list.back().start_s, cues.list.back().start_s + k_longest_pause_s);
  const double count = std::ceil(end * cues.fps - 1e-6) + 1;
  if (!(count <= static_cast<double>(k_most_track_frames)) || count * static_cast<double>(track.names.size()) > 5e7) {
    return wrong_track("the cues take too many frames", cues.list.back().place);
  }
  const Fade fade(cues.list, end);
  std::size_t first = 0;
  for (std::size_t f = 0; f < static_cast<std::size_t>(count); ++f) {
    const double time = static_cast<double>(f) / cues.fps;
    auto& frame =
        track.frames.emplace_back(animation::WeightFrame{time, true, std::vector<double>(track.names.size())});
    while (first + 1 < cues.list.size() && fade.begun(first + 1, time) >= 1) ++first;
    for (std::size_t c = first; c < cues.list.size(); ++c) {
      const double begun = fade.begun(c, time);
      if (begun <= 0) break;
      frame.values[shapes[c]] += begun - fade.begun(c + 1, time);
    }
  }
  return track;
}

}  // namespace

base::Result<animation::WeightTrack> read_cue_track(base::Bytes bytes, base::Bytes dictionary) {
  const auto cues = read_cues(bytes, dictionary);
  if (!cues) return cues.error();
  auto track = make_track(*cues);
  if (track) track->notes = cues->notes;
  if (track && cues->counts_frames) {
    track->rate_note =
        "the file counts frames and does not say how many make a second: 24 are taken; --stretch sets another rate";
  }
  return track;
}

TrackFormat cues_format() {
  return {"cues",
          6,
          true,
          [](const TrackText& text) { return looks_like_cues(text.text); },
          [](base::Bytes bytes, std::optional<PictureSize>) { return as_track(read_cue_track(bytes)); },
          [](base::Bytes bytes, base::Bytes dictionary) { return as_track(read_cue_track(bytes, dictionary)); }};
}

}  // namespace penpose::io
