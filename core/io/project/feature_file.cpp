#include "core/io/project/feature_file.h"

#include <algorithm>
#include <set>

#include "core/base/json/json.h"
#include "core/document/commands/list/face/feature_commands.h"
#include "core/document/model_hash.h"
#include "core/io/project/internal/named_curve_json.h"

namespace penpose::io {
namespace {

using json::Json;

constexpr const char* k_features_form = "penpose_features";
constexpr const char* k_correct_again = "remove the file and correct the features again";

base::Error wrong_features(std::string what, std::string pointer) {
  return {std::move(what), std::move(pointer), k_correct_again};
}

std::optional<base::Error> read_feature_list(const Json& root, std::vector<document::NamedCurve>& out) {
  const Json* list = json::find(root, "features");
  if (list == nullptr || !list->is_array() || list->size() > document::k_most_corrected)
    return wrong_features("a list of at most 200 features was expected", "/features");
  std::set<std::string> names;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string here = json::child("/features", i);
    document::NamedCurve& one = out.emplace_back();
    if (auto error = read_named_curve((*list)[i], here, k_correct_again, one)) return error;
    if (one.name.empty() || !names.insert(one.name).second)
      return wrong_features("a name of its own was expected", json::child(here, "name"));
    if (one.points.size() == 1)
      return wrong_features("no points, or two and more were expected", json::child(here, "points"));
  }
  return std::nullopt;
}

}  // namespace

base::Result<FeatureFile> read_features(base::Bytes bytes, const mesh::TriangleMesh& mesh) {
  const auto root = json::parse_json(bytes);
  if (!root) return root.error();
  const Json* form = json::find(*root, k_features_form);
  if (form == nullptr) return base::Error{"these are no features", "", "features have \"penpose_features\": 1"};
  const auto number = json::whole_number(*form, 1, 1'000'000);
  if (!number) return wrong_features("the number of a format was expected", std::string("/") + k_features_form);
  if (*number != k_feature_format) {
    return base::Error{
        "features of format " + std::to_string(*number) + ", this program reads " + std::to_string(k_feature_format),
        std::string("/") + k_features_form, "correct them with the same version of penpose"};
  }
  FeatureFile file;
  const Json* of = json::find(*root, "mesh");
  const auto hash = of != nullptr && of->is_string() ? base::parse_hash(of->get_ref<const std::string&>())
                                                     : std::optional<base::Hash128>();
  if (!hash) return wrong_features("32 hexadecimal digits were expected", "/mesh");
  file.mesh = *hash;
  if (!(file.mesh == document::hash_topology(mesh))) return wrong_features("the features are of another mesh", "/mesh");
  if (auto error = read_feature_list(*root, file.features)) return *error;
  if (auto error = check_named_curves(file.features, mesh.triangle_count(), "/features", k_correct_again))
    return *error;
  return file;
}

std::string write_features(const FeatureFile& file) {
  std::string text = "{\n\"" + std::string(k_features_form) + "\": " + std::to_string(k_feature_format) +
                     ",\n\"mesh\": \"" + file.mesh.hex() + "\",\n\"features\": [";
  const Json features = to_json(std::span(file.features));
  for (std::size_t i = 0; i < features.size(); ++i) text += (i == 0 ? "\n" : ",\n") + features[i].dump_as_made();
  return text + "\n]\n}\n";
}

}  // namespace penpose::io
