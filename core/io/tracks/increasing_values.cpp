#include "core/io/tracks/increasing_values.h"

#include <algorithm>
#include <cmath>

namespace penpose::io {

IncreasingValues find_increasing(std::span<const std::optional<double>> values) {
  // The longest increasing subsequence: ends[k] is the lowest value that one of length k + 1 can end with.
  IncreasingValues increasing;
  increasing.in_order.resize(values.size());
  std::vector<std::size_t> ends;
  std::vector<std::size_t> before(values.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i]) continue;
    ++increasing.known;
    const auto at = std::lower_bound(ends.begin(), ends.end(), *values[i],
                                     [&](std::size_t end, double value) { return *values[end] < value; });
    if (at != ends.begin()) before[i] = *(at - 1);
    if (at == ends.end()) {
      ends.push_back(i);
    } else if (*values[i] < *values[*at]) {
      *at = i;  // of equal ones the first stays
    }
  }
  std::size_t i = ends.empty() ? values.size() : ends.back();
  for (; i < values.size(); i = before[i]) increasing.in_order[i] = true;
  increasing.out_of_order = increasing.known - ends.size();
  return increasing;
}

double typical_step(std::span<const std::optional<double>> values) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] && values[i - 1] && *values[i] > *values[i - 1]) steps.push_back(*values[i] - *values[i - 1]);
  }
  if (steps.empty()) return 0;
  // Of two in the middle the lower one: what is left out makes steps longer, nothing makes them shorter.
  std::stable_sort(steps.begin(), steps.end());
  const double middle = steps[(steps.size() - 1) / 2];
  // The mean of those about it, as files round their times.
  double sum = 0;
  double count = 0;
  for (const double step : steps) {
    if (std::abs(step - middle) > middle / 2) continue;
    sum += step;
    ++count;
  }
  return sum / count;
}

std::optional<std::size_t> find_leap(std::span<const std::optional<double>> values, const IncreasingValues& increasing,
                                     double least) {
  const double step = typical_step(values);
  if (!increasing.trusted() || !(step > 0)) return std::nullopt;
  const double most = std::max(least, 10 * step * static_cast<double>(values.size()));
  std::optional<double> before;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!increasing.in_order[i]) continue;
    if (before && *values[i] - *before > most) return i;
    before = values[i];
  }
  return std::nullopt;
}

std::vector<double> interpolate_missing(std::span<const std::optional<double>> times,
                                        const IncreasingValues& increasing, std::span<const double> places) {
  std::vector<std::size_t> sure;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (increasing.in_order[i]) sure.push_back(i);
  }
  std::vector<double> result(times.size());
  std::size_t after = 1;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (increasing.in_order[i]) {
      result[i] = *times[i];
      continue;
    }
    while (after + 1 < sure.size() && sure[after] < i) ++after;
    const std::size_t a = sure[after - 1];
    const std::size_t b = sure[after];
    // Beyond both ends time goes on at the rate of the whole, not at that of a pair.
    const bool inside = a < i && i < b;
    const std::size_t from = inside ? a : i < sure.front() ? sure.front() : sure.back();
    const double rate =
        inside ? (*times[b] - *times[a]) / (places[b] - places[a])
               : (*times[sure.back()] - *times[sure.front()]) / (places[sure.back()] - places[sure.front()]);
    result[i] = *times[from] + (places[i] - places[from]) * rate;
  }
  return result;
}

}  // namespace penpose::io
