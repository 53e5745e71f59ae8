#include <cstddef>
#include <cstdint>

#include "ui/app/files/dropped_file.h"
#include "ui/film/read_film.h"

// The kind of a file by its content, whatever its name says.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const penpose::base::Bytes bytes{data, size};
  (void)penpose::film::is_film(bytes);
  for (const char* name : {"", "a", "a.glb", "a.csv", "a.json", "a.svg", "a.PNG"})
    (void)penpose::app::words_of(penpose::app::kind_of_content(bytes, name));
  return 0;
}
