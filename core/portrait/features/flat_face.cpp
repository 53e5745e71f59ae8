#include "core/portrait/features/flat_face.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/portrait/features/eyes.h"
#include "core/portrait/sketch/face_layout.h"
#include "core/portrait/sketch/habits.h"
#include "core/portrait/surface/face_frame.h"
#include "core/portrait/surface/face_image.h"

namespace penpose::portrait {
namespace {

/// Rows of the picture, and how far it goes beyond what shapes move, as a share of its larger side.
constexpr double k_flat_rows = 320, k_flat_beyond = 0.6;
/// Areas that are looked at, as shares of the picture; larger ones are the head or what is behind it.
constexpr double k_least_area = 2e-4, k_most_area = 0.12;
constexpr std::size_t k_most_areas = 60;
/// Paint is another area if it differs from most of its piece by more than this, display values.
constexpr double k_other_paint = 0.2;
/// Places of which the usual paint of a piece is the median.
constexpr std::size_t k_paint_samples = 500;
/// Halves of a mouth meet within so many px of the middle. Areas mirror each other within this share of their distance,
/// and their sizes within the other one.
constexpr double k_middle_px = 3, k_mirrored = 0.06, k_mirrored_sizes = 0.25;
/// What a control shuts costs less as an eye, by this.
constexpr double k_closing_gain = 1.0;
/// How sure features of a flat face are at best.
constexpr double k_of_flat = 0.8;

/// An area of the picture: the rows of its border at each column.
struct Area {
  int left = 0;
  std::vector<int> top, bottom;  ///< top: the higher row
  double px = 0;
  bool at_border = false;
  [[nodiscard]] int right() const { return left + static_cast<int>(top.size()) - 1; }
};

class FrontView {
 public:
  explicit FrontView(const FaceSurface& surface)
      : mesh_(surface.mesh()),
        places_(surface.places()),
        image_(box_of(surface.place().box), size_of(surface.place().box) * (1 + 2 * k_flat_beyond) / k_flat_rows) {
    std::vector<std::uint32_t> every(mesh_.triangle_count());
    for (std::uint32_t t = 0; t < every.size(); ++t) every[t] = t;
    image_.draw(places_, mesh_.triangles(), every);
  }

  [[nodiscard]] const FaceImage& image() const { return image_; }
  [[nodiscard]] bool shows(int x, int y) const { return image_.triangle(x, y) != FaceImage::k_nothing; }
  [[nodiscard]] std::uint32_t component(int x, int y) const {
    return mesh_.components()[mesh_.triangles()[image_.triangle(x, y)][0]];
  }
  [[nodiscard]] mesh::MeshPoint at(int x, int y) const {
    const std::uint32_t number = image_.triangle(x, y);
    const mesh::Triangle& t = mesh_.triangles()[number];
    return {number, seen_barycentric(image_.place(x, y), places_[t[0]], places_[t[1]], places_[t[2]])};
  }

 private:
  static double size_of(const geometry::Box& box) {
    return std::max(box.maximum.x - box.minimum.x, box.maximum.y - box.minimum.y);
  }
  static geometry::Box box_of(geometry::Box box) {
    const double half = size_of(box) * (0.5 + k_flat_beyond);
    const ModelPoint middle = box.center();
    box.minimum = {middle.x - half, middle.y - half, box.minimum.z};
    box.maximum = {middle.x + half, middle.y + half, box.maximum.z};
    return box;
  }

  const mesh::TriangleMesh& mesh_;
  std::span<const ModelPoint> places_;
  FaceImage image_;
};

/// The class of each px: 0 nothing; px of one class beside each other are one area.
std::vector<std::uint32_t> classes_of(const FrontView& view, const SurfacePaint& paint, std::size_t components) {
  const FaceImage& image = view.image();
  const auto width = static_cast<std::size_t>(image.width()), height = static_cast<std::size_t>(image.height());
  std::vector<std::uint32_t> classes(width * height, 0);
  std::vector<std::vector<std::size_t>> px_of(components);
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const int x = static_cast<int>(i % width), y = static_cast<int>(i / width);
    if (!view.shows(x, y)) continue;
    const std::uint32_t component = view.component(x, y);
    classes[i] = 2 * component + 1;
    px_of[component].push_back(i);
  }
  if (!paint) return classes;
  for (const auto& px : px_of) {
    if (static_cast<double>(px.size()) < k_most_area * static_cast<double>(classes.size())) continue;
    const auto color_at = [&](std::size_t i) {
      return paint(view.at(static_cast<int>(i % width), static_cast<int>(i / width)));
    };
    std::array<double, 3> usual{};
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<double> values;
      const std::size_t step = px.size() / k_paint_samples + 1;
      for (std::size_t i = 0; i < px.size(); i += step) values.push_back(color_at(px[i])[c]);
      std::stable_sort(values.begin(), values.end());
      usual[c] = values[values.size() / 2];
    }
    for (const std::size_t i : px) {
      const auto color = color_at(i);
      double square = 0;
      for (std::size_t c = 0; c < 3; ++c) square += (color[c] - usual[c]) * (color[c] - usual[c]);
      if (std::sqrt(square / 3.0) > k_other_paint) ++classes[i];
    }
  }
  return classes;
}

/// Takes the connected px of one class from a start.
Area area_from(const FaceImage& image, std::vector<std::uint32_t>& classes, std::size_t start) {
  const auto width = static_cast<std::size_t>(image.width()), height = static_cast<std::size_t>(image.height());
  const std::uint32_t own = classes[start];
  std::vector<std::size_t> px{start};
  classes[start] = 0;
  std::size_t low = start % width, high = low;
  Area area;
  for (std::size_t i = 0; i < px.size(); ++i) {
    const std::size_t x = px[i] % width, y = px[i] / width;
    low = std::min(low, x);
    high = std::max(high, x);
    if (x == 0 || y == 0 || x + 1 == width || y + 1 == height) {
      area.at_border = true;
      if (x == 0 || x + 1 == width) continue;
    }
    for (const std::size_t next : {px[i] - 1, px[i] + 1, px[i] - width, px[i] + width}) {
      if (next >= classes.size() || classes[next] != own) continue;
      classes[next] = 0;
      px.push_back(next);
    }
  }
  area.left = static_cast<int>(low);
  area.px = static_cast<double>(px.size());
  area.top.assign(high - low + 1, -1);
  area.bottom.assign(high - low + 1, image.height());
  for (const std::size_t i : px) {
    const std::size_t column = i % width - low;
    const int y = static_cast<int>(i / width);
    area.top[column] = std::max(area.top[column], y);
    area.bottom[column] = std::min(area.bottom[column], y);
  }
  return area;
}

std::vector<Area> areas_of(const FrontView& view, const SurfacePaint& paint, std::size_t components) {
  std::vector<std::uint32_t> classes = classes_of(view, paint, components);
  const auto all = static_cast<double>(classes.size());
  std::vector<Area> areas;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    if (classes[i] == 0) continue;
    Area area = area_from(view.image(), classes, i);
    if (!area.at_border && area.px > k_least_area * all && area.px < k_most_area * all)
      areas.push_back(std::move(area));
  }
  std::stable_sort(areas.begin(), areas.end(), [](const Area& a, const Area& b) { return a.px > b.px; });
  if (areas.size() > k_most_areas) areas.resize(k_most_areas);
  return areas;
}

/// The outline as a line of a drawing, y down.
std::vector<PxPoint> outline_of(const Area& area) {
  std::vector<PxPoint> line;
  for (std::size_t i = 0; i < area.top.size(); ++i)
    line.push_back({area.left + static_cast<double>(i), -static_cast<double>(area.top[i])});
  for (std::size_t i = area.bottom.size(); i-- > 0;)
    line.push_back({area.left + static_cast<double>(i), -static_cast<double>(area.bottom[i])});
  line.push_back(line.front());
  return line;
}

/// Joins areas that meet in the middle of the face: the two halves of a mouth.
std::vector<Area> joined_in_middle(std::vector<Area> areas, double middle) {
  for (std::size_t a = 0; a < areas.size(); ++a) {
    for (std::size_t b = 0; b < areas.size(); ++b) {
      Area& one = areas[a];
      const Area& other = areas[b];
      const bool meet = std::abs(one.right() + 1 - other.left) <= 1 && std::abs(other.left - middle) < k_middle_px &&
                        one.top.back() >= other.bottom.front() && other.top.front() >= one.bottom.back();
      if (a == b || !meet) continue;
      one.top.resize(static_cast<std::size_t>(other.left - one.left), one.top.back());
      one.bottom.resize(one.top.size(), one.bottom.back());
      one.top.insert(one.top.end(), other.top.begin(), other.top.end());
      one.bottom.insert(one.bottom.end(), other.bottom.begin(), other.bottom.end());
      one.px += other.px;
      areas.erase(areas.begin() + static_cast<std::ptrdiff_t>(b));
      return joined_in_middle(std::move(areas), middle);
    }
  }
  return areas;
}

/// Returns whether two areas mirror each other about a column.
bool mirror_each_other(const Area& right, const Area& left, double middle) {
  const auto height = [](const Area& area) {
    return static_cast<double>(*std::max_element(area.top.begin(), area.top.end()) -
                               *std::min_element(area.bottom.begin(), area.bottom.end()));
  };
  const auto row = [](const Area& area) {
    return 0.5 * (area.top[area.top.size() / 2] + area.bottom[area.top.size() / 2]);
  };
  const double apart = 0.5 * (left.left + left.right() - right.left - right.right());
  const double off = 0.25 * (left.left + left.right() + right.left + right.right()) - middle;
  return apart > 0 && std::abs(off) < k_mirrored * apart && std::abs(row(left) - row(right)) < k_mirrored * apart &&
         std::abs(height(left) - height(right)) < 2 + k_mirrored_sizes * height(left) &&
         std::abs(left.px - right.px) < k_mirrored_sizes * std::max(left.px, right.px);
}

enum class Border : unsigned char { top, middle, bottom };

/// A border of areas as one, from low to high columns.
FoundLine border_of(const FrontView& view, const std::vector<const Area*>& areas, Border border) {
  int low = view.image().width(), high = -1;
  for (const Area* area : areas) {
    low = std::min(low, area->left);
    high = std::max(high, area->right());
  }
  FoundLine line;
  for (int x = low; x <= high; ++x) {
    int top = -1, bottom = view.image().height();
    for (const Area* area : areas) {
      if (x < area->left || x > area->right()) continue;
      const auto column = static_cast<std::size_t>(x - area->left);
      top = std::max(top, area->top[column]);
      bottom = std::min(bottom, area->bottom[column]);
    }
    if (top < 0) continue;
    const int y = border == Border::top ? top : border == Border::bottom ? bottom : (top + bottom) / 2;
    if (view.shows(x, y)) line.points.push_back(view.at(x, y));
  }
  return line;
}

/// An area as an eye.
Eye eye_of_area(const FrontView& view, const FaceSurface& surface, const Area& area) {
  Eye eye;
  eye.upper = border_of(view, {&area}, Border::top);
  eye.lower = border_of(view, {&area}, Border::bottom);
  const ModelPoint left = surface.position(eye.upper.points.front()), right = surface.position(eye.upper.points.back());
  eye.centre = (left + right) * 0.5;
  eye.width = geometry::distance(left, right);
  return eye;
}

/// The largest area of a side with one of two parts.
const Area* largest(const std::vector<Area>& areas, const FaceLayout& layout, bool left, FacePart part,
                    FacePart or_part) {
  const Area* best = nullptr;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const FaceMark& mark = layout.marks[layout.mark_of_line[i]];
    if ((mark.part != part && mark.part != or_part) || mark.right != left) continue;
    if (mark.part == FacePart::fold && mark.middle().y > 0) continue;  // a bag below an eye
    if (best == nullptr || areas[i].px > best->px) best = &areas[i];
  }
  return best;
}

}  // namespace

std::optional<FlatFace> find_flat_face(const rig::Rig& rig, const intent::WholeModel& whole, const FaceSurface& surface,
                                       const SurfacePaint& paint) {
  if (!surface.place().of_shapes) return std::nullopt;
  const FrontView view(surface);
  const std::vector<Area> areas =
      joined_in_middle(areas_of(view, paint, surface.mesh().component_count()), view.image().column(0.0));
  std::vector<std::vector<PxPoint>> lines;
  for (const Area& area : areas) lines.push_back(outline_of(area));
  if (lines.size() < 3) return std::nullopt;
  const auto eyes_cost = [&](std::size_t right, std::size_t left) {
    if (!mirror_each_other(areas[right], areas[left], view.image().column(0.0))) return k_unknown_cost;
    return -k_closing_gain * closing(rig, whole, surface, eye_of_area(view, surface, areas[left]));
  };
  const auto layout = find_face(lines, eyes_cost);
  if (!layout || layout->cost > k_most_cost) return std::nullopt;
  const double sureness = k_of_flat * (1.0 - layout->cost / (2.0 * k_most_cost));
  FlatFace face;
  for (std::size_t side = 0; side < 2; ++side) {
    const bool left = side == 1;
    const Area* eye = largest(areas, *layout, left, FacePart::eye, FacePart::pupil);
    if (eye == nullptr) return std::nullopt;
    face.upper_lids[side] = border_of(view, {eye}, Border::top);
    face.lower_lids[side] = border_of(view, {eye}, Border::bottom);
    if (const Area* brow = largest(areas, *layout, left, FacePart::brow, FacePart::fold))
      face.brows[side] = border_of(view, {brow}, Border::middle);
    for (FoundLine* line : {&face.upper_lids[side], &face.lower_lids[side], &face.brows[side]}) {
      if (left) std::reverse(line->points.begin(), line->points.end());
      line->sureness = sureness;
    }
  }
  std::vector<const Area*> mouth;
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (layout->marks[layout->mark_of_line[i]].part == FacePart::mouth) mouth.push_back(&areas[i]);
  }
  face.upper_lip = border_of(view, mouth, Border::top);
  face.lower_lip = border_of(view, mouth, Border::bottom);
  face.between_lips = border_of(view, mouth, Border::middle);
  for (FoundLine* line : {&face.upper_lip, &face.lower_lip, &face.between_lips}) line->sureness = sureness;
  return face;
}

}  // namespace penpose::portrait
