#include "ui/serve/drawing_json.h"

namespace penpose::serve {

using json::Json;

Json line_json(const portrait::LineRead& line, std::span<const portrait::FeatureCurve> curves) {
  if (!line.curve) return {{"curve", Json()}};
  return {{"curve", curves[*line.curve].name}, {"from", line.from}, {"to", line.to}, {"reversed", line.reversed}};
}

}  // namespace penpose::serve
