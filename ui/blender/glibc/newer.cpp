// Names that glibc has since a version after the one that is linked against, for what the compiler's archives ask for.
// Hidden: other libraries of the same program have their own. Sources: the manual of glibc, "Dynamic Linker
// Introspection" and "Single-Threaded"; its NEWS of 2.32, 2.33 and 2.35.
#include <cstddef>
#include <cstdint>
#include <dlfcn.h>
#include <link.h>
#include <sys/stat.h>

#pragma GCC visibility push(hidden)

/// Debian's archives of libpng and libjpeg are made for programs: they read the variable itself, which may not be
/// another library's then.
void* own_stderr asm("stderr") = nullptr;

namespace {

__attribute__((constructor)) void find_stderr() {
  void* const there = dlsym(RTLD_DEFAULT, "stderr");
  own_stderr = there == nullptr ? nullptr : *static_cast<void**>(there);
}

}  // namespace

extern "C" {

/// 2.32. Whoever loads the library may have threads.
char __libc_single_threaded = 0;

/// 2.33. Before, <sys/stat.h> made calls of these, with the version of the structure.
int __fxstat64(int version, int file, struct stat64* status) __attribute__((visibility("default")));
int __xstat64(int version, const char* path, struct stat64* status) __attribute__((visibility("default")));

int fstat64(int file, struct stat64* status) noexcept {
#ifdef __x86_64__
  return __fxstat64(1, file, status);
#else
  return __fxstat64(0, file, status);
#endif
}

int stat64(const char* path, struct stat64* status) noexcept {
#ifdef __x86_64__
  return __xstat64(1, path, status);
#else
  return __xstat64(0, path, status);
#endif
}

/// 2.35: where the tables lie that exceptions are unwound by. The program headers tell the same.
int _dl_find_object(void* address, struct dl_find_object* answer) {
  struct Query {
    std::uintptr_t address;
    dl_find_object* answer;
  } query{reinterpret_cast<std::uintptr_t>(address), answer};
  const auto look = [](dl_phdr_info* info, std::size_t, void* data) {
    const Query& asked = *static_cast<const Query*>(data);
    void *tables = nullptr, *start = nullptr, *end = nullptr;
    for (int i = 0; i < info->dlpi_phnum; ++i) {
      const auto& part = info->dlpi_phdr[i];
      const std::uintptr_t at = info->dlpi_addr + part.p_vaddr;
      if (part.p_type == PT_LOAD && asked.address >= at && asked.address - at < part.p_memsz) {
        start = reinterpret_cast<void*>(at);
        end = reinterpret_cast<void*>(at + part.p_memsz);
      }
      if (part.p_type == PT_GNU_EH_FRAME) tables = reinterpret_cast<void*>(at);
    }
    if (start == nullptr || tables == nullptr) return 0;
    *asked.answer = {};
    asked.answer->dlfo_map_start = start;
    asked.answer->dlfo_map_end = end;
    asked.answer->dlfo_eh_frame = tables;
    return 1;
  };
  return dl_iterate_phdr(look, &query) == 1 ? 0 : -1;
}

}  // extern "C"

#pragma GCC visibility pop
