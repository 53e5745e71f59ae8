#pragma once

#include <type_traits>

#include "ui/app/app.h"

// Tables name functions that take the owners they work with. What is here calls such a function with an app's owners,
// so that the function sees no more of the app than it names.

namespace penpose::app {

template <typename Result, typename... Owners>
Result call_with_owners(App& app, Result (*function)(Owners&...)) {
  return function(app.of<std::remove_const_t<Owners>>()...);
}

/// `does<save>`: a function `save(Files&, Notices&)` as one of the app.
template <auto function>
auto does(App& app) {
  return call_with_owners(app, function);
}

/// `does([](Canvas& canvas) { ... })`: the same of a lambda, which captures nothing.
template <typename Lambda>
constexpr auto does(Lambda) {
  return +[](App& app) { return call_with_owners(app, +Lambda{}); };
}

}  // namespace penpose::app
