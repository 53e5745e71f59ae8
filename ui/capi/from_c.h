#pragma once

#include <algorithm>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/document/drawing/pose_curve.h"
#include "ui/capi/call.h"

// What the structs of the C library mean.

namespace penpose::capi {

/// Numbers that a caller's list of so many entries holds.
[[nodiscard]] std::size_t numbers_of(std::size_t count, std::size_t each, const char* name);
[[nodiscard]] document::View view_of(const penpose_view& view);
[[nodiscard]] penpose_view view_to_c(const document::View& view);
/// `count` places of two numbers each.
[[nodiscard]] std::vector<geometry::PxPoint> line_of(const double* px, std::size_t count, const char* name);
/// `count` points of three numbers each.
[[nodiscard]] std::vector<geometry::ModelPoint> points_of(const double* xyz, std::size_t count, const char* name);

/// What a number of the interface means. Ends the call where it is none of them; `what` names them.
template <typename T>
[[nodiscard]] T meaning_of(std::int32_t number, std::initializer_list<std::pair<std::int32_t, T>> known,
                           const char* what, const char* remedy) {
  for (const auto& [one, meaning] : known) {
    if (one == number) return meaning;
  }
  fail_argument(std::string("there is no such ") + what, what, remedy);
}

/// Writes a list into a caller's array: its length always, its entries where they fit. Ends the call where they do not
/// and any room was given, or some was asked for.
template <typename T>
void write_list(std::span<const T> list, T* out, std::size_t room, std::size_t* count, const char* name) {
  needed(count, "count") = list.size();
  if (out == nullptr && room == 0) return;
  const auto place = array(out, room, name);
  if (place.size() < list.size()) {
    fail(PENPOSE_TOO_SMALL, {"there is room for " + std::to_string(room) + " entries of " + std::to_string(list.size()),
                             name, "give more room"});
  }
  std::copy(list.begin(), list.end(), place.begin());
}

}  // namespace penpose::capi
