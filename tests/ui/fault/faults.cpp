#include "tests/ui/fault/faults.h"

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <new>
#include <sys/types.h>
#include <unistd.h>

namespace penpose::tests {
namespace {

std::atomic<FaultPlan::Kind> g_kind{FaultPlan::Kind::none};
std::atomic<std::size_t> g_number{0};
std::atomic<bool> g_stays{false};
std::atomic<std::size_t> g_calls{0};

bool fails(FaultPlan::Kind kind) {
  if (g_kind != kind) return false;
  const std::size_t call = ++g_calls;
  return g_number != 0 && (call == g_number || (g_stays && call > g_number));
}

}  // namespace

void begin_faults(const FaultPlan& plan) {
  g_calls = 0;
  g_number = plan.number;
  g_stays = plan.stays;
  g_kind = plan.kind;
}

std::size_t end_faults() {
  g_kind = FaultPlan::Kind::none;
  return g_calls;
}

bool file_call_fails() {
  if (!fails(FaultPlan::Kind::files)) return false;
  errno = ENOSPC;
  return true;
}

void* allocate(std::size_t size, std::size_t alignment) {
  if (fails(FaultPlan::Kind::memory)) {
    if (const auto handler = std::get_new_handler()) handler();
    throw std::bad_alloc();
  }
  void* block = alignment == 0 ? std::malloc(size == 0 ? 1 : size)
                               : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

/// The same for who asks for null instead of an exception, as std::stable_sort does. The library's own would do so,
/// too, but a sanitizer brings one along that knows nothing of ours.
void* allocate_or_null(std::size_t size, std::size_t alignment) noexcept {
  try {
    return allocate(size, alignment);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

void release(void* block) { std::free(block); }

}  // namespace penpose::tests

using penpose::tests::allocate;
using penpose::tests::allocate_or_null;
using penpose::tests::file_call_fails;
using penpose::tests::release;

void* operator new(std::size_t size) { return allocate(size, 0); }
void* operator new[](std::size_t size) { return allocate(size, 0); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate_or_null(size, 0); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate_or_null(size, 0); }
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return allocate_or_null(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return allocate_or_null(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept { release(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept { release(block); }
void operator delete[](void* block, const std::nothrow_t&) noexcept { release(block); }
void operator delete[](void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept { release(block); }

// The linker leads calls of NAME here (-Wl,--wrap=NAME) and those of __real_NAME to the system.
extern "C" {
// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): names that the linker gives
int __real_open(const char* path, int flags, ...);
int __real_openat(int folder, const char* path, int flags, ...);
ssize_t __real_write(int file, const void* data, std::size_t size);
int __real_fsync(int file);
int __real_fdatasync(int file);
int __real_linkat(int from, const char* old, int to, const char* fresh, int flags);
int __real_renameat(int from, const char* old, int to, const char* fresh);
std::size_t __real_fread(void* data, std::size_t size, std::size_t count, std::FILE* file);
std::FILE* __real_fdopen(int file, const char* mode);

int __wrap_open(const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = va_arg(more, mode_t);
  va_end(more);
  return file_call_fails() ? -1 : __real_open(path, flags, mode);
}
int __wrap_openat(int folder, const char* path, int flags, ...) {
  va_list more;
  va_start(more, flags);
  const mode_t mode = va_arg(more, mode_t);
  va_end(more);
  return file_call_fails() ? -1 : __real_openat(folder, path, flags, mode);
}
ssize_t __wrap_write(int file, const void* data, std::size_t size) {
  return file_call_fails() ? -1 : __real_write(file, data, size);
}
int __wrap_fsync(int file) { return file_call_fails() ? -1 : __real_fsync(file); }
int __wrap_fdatasync(int file) { return file_call_fails() ? -1 : __real_fdatasync(file); }
int __wrap_linkat(int from, const char* old, int to, const char* fresh, int flags) {
  return file_call_fails() ? -1 : __real_linkat(from, old, to, fresh, flags);
}
int __wrap_renameat(int from, const char* old, int to, const char* fresh) {
  return file_call_fails() ? -1 : __real_renameat(from, old, to, fresh);
}
std::size_t __wrap_fread(void* data, std::size_t size, std::size_t count, std::FILE* file) {
  if (!file_call_fails()) return __real_fread(data, size, count, file);
  // As a disk that cannot be read: nothing comes, and the file says so.
  const int broken = __real_open("/", O_RDONLY | O_DIRECTORY);
  ::dup2(broken, ::fileno(file));
  ::close(broken);
  return __real_fread(data, size, count, file);
}
std::FILE* __wrap_fdopen(int file, const char* mode) { return file_call_fails() ? nullptr : __real_fdopen(file, mode); }
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)
}
