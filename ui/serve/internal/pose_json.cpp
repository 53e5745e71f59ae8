#include "ui/serve/internal/pose_json.h"

#include <algorithm>
#include <string>

namespace penpose::serve {

using json::Json;

Json pose_json(const character::Character& one) {
  Json out = Json::object();
  const auto parameters = one.parameters();
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (one.pose()[i] != parameters[i].rest) out[parameters[i].name] = one.pose()[i];
  }
  return out;
}

Json distances_json(const character::Character& one) {
  Json out = Json::object();
  for (const auto& curve : one.document().curves) {
    const auto distances = one.distances_of(curve->id);
    if (!distances || distances->empty()) continue;
    double sum = 0;
    for (const double distance : *distances) sum += distance;
    out[std::to_string(curve->id.value)] = {{"mean", sum / static_cast<double>(distances->size())},
                                            {"most", *std::max_element(distances->begin(), distances->end())}};
  }
  return out;
}

}  // namespace penpose::serve
