#include "ui/speech/hear_phones.h"

namespace penpose::speech {

base::Status can_hear(const std::string&) {
  return base::Error{
      "this program was built without speech", "",
      "build it with PocketSphinx and PENPOSE_SPEECH=ON, or give cues (Rhubarb, TextGrid, captions, ...)"};
}

base::Result<std::vector<Phone>> hear_phones(const sound::Sound&, const std::string&, const std::string& model,
                                             Listening*) {
  return can_hear(model).error();
}

}  // namespace penpose::speech
