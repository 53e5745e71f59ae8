#include "core/base/version.h"
#include "ui/capi/call.h"

using penpose::capi::call;
using penpose::capi::fail;
using penpose::capi::needed;

uint32_t penpose_abi_version(void) { return PENPOSE_ABI_VERSION; }

const char* penpose_version(void) { return base::k_version_text; }

int32_t penpose_open(penpose_library** library, penpose_error* error) {
  return call(error, [&] {
    // The place first: of an assignment the right side is made first, and would be lost where there is no place for it.
    penpose_library*& place = needed(library, "library");
    place = std::make_unique<penpose_library>().release();
  });
}

void penpose_close(penpose_library** library) {
  if (library == nullptr) return;
  delete *library;
  *library = nullptr;
}

int32_t penpose_free(penpose_library* library, penpose_handle handle, penpose_error* error) {
  return call(error, [&] {
    if (needed(library, "library").handles.remove(handle)) return;
    fail(PENPOSE_BAD_HANDLE, {"the handle names nothing", "", "it may have been freed before"});
  });
}

int32_t penpose_handle_count(penpose_library* library, size_t* count, penpose_error* error) {
  return call(error, [&] { needed(count, "count") = needed(library, "library").handles.size(); });
}
