#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <variant>

#include "core/document/commands/command.h"

namespace penpose::document {

/// `visitor` called with what the command holds. Each use is compiled for every command, so there should be few.
template <typename Visitor, std::size_t... index>
decltype(auto) visit_each(Visitor& visitor, const Command& command, std::index_sequence<index...>) {
  using Answer = decltype(visitor(std::declval<const std::variant_alternative_t<0, CommandTypes>&>()));
  using Call = Answer (*)(Visitor&, const Command&);
  static constexpr std::array<Call, sizeof...(index)> k_calls{[](Visitor& with, const Command& held) -> Answer {
    return with(*held.get_if<std::variant_alternative_t<index, CommandTypes>>());
  }...};
  return k_calls.at(command.index())(visitor, command);
}
template <typename Visitor>
decltype(auto) visit(Visitor&& visitor, const Command& command) {
  return visit_each(visitor, command, std::make_index_sequence<std::variant_size_v<CommandTypes>>());
}

}  // namespace penpose::document
