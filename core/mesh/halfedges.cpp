#include "core/mesh/halfedges.h"

namespace penpose::mesh {

Halfedges::Id Halfedges::find(Id from, Id to) const {
  const Id first = outgoing_[from];
  if (first == k_none) return k_none;
  Id halfedge = first;
  do {
    if (end(halfedge) == to) return halfedge;
    halfedge = turned(halfedge);
  } while (halfedge != first);
  return k_none;
}

Halfedges::Id Halfedges::add_edge(Id from, Id to) {
  const auto first = static_cast<Id>(all_.size());
  all_.push_back({to, k_none, k_none, k_none});
  all_.push_back({from, k_none, k_none, k_none});
  return first;
}

void Halfedges::link(Id from, Id to) {
  all_[from].next = to;
  all_[to].previous = from;
}

/// Where two sides that are there already meet, and faces of another fan lie between them, that fan moves to another
/// gap around the vertex. Nothing where there is no other gap.
std::optional<std::vector<Halfedges::Link>> Halfedges::joined_borders(const std::vector<Id>& sides) const {
  std::vector<Link> links;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Id before = sides[i];
    const Id after = sides[(i + 1) % sides.size()];
    if (before == k_none || after == k_none || next(before) == after) continue;
    Id gap = opposite(after);
    do {
      gap = opposite(next(gap));
    } while (!is_border(gap));
    if (gap == before) return std::nullopt;
    links.push_back({gap, next(before)});
    links.push_back({all_[after].previous, next(gap)});
    links.push_back({before, after});
  }
  return links;
}

bool Halfedges::add(const Quad& quad) {
  const std::size_t count = quad.size();
  std::vector<Id> sides(count, k_none);
  for (std::size_t i = 0; i < count; ++i) {
    const Id around = outgoing_[quad[i]];
    if (around != k_none && !is_border(around)) return false;
    sides[i] = find(quad[i], quad[(i + 1) % count]);
    if (sides[i] != k_none && !is_border(sides[i])) return false;
  }
  // Links are made at the end: until then every step sees the mesh as it was before.
  auto links = joined_borders(sides);
  if (!links) return false;
  std::vector<bool> is_new(count, false);
  for (std::size_t i = 0; i < count; ++i) {
    is_new[i] = sides[i] == k_none;
    if (is_new[i]) sides[i] = add_edge(quad[i], quad[(i + 1) % count]);
  }
  const Id face = faces_++;
  std::vector<Id> closed;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t j = (i + 1) % count;
    const Id vertex = quad[j];
    const Id before = sides[i];
    const Id after = sides[j];
    const Id outside_in = opposite(after);
    const Id outside_out = opposite(before);
    if (is_new[i] && is_new[j]) {
      if (const Id border = outgoing_[vertex]; border == k_none) {
        outgoing_[vertex] = outside_out;
        links->push_back({outside_in, outside_out});
      } else {
        links->push_back({all_[border].previous, outside_out});
        links->push_back({outside_in, border});
      }
    } else if (is_new[i]) {
      links->push_back({all_[after].previous, outside_out});
      outgoing_[vertex] = outside_out;
    } else if (is_new[j]) {
      links->push_back({outside_in, next(before)});
      outgoing_[vertex] = next(before);
    } else if (outgoing_[vertex] == after) {
      closed.push_back(vertex);
    }
    if (is_new[i] || is_new[j]) links->push_back({before, after});
    all_[before].face = face;
  }
  for (const Link& one : *links) link(one.from, one.to);
  // A ring starts along its border as long as it has one.
  for (const Id vertex : closed) {
    const Id first = outgoing_[vertex];
    Id halfedge = first;
    do {
      if (is_border(halfedge)) {
        outgoing_[vertex] = halfedge;
        break;
      }
      halfedge = turned(halfedge);
    } while (halfedge != first);
  }
  return true;
}

}  // namespace penpose::mesh
