#include "core/model_io/sketch_file.h"

#include <array>
#include <set>
#include <string_view>

#include "core/model_io/json.h"
#include "core/model_io/sketch_json.h"

namespace penpose::model_io {
namespace {

constexpr const char* k_see_format = "see the format of sketch files in the manual";

constexpr std::array<std::string_view, 3> k_members = {"model", "viewport", "deformers"};
constexpr std::array<std::string_view, 14> k_deformer_members = {
    "name",      "viewport", "camera", "reference_camera", "target_camera", "general", "specific",
    "reference", "target",   "mode",   "surface",          "range",         "rules",   "sheet"};

}  // namespace

base::Result<SketchFile> read_sketch_file(base::Bytes bytes) {
  const auto json = parse_json(bytes);
  if (!json) return json.error();
  if (!json->is_object()) return base::Error{"an object was expected", "/", k_see_format};
  SketchFile file;
  if (const Json* model = find(*json, "model")) {
    if (!model->is_string()) return base::Error{"a text was expected", "/model", k_see_format};
    file.model = model->get<std::string>();
  }
  std::optional<geometry::Viewport> viewport;
  if (auto problem = read_viewport(*json, "", viewport)) return *problem;
  if (viewport) file.viewport = *viewport;
  const Json* deformers = find(*json, "deformers");
  if (deformers == nullptr) return base::Error{"the key \"deformers\" is missing", "/", k_see_format};
  if (!deformers->is_array()) return base::Error{"a list was expected", "/deformers", k_see_format};
  if (deformers->size() > k_most_deformers) {
    return base::Error{"a model has at most 1,000 deformers", "/deformers", "split the file"};
  }
  std::set<std::string> names;
  list_unknown(*json, "", k_members, file.skipped);
  for (std::size_t i = 0; i < deformers->size(); ++i) {
    const std::string pointer = child("/deformers", i);
    file.sketches.emplace_back().rules = articulation::k_held_rules;
    if (auto problem = read_sketch((*deformers)[i], pointer, viewport, file.sketches.back())) return *problem;
    list_unknown((*deformers)[i], pointer, k_deformer_members, file.skipped);
    if (!names.insert(file.sketches.back().name).second) {
      return base::Error{"another deformer is called '" + file.sketches.back().name + "' too", pointer + "/name",
                         "rename one of them"};
    }
  }
  return file;
}

std::string write_sketch_file(const SketchFile& file) {
  std::string text = "{\"model\": " + Json(file.model).dump(-1, ' ', false, Json::error_handler_t::replace) +
                     ", \"viewport\": " + to_json(file.viewport).dump() + ", \"deformers\": [";
  for (std::size_t i = 0; i < file.sketches.size(); ++i) {
    const Viewports viewports = file.sketches[i].viewport == file.viewport ? Viewports::shared : Viewports::each;
    text += i == 0 ? "\n" : ",\n";
    Json one = to_json(file.sketches[i], viewports);
    one["rules"] = file.sketches[i].rules;
    text += one.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  return text + "\n]}\n";
}

}  // namespace penpose::model_io
