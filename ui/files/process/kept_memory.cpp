#include "ui/files/process/kept_memory.h"

#include <malloc.h>

namespace penpose::files {

// Both are glibc's own; other C libraries keep little by themselves.

void keep_little_memory() {
#if PENPOSE_HAS_MALLOPT
  constexpr int k_large = 4 << 20;
  ::mallopt(M_ARENA_MAX, 1);
  ::mallopt(M_MMAP_THRESHOLD, k_large);
#endif
}

void give_back_memory() {
#if PENPOSE_HAS_MALLOC_TRIM
  ::malloc_trim(0);
#endif
}

}  // namespace penpose::files
