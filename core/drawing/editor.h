#pragma once

#include "core/base/result.h"
#include "core/document/commands/apply.h"
#include "core/document/document_hash.h"
#include "core/document/history.h"
#include "core/drawing/tool.h"

namespace penpose::drawing {

/// A document in the hands of an artist: its history, where it is looked at from, and the tool. The same calls in the
/// same order give the same document, bit for bit; the app and the replay of a session make the same calls.
class Editor {
 public:
  explicit Editor(document::Document document);

  [[nodiscard]] const document::Document& document() const { return history_.document(); }
  [[nodiscard]] const document::History& history() const { return history_; }
  [[nodiscard]] const document::View& view() const { return view_; }
  [[nodiscard]] const Tool& tool() const { return tool_; }

  /// Errors: a camera that cannot be.
  base::Status set_view(const document::View& view);
  void set_tool(Tool tool) { tool_ = std::move(tool); }

  base::Status perform(const document::Command& command);
  /// The document as a command would make it. Errors: those of the command.
  [[nodiscard]] base::Result<document::Document> after(const document::Command& command) {
    return after(document(), command);
  }
  /// The same of another document, such as this one at another moment.
  [[nodiscard]] base::Result<document::Document> after(const document::Document& other,
                                                       const document::Command& command) {
    return document::apply(other, command, work_);
  }
  /// A completed stroke, with the view under which it began. Errors: those of command_of and of the command; a tap
  /// where the tool wants a line.
  base::Status draw(const curve::Stroke& stroke, const document::View& view, bool eraser);
  /// The features of the document's face; empty: none are found. Valid until the next call.
  [[nodiscard]] std::span<const portrait::FeatureCurve> features() { return document::features_of(document(), work_); }
  /// The same with those that are not sure; none: nothing of a face is found.
  [[nodiscard]] const document::FeatureCurves& all_features() { return document::all_features_of(document(), work_); }
  base::Status undo() { return history_.undo(); }
  base::Status redo() { return history_.redo(); }

  /// The canonical hash of the document as it is.
  [[nodiscard]] document::DocumentState state() { return hasher_(history_.document()); }

 private:
  document::History history_;
  document::ApplyWorkspace work_;
  document::DocumentHasher hasher_;
  document::View view_;
  Tool tool_;
};

/// The view that a document opens with: its whole rest surface from the front, on a picture of 1000 x 1000 px.
[[nodiscard]] document::View opening_view(const document::Document& document);

}  // namespace penpose::drawing
