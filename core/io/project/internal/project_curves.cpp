#include "core/io/project/internal/project_curves.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/document/commands/command_text.h"
#include "core/document/time/timeline.h"

namespace penpose::io {
namespace {

using document::Document;
using document::PoseCurve;
using document::PoseCurveRole;

Problem read_target(const json::Json& value, const std::string& pointer, std::size_t points,
                    document::DrawnTarget& out) {
  if (auto problem = read_view(value, pointer, out.view)) return problem;
  const auto line = [&](const std::vector<double>& row, const std::string& at) -> Problem {
    out.line.push_back({row[0], row[1]});
    if (!(row[2] >= 0 && row[2] <= 1)) return project_error("a pressure from 0 to 1 was expected", at);
    out.pressure.push_back(row[2]);
    return std::nullopt;
  };
  if (auto problem = read_rows(value, "line", pointer, 3, articulation::k_most_points, line)) return problem;
  const auto point = [&](const std::vector<double>& row, const std::string& at) -> Problem {
    if (row[3] < 0) return project_error("a weight is negative", at);
    out.points.emplace_back(row[0], row[1], row[2]);
    out.weights.push_back(row[3]);
    return std::nullopt;
  };
  if (auto problem = read_rows(value, "points", pointer, 4, articulation::k_most_points, point)) return problem;
  if (out.points.size() != points || out.line.size() == 1) {
    return project_error("a target with one point for each of its reference was expected", pointer);
  }
  const bool pulls = std::any_of(out.weights.begin(), out.weights.end(), [](double w) { return w > 0; });
  if (!pulls) return project_error("weights that are not all zero were expected", pointer);
  return std::nullopt;
}

Problem read_curve(const json::Json& value, const std::string& pointer, std::size_t triangles, PoseCurve& out) {
  const json::Json* id = json::find(value, "id");
  const auto number_of = id == nullptr ? std::nullopt : json::whole_number(*id, 1, 0xffffffffLL);
  if (!number_of) return project_error("a curve's number was expected", json::child(pointer, "id"));
  out.id = document::CurveId{static_cast<std::uint32_t>(*number_of)};
  const json::Json* role = json::find(value, "role");
  if (role == nullptr || (*role != "reference" && *role != "constraint")) {
    return project_error("\"reference\" or \"constraint\" was expected", json::child(pointer, "role"));
  }
  out.role = *role == "reference" ? PoseCurveRole::reference : PoseCurveRole::constraint;
  const auto point = [&](const std::vector<double>& row, const std::string& at) -> Problem {
    const bool on_mesh = row[0] >= 0 && row[0] < static_cast<double>(triangles) && row[0] == std::floor(row[0]);
    const double least = std::min({row[1], row[2], row[3]});
    if (!on_mesh || !(least >= -1e-6) || !(std::abs(row[1] + row[2] + row[3] - 1.0) < 1e-6)) {
      return project_error("the point is not on the mesh", at);
    }
    out.points.push_back({static_cast<std::uint32_t>(row[0]), {row[1], row[2], row[3]}});
    return std::nullopt;
  };
  if (auto problem = read_rows(value, "points", pointer, 4, articulation::k_most_points, point)) return problem;
  const auto kept = [&](const std::vector<double>& row, const std::string&) -> Problem {
    out.kept.emplace_back(row[0], row[1], row[2]);
    return std::nullopt;
  };
  if (auto problem = read_rows(value, "kept", pointer, 3, articulation::k_most_points, kept)) return problem;
  const auto aside = [&](const std::vector<double>& row, const std::string&) -> Problem {
    out.aside.emplace_back(row[0], row[1], row[2]);
    return std::nullopt;
  };
  if (auto problem = read_rows(value, "aside", pointer, 3, articulation::k_most_points, aside)) return problem;
  if (!out.aside.empty() && out.aside.size() != out.points.size())
    return project_error("as many vectors as points were expected", json::child(pointer, "aside"));
  const bool fits = out.kept.size() == (out.role == PoseCurveRole::constraint ? out.points.size() : 0);
  if (out.points.empty() || !fits) return project_error("the curve's lists do not fit each other", pointer);
  if (const json::Json* time = json::find(value, "time_s"); time != nullptr) {
    const auto seconds = json::number(*time);
    if (!seconds || !(*seconds >= 0 && *seconds <= document::k_latest_key_s))
      return project_error("a moment of the timeline was expected", json::child(pointer, "time_s"));
    out.time_s = *seconds;
  }
  if (const json::Json* target = json::find(value, "target"); target != nullptr) {
    if (out.role == PoseCurveRole::constraint)
      return project_error("a constraint has no target", json::child(pointer, "target"));
    out.target.emplace();
    return read_target(*target, json::child(pointer, "target"), out.points.size(), *out.target);
  }
  return std::nullopt;
}

json::Json row(const geometry::ModelPoint& p) { return {p.x, p.y, p.z}; }

}  // namespace

Problem read_project_curves(const json::Json& project, const std::string& pointer, Document& out) {
  const json::Json* last = json::find(project, "last_curve");
  if (last != nullptr) {
    const auto n = json::whole_number(*last, 0, 0xffffffffLL);
    if (!n) return project_error("a curve's number was expected", json::child(pointer, "last_curve"));
    out.last_curve = static_cast<std::uint32_t>(*n);
  }
  const json::Json* curves = json::find(project, "curves");
  if (curves == nullptr) return std::nullopt;
  const std::string here = json::child(pointer, "curves");
  if (!curves->is_array() || curves->size() > k_most_curves)
    return project_error("a list of curves was expected", here);
  for (std::size_t i = 0; i < curves->size(); ++i) {
    if (!(*curves)[i].is_object()) return project_error("an object was expected", json::child(here, i));
    PoseCurve curve;
    if (auto problem = read_curve((*curves)[i], json::child(here, i), out.model->mesh->triangle_count(), curve)) {
      return problem;
    }
    if (curve.id.value > out.last_curve || find_curve(out, curve.id) != nullptr) {
      return project_error("a curve's number is used twice or above the last one",
                           json::child(json::child(here, i), "id"));
    }
    out.curves.push_back(std::make_shared<const PoseCurve>(std::move(curve)));
  }
  return std::nullopt;
}

json::Json curve_to_json(const PoseCurve& curve) {
  json::Json points = json::Json::array();
  for (const mesh::MeshPoint& p : curve.points) {
    points.push_back({p.triangle, p.barycentric[0], p.barycentric[1], p.barycentric[2]});
  }
  const bool constraint = curve.role == PoseCurveRole::constraint;
  json::Json out = {
      {"id", curve.id.value}, {"role", constraint ? "constraint" : "reference"}, {"points", std::move(points)}};
  if (constraint) {
    json::Json kept = json::Json::array();
    for (const auto& p : curve.kept) kept.push_back(row(p));
    out["kept"] = std::move(kept);
  }
  if (!curve.aside.empty()) {
    json::Json aside = json::Json::array();
    for (const auto& v : curve.aside) aside.push_back(row(v));
    out["aside"] = std::move(aside);
  }
  if (curve.time_s != 0.0) out["time_s"] = curve.time_s;
  if (!curve.target) return out;
  const document::DrawnTarget& target = *curve.target;
  json::Json line = json::Json::array();
  for (std::size_t i = 0; i < target.line.size(); ++i) {
    line.push_back({target.line[i].x, target.line[i].y, target.pressure[i]});
  }
  json::Json lifted = json::Json::array();
  for (std::size_t i = 0; i < target.points.size(); ++i) {
    const geometry::ModelPoint& p = target.points[i];
    lifted.push_back({p.x, p.y, p.z, target.weights[i]});
  }
  out["target"] = {{"view", document::to_text(target.view)}, {"line", std::move(line)}, {"points", std::move(lifted)}};
  return out;
}

}  // namespace penpose::io
