#include "core/speech/mouth_file.h"

#include <algorithm>
#include <utility>

#include "core/base/json/json.h"

namespace penpose::speech {
namespace {

base::Error wrong_mouths(std::string what, std::string pointer) {
  return {std::move(what), std::move(pointer), R"(write {"mouths": [{"name": "closed", "values": {"jawOpen": 0}}]})"};
}

}  // namespace

base::Result<std::vector<document::Mouth>> read_mouth_file(base::Bytes bytes) {
  const auto root = json::parse_json(bytes);
  if (!root) return root.error();
  const json::Json* list = json::find(*root, "mouths");
  if (list == nullptr || !list->is_array() || list->empty() || list->size() > document::k_most_mouths)
    return wrong_mouths("a list of 1 to 100 mouths was expected", "/mouths");
  std::vector<document::Mouth> mouths;
  for (std::size_t i = 0; i < list->size(); ++i) {
    const std::string here = json::child("/mouths", i);
    const json::Json* name = json::find((*list)[i], "name");
    if (name == nullptr || !name->is_string() || name->get_ref<const std::string&>().empty())
      return wrong_mouths("a name was expected", json::child(here, "name"));
    document::Mouth mouth{name->get<std::string>(), {}};
    const bool again =
        std::any_of(mouths.begin(), mouths.end(), [&](const auto& one) { return one.name == mouth.name; });
    if (again) return wrong_mouths("a name of its own was expected", json::child(here, "name"));
    const json::Json* values = json::find((*list)[i], "values");
    if (values == nullptr || !values->is_object())
      return wrong_mouths("controls and their values were expected", json::child(here, "values"));
    for (const auto& [control, value] : values->items()) {
      const auto number = json::number(value);
      if (!number) return wrong_mouths("a number was expected", json::child(json::child(here, "values"), control));
      mouth.values.push_back({control, *number});
    }
    mouths.push_back(std::move(mouth));
  }
  return mouths;
}

}  // namespace penpose::speech
