#include "core/rig/control_names.h"

namespace penpose::rig {

std::string folded_name(std::string_view name) {
  std::string folded;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') folded += static_cast<char>(c - 'A' + 'a');
    if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) folded += c;
  }
  for (const std::string_view side : {"left", "right"}) {
    if (folded.size() > side.size() && folded.ends_with(side)) folded.erase(folded.size() - side.size() + 1);
  }
  return folded;
}

std::vector<std::size_t> controls_named(std::span<const Parameter> parameters, std::string_view name) {
  const std::string wanted = folded_name(name);
  std::vector<std::size_t> exact;
  std::vector<std::size_t> sides;
  if (wanted.empty()) return exact;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const std::string own = folded_name(parameters[i].name);
    if (own == wanted) exact.push_back(i);
    const bool sided =
        own.size() == wanted.size() + 1 && own.starts_with(wanted) && (own.back() == 'l' || own.back() == 'r');
    if (sided) sides.push_back(i);
  }
  return exact.empty() ? sides : exact;
}

}  // namespace penpose::rig
