#include "ui/render/gl/curve_pass.h"

#include <algorithm>
#include <cstddef>
#include <epoxy/gl.h>
#include <utility>

#include "ui/render/gl/shaders.h"
#include "ui/render/picture/curve_quads.h"

namespace penpose::render {
namespace {

const void* byte_offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

struct Run {
  int first = 0;
  int count = 0;
  bool highlighted = false;
};

}  // namespace

base::Result<CurvePass> CurvePass::make(const GlDialect& dialect) {
  auto program =
      GlProgram::make(dialect, k_curve_vertex, k_curve_fragment, {"corner", "ends", "radii", "color", "order"});
  if (!program) return program.error();
  CurvePass made;
  made.program_ = std::move(*program);
  glGenVertexArrays(1, &made.vertex_array_);
  glGenBuffers(1, &made.corners_);
  glBindVertexArray(made.vertex_array_);
  glBindBuffer(GL_ARRAY_BUFFER, made.corners_);
  const auto attribute = [](unsigned place, int size, unsigned type, bool normalized, std::size_t start) {
    glEnableVertexAttribArray(place);
    glVertexAttribPointer(place, size, type, normalized ? GL_TRUE : GL_FALSE, sizeof(CurveCorner), byte_offset(start));
  };
  attribute(0, 2, GL_FLOAT, false, offsetof(CurveCorner, x));
  attribute(1, 4, GL_FLOAT, false, offsetof(CurveCorner, ends));
  attribute(2, 2, GL_FLOAT, false, offsetof(CurveCorner, radii));
  attribute(3, 4, GL_UNSIGNED_BYTE, true, offsetof(CurveCorner, color));
  attribute(4, 1, GL_FLOAT, false, offsetof(CurveCorner, order));
  glBindVertexArray(0);
  return made;
}

CurvePass::CurvePass(CurvePass&& other) noexcept
    : program_(std::move(other.program_)),
      vertex_array_(std::exchange(other.vertex_array_, 0)),
      corners_(std::exchange(other.corners_, 0)) {}

CurvePass::~CurvePass() {
  if (vertex_array_ != 0) glDeleteVertexArrays(1, &vertex_array_);
  if (corners_ != 0) glDeleteBuffers(1, &corners_);
}

void CurvePass::draw(std::span<const CurveDrawing> curves, const geometry::Camera& camera) const {
  std::vector<CurveCorner> corners;
  std::vector<Run> runs;
  for (const bool highlighted : {false, true}) {
    for (const CurveDrawing& curve : curves) {
      if (curve.highlighted != highlighted) continue;
      const auto quads = curve_quads(curve, camera);
      if (quads.empty()) continue;
      runs.push_back({static_cast<int>(corners.size()), static_cast<int>(quads.size()), highlighted});
      corners.insert(corners.end(), quads.begin(), quads.end());
    }
  }
  if (runs.empty()) return;
  glBindVertexArray(vertex_array_);
  glBindBuffer(GL_ARRAY_BUFFER, corners_);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * sizeof(CurveCorner)), corners.data(),
               GL_STREAM_DRAW);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glClear(GL_DEPTH_BUFFER_BIT);
  glDisable(GL_CULL_FACE);
  program_.use();
  program_.set("size_px", static_cast<float>(camera.viewport().width), static_cast<float>(camera.viewport().height));
  program_.set("outline_px", k_outline_px);
  const float slice = 0.98F / static_cast<float>(runs.size());
  program_.set("slice", slice * 0.99F);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Run& run = runs[i];
    program_.set("halo_px", run.highlighted ? k_halo_px : 0.0F);
    program_.set("first_depth", 0.99F - slice * static_cast<float>(i));
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDepthFunc(GL_LESS);
    glDrawArrays(GL_TRIANGLES, run.first, run.count);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDepthFunc(GL_EQUAL);
    glDrawArrays(GL_TRIANGLES, run.first, run.count);
    glDisable(GL_BLEND);
  }
  glBindVertexArray(0);
}

}  // namespace penpose::render
