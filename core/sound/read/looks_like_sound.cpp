#include <string_view>

#include "core/sound/read/read_sound.h"

namespace penpose::sound {

bool looks_like_sound(base::Bytes bytes) {
  const std::string_view text = base::as_text(bytes);
  if (text.starts_with("fLaC") || text.starts_with("OggS")) return true;
  return (text.starts_with("RIFF") || text.starts_with("RIFX")) && text.substr(0, 12).ends_with("WAVE");
}

}  // namespace penpose::sound
