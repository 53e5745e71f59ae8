#include "ui/speech/hear_phones.h"

namespace penpose::speech {

bool hears_speech() { return false; }

base::Result<std::vector<Phone>> hear_phones(const sound::Sound&, const std::string&, const std::string&, Listening*) {
  return base::Error{"this program was built without speech", "",
                     "build it with PocketSphinx and PENPOSE_SPEECH=ON, or give cues of Rhubarb or Papagayo"};
}

}  // namespace penpose::speech
