#include <algorithm>

#include "core/base/numbers.h"
#include "core/io/text/text_lines.h"
#include "core/io/tracks/cues/internal/cue_reader.h"

namespace penpose::io {
namespace {

constexpr double k_moho_fps = 24;

/// "MohoSwitch1", then a frame from 1 and a shape a line.
CueProblem read_moho(std::string_view text, CueBuilder& cues) {
  cues.frames(k_moho_fps);
  TextLines lines(text);
  while (const auto line = lines.next()) {
    const std::string_view bare = base::trim(*line);
    if (bare.empty() || bare.starts_with("MohoSwitch")) continue;
    const std::size_t gap = std::min(bare.find_first_of("\t "), bare.size());
    auto frame = base::parse_double(bare.substr(0, gap));
    if (frame) frame = std::max(0.0, *frame - 1) / k_moho_fps;
    if (auto problem = cues.shape(frame, base::trim(bare.substr(gap)), "line " + std::to_string(lines.number()))) {
      return problem;
    }
  }
  return std::nullopt;
}

}  // namespace

CueReader moho_reader() {
  return {"Moho (.dat)", "export the switches again with Papagayo or Rhubarb",
          [](std::string_view text) {
            const auto first = text.find_first_not_of(" \t\r\n");
            return first != std::string_view::npos && text.substr(first).starts_with("MohoSwitch");
          },
          read_moho};
}

}  // namespace penpose::io
