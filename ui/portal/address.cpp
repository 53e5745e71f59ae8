#include "core/base/text/letters.h"
#include "ui/portal/portal.h"

namespace penpose::portal {

std::string path_of_address(const std::string& address) {
  constexpr std::string_view k_scheme = "file://";
  if (!address.starts_with(k_scheme)) return {};
  std::string_view rest = std::string_view(address).substr(k_scheme.size());
  constexpr std::string_view k_here = "localhost";
  if (rest.starts_with(k_here)) rest.remove_prefix(k_here.size());
  if (!rest.starts_with('/')) return {};
  std::string path;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (rest[i] != '%') {
      path += rest[i];
      continue;
    }
    const auto high = i + 2 < rest.size() ? base::hex_value(rest[i + 1]) : std::nullopt;
    const auto low = high ? base::hex_value(rest[i + 2]) : std::nullopt;
    // What is no escape, or would end the path, is no path.
    if (!low || (*high == 0 && *low == 0)) return {};
    path += static_cast<char>(16 * *high + *low);
    i += 2;
  }
  return path;
}

}  // namespace penpose::portal
