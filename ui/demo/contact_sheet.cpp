#include "ui/demo/contact_sheet.h"

#include <algorithm>
#include <array>
#include <utility>

#include "ui/demo/label.h"
#include "ui/render/appearance.h"
#include "ui/render/renderer.h"

namespace penpose::demo {
namespace {

constexpr int k_margin_px = 10;
constexpr int k_title_scale = 2;
constexpr int k_line_px = 12;

void copy_into(render::Image& sheet, const render::Image& cell, int x, int y) {
  for (int row = 0; row < cell.height; ++row) {
    const std::size_t to =
        (static_cast<std::size_t>(y + row) * static_cast<std::size_t>(sheet.width) + static_cast<std::size_t>(x)) * 4;
    std::copy_n(cell.at(0, row), static_cast<std::size_t>(cell.width) * 4,
                sheet.pixels.begin() + static_cast<std::ptrdiff_t>(to));
  }
}

void label(render::Image& image, const SheetCell& cell) {
  draw_label(image, k_margin_px, k_margin_px, k_title_scale, cell.title, render::from_srgb(0xf2f4f6));
  int y = image.height - k_margin_px - k_letter_height_px;
  for (auto legend = cell.regions.legends.rbegin(); legend != cell.regions.legends.rend(); ++legend) {
    draw_label(image, k_margin_px, y, 1, legend->text, legend->color);
    y -= k_line_px;
  }
}

}  // namespace

geometry::CameraPose sheet_camera() { return {{0.13, 0.005, 0.80}, {0.003, -0.006, 0.02}, {0, 1, 0}, 19.5}; }

base::Result<render::Image> draw_contact_sheet(const document::Model& model, std::span<const SheetCell> cells) {
  auto renderer = render::make_offscreen_renderer();
  if (!renderer) return renderer.error();
  const auto camera = geometry::Camera::make(sheet_camera(), k_sheet_cell);
  if (!camera) return camera.error();
  const render::Appearance appearance = render::make_appearance(model);
  const int rows = (static_cast<int>(cells.size()) + k_sheet_columns - 1) / k_sheet_columns;
  render::Image sheet;
  sheet.width = k_sheet_columns * k_sheet_cell.width;
  sheet.height = rows * k_sheet_cell.height;
  // Where there is no picture it is as dark as they are.
  constexpr std::array<std::uint8_t, 4> k_empty{0x2b, 0x30, 0x37, 0xff};
  sheet.pixels.resize(static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height) * k_empty.size());
  for (std::size_t i = 0; i < sheet.pixels.size(); ++i) sheet.pixels[i] = k_empty[i % k_empty.size()];

  document::Model posed_model = model;
  render::Scene scene;
  scene.triangles = model.mesh->triangles();
  scene.appearance = &appearance;
  scene.background = {render::from_srgb(0x4a525c), render::from_srgb(0x2b3037)};
  scene.shape_number = 1;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    posed_model.pose = cells[i].pose;
    const render::PosedMesh posed = render::posed_mesh(posed_model);
    scene.positions = posed.positions;
    scene.normals = posed.normals;
    scene.overlay = cells[i].regions.overlay;
    auto image = (*renderer)->render(scene, *camera);
    if (!image) return image.error();
    label(*image, cells[i]);
    const int column = static_cast<int>(i) % k_sheet_columns;
    const int row = static_cast<int>(i) / k_sheet_columns;
    copy_into(sheet, *image, column * k_sheet_cell.width, row * k_sheet_cell.height);
  }
  return sheet;
}

}  // namespace penpose::demo
