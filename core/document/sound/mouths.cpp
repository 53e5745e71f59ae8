#include "core/document/sound/mouths.h"

#include <algorithm>
#include <utility>

namespace penpose::document {

const Mouth* find_mouth(const Mouths& mouths, std::string_view name) {
  for (const auto& mouth : mouths) {
    if (mouth->name == name) return mouth.get();
  }
  return nullptr;
}

std::vector<std::size_t> controls_of(const Mouths& mouths, const SpokenMouths& spoken,
                                     std::span<const rig::Parameter> parameters) {
  std::vector<bool> moved(parameters.size());
  for (const auto& mouth : mouths) {
    const bool said =
        std::any_of(spoken.begin(), spoken.end(), [&](const SpokenMouth& one) { return one.mouth == mouth->name; });
    if (!said) continue;
    for (const NamedValue& one : mouth->values) {
      if (const auto number = rig::find_parameter(parameters, one.name)) moved[*number] = true;
    }
  }
  std::vector<std::size_t> controls;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    if (moved[i]) controls.push_back(i);
  }
  return controls;
}

std::vector<double> values_of(const Mouth& mouth, std::span<const std::size_t> controls,
                              std::span<const rig::Parameter> parameters) {
  std::vector<double> values;
  for (const std::size_t number : controls) {
    double value = parameters[number].rest;
    for (const NamedValue& one : mouth.values) {
      if (one.name == parameters[number].name) value = one.value;
    }
    values.push_back(value);
  }
  return values;
}

Mouths mouths_of_rig(const Mouths& mouths, std::span<const rig::Parameter> parameters) {
  Mouths out;
  for (const auto& mouth : mouths) {
    std::vector<std::pair<std::size_t, double>> known;
    for (const NamedValue& one : mouth->values) {
      if (const auto number = rig::find_parameter(parameters, one.name)) known.emplace_back(*number, one.value);
    }
    std::stable_sort(known.begin(), known.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    Mouth fits{mouth->name, {}};
    for (const auto& [number, value] : known) {
      const rig::Parameter& parameter = parameters[number];
      fits.values.push_back({parameter.name, std::clamp(value, parameter.minimum, parameter.maximum)});
    }
    out.push_back(fits == *mouth ? mouth : std::make_shared<const Mouth>(std::move(fits)));
  }
  return out;
}

Mouths with_renamed_control(const Mouths& mouths, const std::string& from, const std::string& to) {
  Mouths out;
  for (const auto& mouth : mouths) {
    Mouth renamed = *mouth;
    for (NamedValue& one : renamed.values) {
      if (one.name == from) one.name = to;
    }
    out.push_back(std::make_shared<const Mouth>(std::move(renamed)));
  }
  return out;
}

}  // namespace penpose::document
