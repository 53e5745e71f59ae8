#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/document/commands/command.h"
#include "core/document/document_hash.h"

namespace penpose::replay {

/// Makes the text of a session of what another program does to a document: every line is a command, with the state
/// after it. It keeps nothing of the text, so that who asks for it can leave it out where something else fails.
class CommandRecorder {
 public:
  explicit CommandRecorder(std::string program) : program_(std::move(program)) {}

  /// The first lines: what is worked on, and a hint of where it is.
  [[nodiscard]] std::string begin(const document::Document& document, std::string_view model_path);
  /// Commands that were done, with the document after each. Precondition: as many of the one as of the other.
  [[nodiscard]] std::string lines(std::span<const document::Command> commands,
                                  std::span<const document::Document> after);

 private:
  std::string program_;
  document::DocumentHasher hasher_;
};

}  // namespace penpose::replay
