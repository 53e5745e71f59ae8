#include "core/document/commands/command.h"

#include <type_traits>

#include "core/document/commands/command_visit.h"

namespace penpose::document {

Command::Command(const Command& other)
    : index_(other.index_),
      held_(visit([](const auto& one) -> void* { return new std::decay_t<decltype(one)>(one); }, other)) {}

Command::Command(Command&& other) noexcept : index_(other.index_), held_(std::exchange(other.held_, nullptr)) {}

Command& Command::operator=(Command other) noexcept {
  std::swap(index_, other.index_);
  std::swap(held_, other.held_);
  return *this;
}

Command::~Command() {
  if (held_ != nullptr) visit([](const auto& one) { delete &one; }, *this);
}

bool operator==(const Command& a, const Command& b) {
  if (a.index_ != b.index_) return false;
  return visit([&b](const auto& one) { return one == *b.get_if<std::decay_t<decltype(one)>>(); }, a);
}

const Called& called(const Command& command) {
  return visit([](const auto& one) -> const Called& { return std::decay_t<decltype(one)>::k_called; }, command);
}

}  // namespace penpose::document
