#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/json/loose_json.h"
#include "core/base/numbers.h"
#include "core/base/text/letters.h"
#include "core/io/text/text_lines.h"
#include "core/io/tracks/read_track.h"
#include "core/io/tracks/track_formats.h"
#include "core/io/tracks/track_rows.h"

namespace penpose::io {
namespace {

using Problem = std::optional<base::Error>;

constexpr double k_moho_fps = 24;
constexpr std::size_t k_most_cues = 1'000'000;
constexpr std::size_t k_most_shapes = 200;

/// The mouth takes a shape at a time (s).
struct Cue {
  double start = 0;
  std::string shape;
  std::string place;
};

struct Cues {
  std::vector<Cue> list;
  double end = 0;  ///< of the last; 0: not told
  double fps = k_common_fps;
};

base::Error wrong(std::string what, std::string place) {
  return {std::move(what), std::move(place), "export the cues again with Rhubarb (tsv, xml, json) or Papagayo (.dat)"};
}

Problem add(Cues& cues, std::optional<double> start, std::string_view shape, std::string place) {
  constexpr double k_latest = 1e6;
  if (!start || !(*start >= 0) || !(*start < k_latest))
    return wrong("a time of 0 or more was expected", std::move(place));
  if (shape.empty() || shape.size() > 40) return wrong("the name of a mouth shape was expected", std::move(place));
  if (!cues.list.empty() && *start < cues.list.back().start) {
    return wrong("the cue comes before the one above it", std::move(place));
  }
  if (cues.list.size() >= k_most_cues) return wrong("a track has at most 1,000,000 cues", std::move(place));
  cues.list.push_back({*start, std::string(shape), std::move(place)});
  return std::nullopt;
}

/// "0.05<tab>D".
Problem read_tsv(std::string_view text, Cues& cues) {
  TextLines lines(text);
  while (const auto line = lines.next()) {
    const std::string_view bare = base::trim(*line);
    if (bare.empty()) continue;
    const std::size_t gap = bare.find_first_of("\t ");
    if (gap == std::string_view::npos)
      return lines.error("a time and a mouth shape were expected", "export the cues again");
    if (auto problem = add(cues, base::parse_double(bare.substr(0, gap)), base::trim(bare.substr(gap)),
                           "line " + std::to_string(lines.number()))) {
      return problem;
    }
  }
  return std::nullopt;
}

/// "MohoSwitch1", then a frame from 1 and a shape a line.
Problem read_moho(std::string_view text, Cues& cues) {
  cues.fps = k_moho_fps;
  TextLines lines(text);
  lines.next();
  while (const auto line = lines.next()) {
    const std::string_view bare = base::trim(*line);
    if (bare.empty()) continue;
    const std::size_t gap = std::min(bare.find_first_of("\t "), bare.size());
    auto frame = base::parse_double(bare.substr(0, gap));
    if (frame) frame = std::max(0.0, *frame - 1) / k_moho_fps;
    if (auto problem = add(cues, frame, base::trim(bare.substr(gap)), "line " + std::to_string(lines.number()))) {
      return problem;
    }
  }
  return std::nullopt;
}

Problem read_json(base::Bytes bytes, Cues& cues) {
  const auto root = json::parse_loose_json(bytes);
  if (!root) return root.error();
  const json::Json* list = json::find(*root, "mouthCues");
  if (list == nullptr || !list->is_array()) return wrong("a list of cues was expected", "/mouthCues");
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string place = json::child("/mouthCues", i);
    const json::Json* start = json::find((*list)[i], "start");
    const json::Json* end = json::find((*list)[i], "end");
    const json::Json* value = json::find((*list)[i], "value");
    if (start == nullptr || value == nullptr || !value->is_string()) return wrong("a cue was expected", place);
    if (auto problem = add(cues, json::number(*start), value->get_ref<const std::string&>(), place)) return problem;
    if (end != nullptr) cues.end = json::number(*end).value_or(cues.end);
  }
  return std::nullopt;
}

std::string_view attribute(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    std::string_view rest = base::trim(tag.substr(at + name.size()));
    if (!rest.starts_with('=')) continue;
    rest = base::trim(rest.substr(1));
    if (rest.empty() || (rest[0] != '"' && rest[0] != '\'')) continue;
    const std::size_t end = rest.find(rest[0], 1);
    return end == std::string_view::npos ? std::string_view() : rest.substr(1, end - 1);
  }
  return {};
}

/// <mouthCue start="0.00" end="0.05">X</mouthCue>.
Problem read_xml(std::string_view text, Cues& cues) {
  constexpr std::string_view k_tag = "<mouthCue ";
  for (std::size_t at = text.find(k_tag); at != std::string_view::npos; at = text.find(k_tag, at + 1)) {
    const std::string place = "byte offset " + std::to_string(at);
    const std::size_t close = text.find('>', at);
    const std::size_t end = close == std::string_view::npos ? close : text.find('<', close);
    if (end == std::string_view::npos) return wrong("the cue does not end", place);
    const std::string_view tag = text.substr(at + k_tag.size() - 1, close - at - k_tag.size() + 1);
    if (auto problem = add(cues, base::parse_double(attribute(tag, "start")),
                           base::trim(text.substr(close + 1, end - close - 1)), place)) {
      return problem;
    }
    if (const auto last = base::parse_double(attribute(tag, "end"))) cues.end = *last;
  }
  return std::nullopt;
}

bool is_xml(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] == '<';
}

bool is_moho(std::string_view text) { return base::trim(text).starts_with("MohoSwitch"); }

bool is_one_of(std::string_view name, std::initializer_list<const char*> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* one) { return base::same_but_case(name, one); });
}

/// "mouth cue D" of Rhubarb's shapes A to H and X, "mouth cue MBP" of those of Preston Blair, whose E is "mouth cue
/// E.".
void name_shapes(Cues& cues) {
  constexpr std::array<const char*, 10> k_blair{"AI", "E", "O", "U", "etc", "L", "WQ", "MBP", "FV", "rest"};
  const bool blair = std::any_of(cues.list.begin(), cues.list.end(), [](const Cue& cue) {
    return is_one_of(cue.shape, {"AI", "O", "U", "etc", "L", "WQ", "MBP", "FV", "rest"});
  });
  for (Cue& cue : cues.list) {
    for (const char* name : k_blair) {
      if (blair && base::same_but_case(cue.shape, name)) cue.shape = name;
    }
    if (!blair && cue.shape.size() == 1) cue.shape[0] = base::upper(cue.shape[0]);
    cue.shape = "mouth cue " + cue.shape;
    if (blair && cue.shape == "mouth cue E") cue.shape += '.';
  }
}

/// How far the shape of a cue is taken at a time, 0..1: one goes over into the next over `k_fade_s` to each side, or
/// less between short ones.
class Fade {
 public:
  Fade(const std::vector<Cue>& cues, double end) : cues_(cues), end_(end) {}
  [[nodiscard]] double begun(std::size_t cue, double time) const {
    if (cue == 0) return 1;
    if (cue >= cues_.size()) return 0;
    const double at = cues_[cue].start;
    const double after = (cue + 1 < cues_.size() ? cues_[cue + 1].start : std::max(end_, at)) - at;
    const double half = std::min({k_fade_s, (at - cues_[cue - 1].start) / 2, after / 2});
    if (half <= 0) return time >= at ? 1 : 0;
    return std::clamp((time - at + half) / (2 * half), 0.0, 1.0);
  }

 private:
  static constexpr double k_fade_s = 0.04;
  const std::vector<Cue>& cues_;
  double end_;
};

base::Result<animation::WeightTrack> make_track(const Cues& cues) {
  animation::WeightTrack track;
  std::vector<std::size_t> shapes;
  for (const Cue& cue : cues.list) {
    auto at = std::find(track.names.begin(), track.names.end(), cue.shape);
    if (at == track.names.end()) {
      if (track.names.size() == k_most_shapes) return wrong("there are over 200 mouth shapes", cue.place);
      at = track.names.insert(at, cue.shape);
    }
    shapes.push_back(static_cast<std::size_t>(at - track.names.begin()));
  }
  const double end = std::clamp(cues.end, cues.list.back().start, cues.list.back().start + k_longest_pause_s);
  const double count = std::ceil(end * cues.fps - 1e-6) + 1;
  if (!(count <= static_cast<double>(k_most_track_frames)) || count * static_cast<double>(track.names.size()) > 5e7) {
    return wrong("the cues take too many frames", cues.list.back().place);
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

base::Result<animation::WeightTrack> read_cue_track(base::Bytes bytes) {
  const std::string_view text = base::without_mark(base::as_text(bytes));
  Cues cues;
  Problem problem;
  if (looks_like_json(bytes)) {
    problem = read_json(bytes, cues);
  } else if (is_xml(text)) {
    problem = read_xml(text, cues);
  } else if (is_moho(text)) {
    problem = read_moho(text, cues);
  } else {
    problem = read_tsv(text, cues);
  }
  if (problem) return *problem;
  if (cues.list.empty()) return wrong("there is no cue", "line 1");
  name_shapes(cues);
  auto track = make_track(cues);
  if (track && is_moho(text)) {
    track->rate_note =
        "the file counts frames and does not say how many make a second: 24 are taken; --fps sets another rate";
  }
  return track;
}

TrackFormat cues_format() {
  return {"cues", 6, true,
          [](const TrackText& text) {
            if (text.json) return text.mentions("\"mouthCues\"");
            const std::string_view bare = base::without_mark(text.text);
            if (is_moho(bare.substr(0, 200))) return true;
            if (is_xml(bare.substr(0, 200))) return text.mentions("<mouthCue");
            // A time, a tab and a letter.
            const std::string_view line = base::trim(bare.substr(0, std::min(bare.find_first_of("\r\n"), bare.size())));
            const std::size_t tab = line.find('\t');
            if (tab == std::string_view::npos || !base::parse_double(line.substr(0, tab))) return false;
            const std::string_view shape = base::trim(line.substr(tab));
            return is_one_of(shape, {"A", "B", "C", "D", "E", "F", "G", "H", "X"});
          },
          [](base::Bytes bytes, std::optional<PictureSize>) { return as_track(read_cue_track(bytes)); }};
}

}  // namespace penpose::io
