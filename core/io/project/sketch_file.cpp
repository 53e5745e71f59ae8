#include "core/io/project/sketch_file.h"

#include <array>
#include <set>
#include <string_view>

#include "core/base/json/json.h"
#include "core/io/project/internal/sketch_json.h"

namespace penpose::io {
namespace {

constexpr const char* k_see_format = "see the format of sketch files in the manual";

constexpr std::array<std::string_view, 4> k_members = {"model", "viewport", "deformers", "corrections"};
constexpr std::array<std::string_view, 18> k_deformer_members = {
    "name",      "viewport", "camera",   "reference_camera", "target_camera", "general", "specific",
    "reference", "target",   "mode",     "surface",          "range",         "paper",   "sheet",
    "reach",     "piece",    "betweens", "drivers"};

}  // namespace

base::Result<SketchFile> read_sketch_file(base::Bytes bytes) {
  const auto json = json::parse_json(bytes);
  if (!json) return json.error();
  if (!json->is_object()) return base::Error{"an object was expected", "/", k_see_format};
  SketchFile file;
  if (const json::Json* model = json::find(*json, "model")) {
    if (!model->is_string()) return base::Error{"a text was expected", "/model", k_see_format};
    file.model = model->get<std::string>();
  }
  std::optional<geometry::Viewport> viewport;
  if (auto problem = read_viewport(*json, "", viewport)) return *problem;
  if (viewport) file.viewport = *viewport;
  const json::Json* deformers = json::find(*json, "deformers");
  if (deformers == nullptr) return base::Error{"the key \"deformers\" is missing", "/", k_see_format};
  if (!deformers->is_array()) return base::Error{"a list was expected", "/deformers", k_see_format};
  if (deformers->size() > k_most_deformers) {
    return base::Error{"a model has at most 1,000 deformers", "/deformers", "split the file"};
  }
  std::set<std::string> names;
  json::list_unknown(*json, "", k_members, file.skipped);
  for (std::size_t i = 0; i < deformers->size(); ++i) {
    const std::string pointer = json::child("/deformers", i);
    file.sketches.emplace_back();
    if (auto problem = read_sketch((*deformers)[i], pointer, viewport, file.sketches.back())) return *problem;
    json::list_unknown((*deformers)[i], pointer, k_deformer_members, file.skipped);
    if (!names.insert(file.sketches.back().name).second) {
      return base::Error{"another control is called '" + file.sketches.back().name + "' too", pointer + "/name",
                         "rename one of them"};
    }
  }
  const json::Json* corrections = json::find(*json, "corrections");
  if (corrections == nullptr) return file;
  if (!corrections->is_array()) return base::Error{"a list was expected", "/corrections", k_see_format};
  if (corrections->size() > k_most_corrections) {
    return base::Error{"a model has at most 100 corrections", "/corrections", "split the file"};
  }
  for (std::size_t i = 0; i < corrections->size(); ++i) {
    const std::string pointer = json::child("/corrections", i);
    articulation::CorrectionSketch& one = file.corrections.emplace_back();
    if (auto problem = read_sketch((*corrections)[i], pointer, viewport, one.sketch)) return *problem;
    if (auto problem = read_drivers((*corrections)[i], pointer, one.drivers)) return *problem;
    json::list_unknown((*corrections)[i], pointer, k_deformer_members, file.skipped);
    if (!names.insert(one.sketch.name).second) {
      return base::Error{"another control or correction is called '" + one.sketch.name + "' too", pointer + "/name",
                         "rename one of them"};
    }
  }
  return file;
}

std::string write_sketch_file(const SketchFile& file) {
  std::string text =
      "{\"model\": " + json::Json(file.model).dump(-1, ' ', false, json::Json::error_handler_t::replace) +
      ", \"viewport\": " + to_json(file.viewport).dump() + ", \"deformers\": [";
  for (std::size_t i = 0; i < file.sketches.size(); ++i) {
    const Viewports viewports = file.sketches[i].viewport == file.viewport ? Viewports::shared : Viewports::each;
    text += i == 0 ? "\n" : ",\n";
    text += to_json(file.sketches[i], viewports).dump(-1, ' ', false, json::Json::error_handler_t::replace);
  }
  if (file.corrections.empty()) return text + "\n]}\n";
  text += "\n], \"corrections\": [";
  for (std::size_t i = 0; i < file.corrections.size(); ++i) {
    const auto& sketch = file.corrections[i].sketch;
    const Viewports viewports = sketch.viewport == file.viewport ? Viewports::shared : Viewports::each;
    text += (i == 0 ? "\n" : ",\n") +
            to_json(file.corrections[i], viewports).dump(-1, ' ', false, json::Json::error_handler_t::replace);
  }
  return text + "\n]}\n";
}

}  // namespace penpose::io
