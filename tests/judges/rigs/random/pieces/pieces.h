#pragma once

#include <string>
#include <vector>

#include "tests/judges/rigs/parts.h"

namespace penpose::judges {

/// Pieces of mesh that go along with a skin: each of their vertices goes as vertices of the skin do.
class Pieces {
 public:
  struct Bound {
    std::uint32_t to;  ///< a vertex of the face
    double share;
  };

  explicit Pieces(const Parts& parts);
  /// From now on vertices and triangles belong to this piece.
  void begin(std::string name);
  /// Returns its number. `with` empty: it stays where it is.
  std::uint32_t add(const ModelPoint& at, std::vector<Bound> with);
  /// One that muscles of the jaw move as they move a vertex, and no others.
  std::uint32_t add_on_jaw(const ModelPoint& at, std::uint32_t chin, double share);
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { source_.triangles.push_back({a, b, c}); }
  /// Two triangles between the vertices of two rows.
  void strip(const std::vector<std::uint32_t>& low, const std::vector<std::uint32_t>& high);
  /// A ball of vertices of which `make` makes each.
  template <typename Make>
  void ball(const ModelPoint& center, const ModelVector& radii, std::size_t around, std::size_t rings, Make make) {
    std::vector<std::uint32_t> above;
    for (std::size_t r = 0; r <= rings; ++r) {
      std::vector<std::uint32_t> ring;
      for (std::size_t a = 0; a < around; ++a) ring.push_back(make(center + radii * on_ball(r, rings, a, around)));
      ring.push_back(ring.front());
      if (r > 0) strip(ring, above);
      above = std::move(ring);
    }
  }
  /// The vertex of the skin that is nearest to a place.
  [[nodiscard]] std::uint32_t nearest(const ModelPoint& at) const;
  /// Adds all of them to the face, behind its vertices.
  void attach(Parts& parts) &&;

 private:
  struct Follower {
    std::vector<Bound> with;
    bool jaw_only;
  };
  static ModelVector on_ball(std::size_t ring, std::size_t rings, std::size_t k, std::size_t around);
  void end_piece();

  mesh::MeshSource source_;
  std::size_t first_;  ///< vertex of the pieces
  std::vector<Follower> followers_;
};

}  // namespace penpose::judges
