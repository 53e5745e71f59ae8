#include "ui/files/process/kept_memory.h"

#include <malloc.h>

namespace penpose::files {

void keep_little_memory() {
  constexpr int k_large = 4 << 20;
  ::mallopt(M_ARENA_MAX, 1);
  ::mallopt(M_MMAP_THRESHOLD, k_large);
}

}  // namespace penpose::files
