#include "ui/app/view/present/gl/gl_panels.h"

#include <cstddef>
#include <epoxy/gl.h>
#include <imgui.h>
#include <span>
#include <string_view>
#include <utility>

#include "ui/render/gl/vertex_data.h"

namespace penpose::app {
namespace {

static_assert(sizeof(ImDrawIdx) == 2, "OpenGL ES 2.0 has no others");

/// Px from the upper left corner.
constexpr std::string_view k_panel_vertex = R"(
from_buffer vec2 position;
from_buffer vec2 letter;
from_buffer vec4 color;
uniform vec2 size_px;
to_fragment vec2 at;
to_fragment vec4 ink;
void main() {
  at = letter;
  ink = color;
  gl_Position = vec4(position.x / size_px.x * 2.0 - 1.0, 1.0 - position.y / size_px.y * 2.0, 0.0, 1.0);
}
)";

constexpr std::string_view k_panel_fragment = R"(
from_vertex vec2 at;
from_vertex vec4 ink;
uniform sampler2D picture;
void main() {
  result = ink * sample_picture(picture, at);
}
)";

}  // namespace

base::Result<GlPanels> GlPanels::make(const render::GlDialect& dialect) {
  auto program = render::GlProgram::make(dialect, k_panel_vertex, k_panel_fragment, {"position", "letter", "color"});
  if (!program) return program.error();
  return GlPanels(dialect, std::move(*program));
}

GlPanels::GlPanels(const render::GlDialect& dialect, render::GlProgram program)
    : program_(std::move(program)), array_(dialect) {
  glGenBuffers(1, &corners_);
  glGenBuffers(1, &indices_);
  array_.set({0, corners_, 2, GL_FLOAT, sizeof(ImDrawVert), offsetof(ImDrawVert, pos)});
  array_.set({1, corners_, 2, GL_FLOAT, sizeof(ImDrawVert), offsetof(ImDrawVert, uv)});
  array_.set({2, corners_, 4, GL_UNSIGNED_BYTE, sizeof(ImDrawVert), offsetof(ImDrawVert, col)});
  array_.set_indices(indices_);
  array_.unbind();
}

GlPanels::~GlPanels() {
  for (const unsigned buffer : {corners_, indices_}) {
    if (buffer != 0) glDeleteBuffers(1, &buffer);
  }
  if (letters_ != 0) glDeleteTextures(1, &letters_);
}

GlPanels::GlPanels(GlPanels&& other) noexcept
    : program_(std::move(other.program_)),
      array_(std::move(other.array_)),
      corners_(std::exchange(other.corners_, 0)),
      indices_(std::exchange(other.indices_, 0)),
      letters_(std::exchange(other.letters_, 0)) {}

void GlPanels::send_letters() {
  unsigned char* pixels = nullptr;
  int width = 0;
  int height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  if (letters_ == 0) glGenTextures(1, &letters_);
  glBindTexture(GL_TEXTURE_2D, letters_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void GlPanels::draw(const ImDrawData& panels) const {
  const auto px = [&](float length, float scale) { return static_cast<int>(length * scale); };
  const ImVec2 scale = panels.FramebufferScale;
  const int width = px(panels.DisplaySize.x, scale.x);
  const int height = px(panels.DisplaySize.y, scale.y);
  if (width <= 0 || height <= 0) return;
  glViewport(0, 0, width, height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  // What the window shows stays opaque.
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glEnable(GL_SCISSOR_TEST);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, letters_);
  program_.use();
  program_.set("picture", 0);
  program_.set("size_px", panels.DisplaySize.x, panels.DisplaySize.y);
  for (const ImDrawList* list : std::span(panels.CmdLists, static_cast<std::size_t>(panels.CmdListsCount))) {
    render::fill(GL_ARRAY_BUFFER, corners_, std::span<const ImDrawVert>(list->VtxBuffer.begin(), list->VtxBuffer.end()),
                 GL_STREAM_DRAW);
    array_.bind();
    render::fill(GL_ELEMENT_ARRAY_BUFFER, indices_,
                 std::span<const ImDrawIdx>(list->IdxBuffer.begin(), list->IdxBuffer.end()), GL_STREAM_DRAW);
    for (const ImDrawCmd& command : list->CmdBuffer) {
      const ImVec4& clip = command.ClipRect;
      if (clip.z <= clip.x || clip.w <= clip.y) continue;
      glScissor(px(clip.x, scale.x), px(panels.DisplaySize.y - clip.w, scale.y), px(clip.z - clip.x, scale.x),
                px(clip.w - clip.y, scale.y));
      array_.bind(command.VtxOffset);
      glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount), GL_UNSIGNED_SHORT,
                     render::offset(command.IdxOffset * sizeof(ImDrawIdx)));
    }
  }
  array_.unbind();
  glBindTexture(GL_TEXTURE_2D, 0);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
}

}  // namespace penpose::app
