#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/base/byte_reader.h"
#include "core/phonetics/phone_names.h"
#include "core/phonetics/spoken_letters.h"

/// Labels that blanks part, in every alphabet, and the text as words.
// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer looks for
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = penpose::base::as_text({data, size});
  std::vector<std::string_view> labels;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    labels.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  (void)penpose::speech::spelling_of(labels);
  (void)penpose::speech::words_spoken(text);
  return 0;
}
