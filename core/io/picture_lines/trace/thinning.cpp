#include "core/io/picture_lines/trace/internal/thinning.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace penpose::io {
namespace {

/// Whether a px goes, for each of the 256 forms of its neighbours; bit 0 is the one above, the others follow clockwise.
using Table = std::array<bool, 256>;

constexpr Table table_of(bool first) {
  Table table{};
  for (unsigned form = 0; form < 256; ++form) {
    const auto p = [form](unsigned k) { return (form >> (k - 2) & 1U) != 0; };  // p(2)..p(9) of the paper
    const int runs =
        (!p(2) && (p(3) || p(4))) + (!p(4) && (p(5) || p(6))) + (!p(6) && (p(7) || p(8))) + (!p(8) && (p(9) || p(2)));
    const int one = (p(9) || p(2)) + (p(3) || p(4)) + (p(5) || p(6)) + (p(7) || p(8));
    const int other = (p(2) || p(3)) + (p(4) || p(5)) + (p(6) || p(7)) + (p(8) || p(9));
    const int pairs = std::min(one, other);
    const bool kept = first ? (p(2) || p(3) || !p(5)) && p(4) : (p(6) || p(7) || !p(9)) && p(8);
    table[form] = runs == 1 && pairs >= 2 && pairs <= 3 && !kept;
  }
  return table;
}

constexpr std::array<Table, 2> k_tables{table_of(true), table_of(false)};

unsigned form_of(const Bitmap& mask, std::size_t at) {
  const std::size_t down = mask.stride();
  const auto bit = [&](std::size_t place, unsigned k) { return mask[place] != 0 ? 1U << k : 0U; };
  return bit(at - down, 0) | bit(at - down + 1, 1) | bit(at + 1, 2) | bit(at + down + 1, 3) | bit(at + down, 4) |
         bit(at + down - 1, 5) | bit(at - 1, 6) | bit(at - down - 1, 7);
}

}  // namespace

void close_holes(Bitmap& mask, int most_px) {
  const std::size_t down = mask.stride();
  std::vector<std::size_t> hole;
  for (int y = 1; y + 1 < mask.height(); ++y) {
    for (int x = 1; x + 1 < mask.width(); ++x) {
      const std::size_t begin = mask.index(x, y);
      if (mask[begin] != 0 || mask[begin - 1] == 0 || mask[begin - down] == 0) continue;
      hole.assign(1, begin);
      for (std::size_t i = 0; i < hole.size() && hole.size() <= static_cast<std::size_t>(most_px); ++i) {
        for (const std::size_t place : {hole[i] - down, hole[i] - 1, hole[i] + 1, hole[i] + down}) {
          const bool outside = !mask.contains(mask.x_of(place), mask.y_of(place));
          if (outside) hole.resize(static_cast<std::size_t>(most_px) + 1);
          if (outside) break;
          if (mask[place] == 0 && std::find(hole.begin(), hole.end(), place) == hole.end()) hole.push_back(place);
        }
      }
      if (hole.size() > static_cast<std::size_t>(most_px)) continue;
      for (const std::size_t place : hole) mask[place] = 1;
    }
  }
}

std::vector<std::uint32_t> thin(Bitmap& mask) {
  std::vector<std::uint32_t> left;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (mask[i] != 0) left.push_back(static_cast<std::uint32_t>(i));
  }
  // Those of a round whose neighbours changed can go in the next ones; the others are looked at no more.
  std::vector<std::uint32_t> gone;
  for (int quiet = 0, round = 0; quiet < 2; ++round) {
    const Table& table = k_tables[static_cast<std::size_t>(round % 2)];
    gone.clear();
    for (const std::uint32_t at : left) {
      if (table[form_of(mask, at)]) gone.push_back(at);
    }
    for (const std::uint32_t at : gone) mask[at] = 0;
    quiet = gone.empty() ? quiet + 1 : 0;
    if (!gone.empty()) std::erase_if(left, [&](std::uint32_t at) { return mask[at] == 0; });
  }
  return left;
}

}  // namespace penpose::io
