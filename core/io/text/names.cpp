#include "core/io/text/names.h"

#include <map>
#include <set>

namespace penpose::io {

void make_unique(std::vector<std::string>& names) {
  std::set<std::string> taken(names.begin(), names.end());
  if (taken.size() == names.size()) return;
  std::set<std::string> seen;
  std::map<std::string, std::size_t> next;
  for (std::string& name : names) {
    if (seen.insert(name).second) continue;
    std::size_t& number = next.try_emplace(name, 2).first->second;
    std::string candidate = name + "." + std::to_string(number);
    while (!taken.insert(candidate).second) candidate = name + "." + std::to_string(++number);
    ++number;
    name = std::move(candidate);
    seen.insert(name);
  }
}

}  // namespace penpose::io
