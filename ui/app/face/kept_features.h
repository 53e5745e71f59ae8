#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/model.h"
#include "ui/app/notices.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// The features of the face: shown once when a model was opened, and as this user corrected them for every model of the
/// same mesh, in a folder "features" of the settings, a file a mesh.
class KeptFeatures {
 public:
  /// An empty folder: nothing is kept.
  KeptFeatures(std::string folder, EditingSession& editing, Notices& notices);

  /// A model was opened whose features are to be shown. One of a file that brings no corrections gets those of its
  /// mesh.
  void begin(bool of_file);
  /// Another document was opened.
  void forget();
  /// Writes what was corrected, and stops showing the features once something else is done. `time_s`: of the playhead;
  /// `plays`: it runs. Call it once a frame.
  void follow(double time_s, bool plays);

  /// Whether all features are shown because the model was just opened.
  [[nodiscard]] bool shown() const { return shown_; }
  void hide() { shown_ = false; }

  /// The file of a mesh; empty: nothing is kept.
  [[nodiscard]] std::string path_of(const mesh::TriangleMesh& mesh) const;

 private:
  void apply_kept();
  void keep();

  std::string folder_;
  EditingSession& editing_;
  Notices& notices_;
  bool shown_ = false;
  bool applied_ = false;  ///< the first step of this session is what was kept
  std::optional<double> began_at_s_;
  std::uint64_t revision_ = 0;
  std::shared_ptr<const document::Model> model_;  ///< as of the last look
};

}  // namespace penpose::app
