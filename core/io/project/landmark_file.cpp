#include "core/io/project/landmark_file.h"

#include "core/base/json/json.h"

namespace penpose::io {
namespace {

base::Error wrong(const char* what, std::string pointer) {
  return {what, std::move(pointer), R"(write {"curves": {NAME: {"vertices": [0, 1, ...]}}})"};
}

}  // namespace

base::Result<std::vector<VertexCurve>> read_landmarks(base::Bytes bytes) {
  const auto json = json::parse_json(bytes);
  if (!json) return json.error();
  const json::Json* listed = json::find(*json, "curves");
  if (listed == nullptr || !listed->is_object()) return wrong("an object of curves was expected", "/curves");
  std::vector<VertexCurve> curves;
  for (const auto& [name, value] : listed->items()) {
    const std::string pointer = json::child(json::child("/curves", name), "vertices");
    const json::Json* vertices = json::find(value, "vertices");
    if (vertices == nullptr || !vertices->is_array()) return wrong("a list of vertices was expected", pointer);
    if (vertices->size() < 2) return wrong("a curve needs at least two points", pointer);
    VertexCurve curve{name, {}};
    for (std::size_t i = 0; i < vertices->size(); ++i) {
      const auto vertex = json::whole_number((*vertices)[i], 0, 0xffffffffLL);
      if (!vertex) return wrong("a vertex number (0 or more) was expected", json::child(pointer, i));
      curve.vertices.push_back(static_cast<std::uint32_t>(*vertex));
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace penpose::io
