#include "ui/files/process/kept_memory.h"

#include <cstdlib>
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace penpose::files {

// Both are glibc's own; other C libraries keep little by themselves.

void keep_little_memory() {
#ifdef __GLIBC__
  constexpr int k_large = 4 << 20;
  ::mallopt(M_ARENA_MAX, 1);
  ::mallopt(M_MMAP_THRESHOLD, k_large);
#endif
}

void give_back_memory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

}  // namespace penpose::files
