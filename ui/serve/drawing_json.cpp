#include "ui/serve/drawing_json.h"

namespace penpose::serve {

using json::Json;

Json line_json(const portrait::LineRead& line, std::span<const portrait::FeatureCurve> curves) {
  if (!line.curve) return {{"curve", Json()}};
  Json row = {{"curve", curves[*line.curve].name}, {"from", line.from}, {"to", line.to}, {"reversed", line.reversed}};
  if (line.lower) row["lower"] = curves[*line.lower].name;
  return row;
}

}  // namespace penpose::serve
