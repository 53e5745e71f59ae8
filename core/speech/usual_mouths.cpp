#include "core/speech/usual_mouths.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/speech/nine_mouths.h"
#include "core/tracking/driven_controls.h"

namespace penpose::speech {
namespace {

using enum NineMouth;

/// What stands for a mouth that is not drawn; rest for none.
NineMouth most_like(NineMouth mouth) {
  switch (mouth) {
    case a:
      return e;
    case e:
    case l:
      return consonants;
    case o:
      return u;
    case u:
    case consonants:
    case closed:
    case rest:
      return rest;
    case f:
      return closed;
  }
  return rest;
}

}  // namespace

std::vector<document::Mouth> usual_mouths(const document::Model& model) {
  const auto parameters = model.rig->parameters();
  std::vector<document::Mouth> mouths;
  bool any = false;
  for (std::size_t i = 0; i < k_nine; ++i) {
    document::Mouth mouth{std::string(k_mouth_names[i]), {}};
    for (const auto& driven : tracking::driven_controls(model, std::string("mouth cue ") + k_mouth_letters[i])) {
      const rig::Parameter& moved = parameters[driven.parameter];
      mouth.values.push_back({moved.name, std::clamp(moved.rest + driven.gain, moved.minimum, moved.maximum)});
      any = true;
    }
    mouths.push_back(std::move(mouth));
  }
  return any ? mouths : std::vector<document::Mouth>();
}

base::Result<document::SpokenMouths> with_drawn(const document::SpokenMouths& keys, const document::Mouths& mouths) {
  document::SpokenMouths out = keys;
  for (document::SpokenMouth& key : out) {
    const std::string wanted = key.mouth;
    while (document::find_mouth(mouths, key.mouth) == nullptr) {
      const auto* name = std::find(k_mouth_names.begin(), k_mouth_names.end(), key.mouth);
      if (name == k_mouth_names.end() || key.mouth == name_of(rest))
        return base::Error{"no mouth stands for \"" + wanted + "\"", "", "draw it, or the mouth \"rest\""};
      key.mouth = name_of(most_like(static_cast<NineMouth>(name - k_mouth_names.begin())));
    }
  }
  return out;
}

}  // namespace penpose::speech
