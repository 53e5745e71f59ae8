#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <mutex>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "core/base/result.h"
#include "ui/capi/objects.h"
#include "ui/capi/penpose.h"

// The border of the C library: what a call came to, and that nothing is thrown across it.

namespace penpose::capi {

/// Writes the outcome; a line that is too long is cut between two characters. Never throws.
std::int32_t tell(penpose_error* error, penpose_status status, std::string_view line) noexcept;

/// Writes as much of a text as fits before a 0, cut between two characters.
void copy_text(std::string_view text, std::span<char> out) noexcept;

/// What ends a call early.
struct Failure {
  penpose_status status;
  base::Error error;
};

[[noreturn]] inline void fail(penpose_status status, base::Error error) { throw Failure{status, std::move(error)}; }
[[noreturn]] [[noreturn]] inline void fail_argument(std::string what, std::string place, std::string remedy) {
  fail(PENPOSE_BAD_ARGUMENT, {std::move(what), std::move(place), std::move(remedy)});
}

/// The value of a result, or the end of the call.
template <typename T>
T taken(base::Result<T> result) {
  if (!result) fail(PENPOSE_REFUSED, result.error());
  return std::move(result).value();
}
inline void done(const base::Status& status) {
  if (!status) fail(PENPOSE_REFUSED, status.error());
}

template <typename T>
T& needed(T* pointer, const char* name) {
  if (pointer == nullptr) fail_argument("a null pointer", name, "give a place");
  return *pointer;
}

/// The elements of a caller's array; a null pointer goes with a count of 0 alone.
template <typename T>
std::span<T> array(T* first, std::size_t count, const char* name) {
  if (first == nullptr && count > 0) fail_argument("a null pointer for a list that is not empty", name, "give a list");
  // More bytes than memory has: a count that was negative, or is none.
  constexpr std::size_t k_most = static_cast<std::size_t>(-1) / 2 / sizeof(T);
  if (count > k_most) fail_argument("a count that no memory holds", name, "give the number of entries");
  return {first, count};
}

/// A caller's text. `name`: of the argument.
inline std::string_view text(const char* pointer, const char* name) { return {&needed(pointer, name)}; }

/// Makes a call: nothing gets out of it but a status.
template <typename Body>
std::int32_t call(penpose_error* error, Body&& body) noexcept {
  try {
    body();
    return tell(error, PENPOSE_OK, {});
  } catch (const Failure& failure) {
    try {
      return tell(error, failure.status, failure.error.line());
    } catch (...) {
      return tell(error, failure.status, "the memory did not suffice to say more");
    }
  } catch (const std::bad_alloc&) {
    return tell(error, PENPOSE_NO_MEMORY, "the memory did not suffice; nothing has changed");
  } catch (const std::length_error&) {
    return tell(error, PENPOSE_NO_MEMORY, "the memory cannot suffice; nothing has changed");
  } catch (...) {
    return tell(error, PENPOSE_INTERNAL, "something went wrong that should not; report it with what shows it");
  }
}

/// The object of a handle.
template <typename T>
std::shared_ptr<T> object_of(penpose_library* library, penpose_handle handle) {
  auto found = needed(library, "library").handles.find(handle);
  const bool fits = found && found->kind == T::k_kind;
  if (!fits) {
    fail(PENPOSE_BAD_HANDLE, {found ? "the handle names another kind of thing" : "the handle names nothing", "",
                              "it may have been freed; give one that a call gave out for this"});
  }
  return std::static_pointer_cast<T>(std::move(found));
}

/// Makes a call with what a handle names, while no other call has it.
template <typename T, typename Body>
std::int32_t call_with(penpose_library* library, penpose_handle handle, penpose_error* error, Body&& body) noexcept {
  return call(error, [&] {
    const auto object = object_of<T>(library, handle);
    const std::lock_guard guard(object->busy);
    body(*object);
  });
}

/// The same with a character. What is thrown may leave what it keeps for the next solve half done.
template <typename Body>
std::int32_t call_character(penpose_library* library, penpose_handle handle, penpose_error* error,
                            Body&& body) noexcept {
  return call_with<CharacterObject>(library, handle, error, [&](CharacterObject& object) {
    try {
      body(object.character, object);
    } catch (const Failure&) {
      throw;
    } catch (...) {
      object.character.forget_scratch();
      throw;
    }
  });
}

/// Gives out a handle for a new object.
template <typename T, typename... Arguments>
void give(penpose_library& library, penpose_handle& handle, Arguments&&... arguments) {
  handle = library.handles.add(std::make_shared<T>(std::forward<Arguments>(arguments)...));
}

}  // namespace penpose::capi
