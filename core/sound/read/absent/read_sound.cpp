#include "core/sound/read/read_sound.h"

namespace penpose::sound {

bool reads_sounds() { return false; }

base::Result<Sound> read_sound(base::Bytes) {
  return base::Error{"this program was built without sound", "", "build it with libsndfile and PENPOSE_SOUND=ON"};
}

}  // namespace penpose::sound
