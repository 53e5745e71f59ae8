#include "ui/render/document_curves.h"

#include <utility>

namespace penpose::render {

std::vector<CurveDrawing> document_curves(const document::Document& document) {
  std::vector<CurveDrawing> drawings;
  if (document.face) {
    for (const document::FaceLine& line : document.face->lines) {
      auto points = document::points_of(document.face->view, line.line, document.face->middle);
      if (!points) continue;
      CurveDrawing drawing;
      drawing.kind = CurveKind::target;
      drawing.points = std::move(*points);
      drawings.push_back(std::move(drawing));
    }
  }
  if (document.curves.empty()) return drawings;
  const document::Model& model = *document.model;
  std::vector<geometry::ModelPoint> positions(model.mesh->vertex_count());
  model.rig->evaluate(document.pose, positions);
  for (const auto& curve : document.curves) {
    CurveDrawing drawing;
    drawing.kind = curve->role == document::PoseCurveRole::constraint ? CurveKind::constraint : CurveKind::reference;
    for (const mesh::MeshPoint& point : curve->points) {
      drawing.points.push_back(mesh::position_of(point, model.mesh->triangles(), positions));
    }
    drawings.push_back(std::move(drawing));
    if (!curve->target) continue;
    CurveDrawing target;
    target.kind = CurveKind::target;
    target.points = curve->target->points;
    drawings.push_back(std::move(target));
  }
  return drawings;
}

}  // namespace penpose::render
