#pragma once

#include <string>

#include "core/base/result.h"
#include "core/document/model.h"
#include "core/geometry/camera.h"
#include "ui/cli/parser/command.h"

namespace penpose::cli {

/// How large a picture is and from where it is taken.
struct PictureOptions {
  std::string size = "1024x1024";
  std::string camera;  ///< a file; empty: by the view
  std::string view = "three-quarter";
};

/// Adds --size, --camera and --view; their defaults are what `options` says now, where a view may be one of the
/// command's own.
void add_picture_options(const Command& command, PictureOptions& options);

/// The size that --size says, which was checked when it was parsed.
[[nodiscard]] geometry::Viewport size_of(const PictureOptions& options);

/// Where the camera stands: the file's, or one that shows the whole model at rest, so that poses of one model can be
/// compared picture by picture; `as_posed`: as it is posed. Errors of the camera's file.
[[nodiscard]] base::Result<geometry::Camera> make_camera(const PictureOptions& options, const document::Model& model,
                                                         bool as_posed);

}  // namespace penpose::cli
