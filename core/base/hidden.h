#pragma once

#include <memory>
#include <utility>

namespace penpose::base {

/// Owns what only a source file knows, without a destructor there.
template <typename T>
using Hidden = std::unique_ptr<T, void (*)(T*)>;

template <typename T, typename... Parts>
[[nodiscard]] Hidden<T> make_hidden(Parts&&... parts) {
  return {new T(std::forward<Parts>(parts)...), [](T* one) { delete one; }};
}

}  // namespace penpose::base
