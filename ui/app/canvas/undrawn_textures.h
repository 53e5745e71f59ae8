#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/document/model.h"
#include "ui/app/notices.h"

namespace penpose::app {

/// Tells of the textures of the model that cannot be drawn, in one notice: those that are known when the file is read
/// and those that turn out when they are unpacked.
class UndrawnTextures {
 public:
  explicit UndrawnTextures(Notices& notices) : notices_(notices) {}

  /// Those of the model that is open, each "NAME (why)".
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  /// Another model was opened.
  void begin(const document::Model& model);
  /// Of this look these could not be unpacked; nothing is told of a model that is no longer open.
  void add(const std::shared_ptr<const document::Look>& look, const std::vector<std::string>& names);

 private:
  void tell();

  Notices& notices_;
  std::shared_ptr<const document::Look> look_;
  std::vector<std::string> names_;
  std::string told_;
};

/// What was noticed about the model, a line each: textures that cannot be drawn, one by one, then what its file's
/// reader said. The same line once.
[[nodiscard]] std::vector<std::string> notes_of(const document::Model& model, const UndrawnTextures& undrawn);

}  // namespace penpose::app
