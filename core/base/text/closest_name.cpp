#include "core/base/text/closest_name.h"

#include <algorithm>
#include <vector>

#include "core/base/text/letters.h"

namespace penpose::base {
namespace {

/// Cost in tenths of a letter.
int letter_cost(char a, char b) { return a == b ? 0 : lower(a) == lower(b) ? 1 : 10; }

int distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<int>> cost(a.size() + 1, std::vector<int>(b.size() + 1, 0));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        cost[i][j] = static_cast<int>(i + j) * 10;
        continue;
      }
      cost[i][j] =
          std::min({cost[i - 1][j] + 10, cost[i][j - 1] + 10, cost[i - 1][j - 1] + letter_cost(a[i - 1], b[j - 1])});
      const bool swapped = i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
      if (swapped) cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 10);
    }
  }
  return cost[a.size()][b.size()];
}

}  // namespace

std::optional<std::string> closest_name(std::string_view given, std::span<const std::string> names) {
  constexpr std::size_t k_longest = 200;
  if (given.size() > k_longest) return std::nullopt;
  const std::string* best = nullptr;
  int least = 0;
  for (const std::string& name : names) {
    if (name.size() > k_longest) continue;
    const int cost = distance(given, name);
    if (best == nullptr || cost < least) {
      best = &name;
      least = cost;
    }
  }
  if (best == nullptr || least > static_cast<int>(best->size()) * 5) return std::nullopt;
  return *best;
}

}  // namespace penpose::base
