#include "core/io/project/internal/project_face.h"

#include <memory>
#include <utility>

#include "core/curve/polyline.h"
#include "core/document/commands/command_text.h"

namespace penpose::io {
namespace {

using document::FaceDrawing;
using document::FaceLine;

/// A text that may be missing.
Problem read_text(const json::Json& object, const char* name, const std::string& pointer,
                  std::optional<std::string>& out) {
  const json::Json* value = json::find(object, name);
  if (value == nullptr) return std::nullopt;
  if (!value->is_string()) return project_error("a name was expected", json::child(pointer, name));
  out = value->get<std::string>();
  return std::nullopt;
}

Problem read_line(const json::Json& value, const std::string& pointer, std::uint32_t last, FaceLine& out) {
  const json::Json* id = json::find(value, "id");
  const auto number = id == nullptr ? std::nullopt : json::whole_number(*id, 1, last);
  if (!number) return project_error("a line's number was expected, at most \"last_curve\"", json::child(pointer, "id"));
  out.id = document::CurveId{static_cast<std::uint32_t>(*number)};
  const auto point = [&](const std::vector<double>& row, const std::string&) -> Problem {
    out.line.push_back({row[0], row[1]});
    return std::nullopt;
  };
  if (auto problem = read_rows(value, "line", pointer, 2, document::k_line_points, point)) return problem;
  if (out.line.size() < 2 || !(curve::arc_length<curve::PxPoint>(out.line) > 0.0))
    return project_error("a line of at least two points was expected", json::child(pointer, "line"));
  std::optional<std::string> feature;
  if (auto problem = read_text(value, "feature", pointer, feature)) return problem;
  out.feature = feature.value_or("");
  return read_text(value, "said", pointer, out.said);
}

Problem read_face(const json::Json& project, const char* name, const std::string& pointer,
                  const document::Document& document, std::shared_ptr<const FaceDrawing>& out) {
  const json::Json* value = json::find(project, name);
  if (value == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, name);
  FaceDrawing face;
  if (auto problem = read_view(*value, here, face.view)) return problem;
  const json::Json* time = json::find(*value, "time_s");
  const auto seconds = time == nullptr ? std::nullopt : json::number(*time);
  if (!seconds || !(*seconds >= 0 && *seconds <= document::k_latest_key_s))
    return project_error("a moment was expected", json::child(here, "time_s"));
  face.time_s = *seconds;
  const json::Json* middle = json::find(*value, "middle");
  std::vector<double> row;
  if (middle == nullptr) return project_error("a place was expected", json::child(here, "middle"));
  if (auto problem = read_row(*middle, json::child(here, "middle"), 3, row)) return problem;
  face.middle = {row[0], row[1], row[2]};
  const json::Json* lines = json::find(*value, "lines");
  const std::string list = json::child(here, "lines");
  if (lines == nullptr || !lines->is_array() || lines->empty() || lines->size() > document::k_most_face_lines)
    return project_error("a list of 1 to 60 lines was expected", list);
  for (std::size_t i = 0; i < lines->size(); ++i) {
    const std::string at = json::child(list, i);
    FaceLine line;
    if (auto problem = read_line((*lines)[i], at, document.last_curve, line)) return problem;
    for (const FaceLine& other : face.lines) {
      if (other.id == line.id) return project_error("a number of its own was expected", json::child(at, "id"));
    }
    face.lines.push_back(std::move(line));
  }
  out = std::make_shared<const FaceDrawing>(std::move(face));
  return std::nullopt;
}

}  // namespace

Problem read_project_face(const json::Json& project, const std::string& pointer, document::Document& out) {
  if (auto problem = read_face(project, "face", pointer, out, out.face)) return problem;
  return read_face(project, "neutral", pointer, out, out.neutral);
}

json::Json face_to_json(const FaceDrawing& face) {
  json::Json lines = json::Json::array();
  for (const FaceLine& line : face.lines) {
    json::Json points = json::Json::array();
    for (const curve::PxPoint& p : line.line) points.push_back({p.x, p.y});
    json::Json one = {{"id", line.id.value}, {"line", std::move(points)}};
    if (!line.feature.empty()) one["feature"] = line.feature;
    if (line.said) one["said"] = *line.said;
    lines.push_back(std::move(one));
  }
  return {{"view", document::to_text(face.view)},
          {"middle", {face.middle.x, face.middle.y, face.middle.z}},
          {"time_s", face.time_s},
          {"lines", std::move(lines)}};
}

}  // namespace penpose::io
