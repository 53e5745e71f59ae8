#include "ui/speech/dictionary.h"

#include "ui/files/files.h"

namespace penpose::speech {

std::vector<std::uint8_t> english_dictionary() {
  constexpr const char* k_debian = "/usr/share/pocketsphinx/model/en-us/cmudict-en-us.dict";
  constexpr std::uint64_t k_most_bytes = std::uint64_t{1} << 26U;
  auto bytes = files::read_file(k_debian, k_most_bytes);
  return bytes ? std::move(bytes).value() : std::vector<std::uint8_t>();
}

}  // namespace penpose::speech
