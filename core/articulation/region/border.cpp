#include "core/articulation/region/border.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "core/curve/polyline.h"

namespace penpose::articulation {
namespace {

/// An edge that leads out of the region, by its welded ends.
using Crossing = std::pair<std::uint32_t, std::uint32_t>;

constexpr std::size_t k_kernel = 5;

}  // namespace

std::vector<std::vector<ModelPoint>> border_of(const Canvas& canvas, const Region& region) {
  const auto weld = canvas.mesh().weld();
  std::vector<std::uint8_t> inside(canvas.positions().size(), 0);
  for (const std::uint32_t v : region.vertices) inside[weld[v]] = 1;
  // Within a triangle the border runs from one crossed edge to the other.
  std::map<Crossing, std::vector<Crossing>> beside;
  for (const mesh::Triangle& t : canvas.mesh().triangles()) {
    std::array<Crossing, 2> crossed;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3 && count < 2; ++k) {
      const std::uint32_t a = weld[t[k]];
      const std::uint32_t b = weld[t[(k + 1) % 3]];
      if (inside[a] != inside[b]) crossed[count++] = std::minmax(a, b);
    }
    if (count < 2) continue;
    beside[crossed[0]].push_back(crossed[1]);
    beside[crossed[1]].push_back(crossed[0]);
  }
  std::map<Crossing, bool> done;
  const auto place = [&](const Crossing& edge) {
    return (canvas.positions()[edge.first] + canvas.positions()[edge.second]) * 0.5;
  };
  std::vector<std::vector<ModelPoint>> lines;
  const auto walk = [&](const Crossing& from) {
    std::vector<ModelPoint> line{place(from)};
    done[from] = true;
    const Crossing* at = &from;
    for (bool on = true; on;) {
      on = false;
      for (const Crossing& next : beside.at(*at)) {
        if (done[next]) continue;
        done[next] = true;
        line.push_back(place(next));
        at = &beside.find(next)->first;
        on = true;
        break;
      }
    }
    const auto& ends = beside.at(*at);
    if (line.size() > 2 && std::find(ends.begin(), ends.end(), from) != ends.end()) line.push_back(line.front());
    if (line.size() > 1) lines.push_back(curve::triangle_filter<ModelPoint>(line, k_kernel, curve::Ends::fixed));
  };
  // Open lines from their ends, then closed ones.
  for (const auto& [edge, others] : beside) {
    if (others.size() == 1 && !done[edge]) walk(edge);
  }
  for (const auto& [edge, others] : beside) {
    if (!done[edge]) walk(edge);
  }
  return lines;
}

}  // namespace penpose::articulation
