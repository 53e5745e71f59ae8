#pragma once

#include <memory>
#include <optional>
#include <string>

#include "ui/app/canvas/canvas.h"
#include "ui/app/files/files.h"
#include "ui/app/notices.h"
#include "ui/app/playback/playback.h"
#include "ui/app/reference/reference_file.h"
#include "ui/app/session/editing_session.h"

namespace penpose::app {

/// The picture or film that one animates after: opened, placed, kept by the document, and shown along the timeline.
class ReferenceDesk {
 public:
  struct With {
    EditingSession& editing;
    const Canvas& canvas;
    CanvasLook& look;
    Playback& playback;
    Notices& notices;
    const Files& files;
    std::string cache;  ///< of films' pictures
  };
  explicit ReferenceDesk(With with) : with_(std::move(with)) {}

  /// Puts a picture, the numbered pictures of a film, or a film behind the model, or beside it as a card; what is wrong
  /// with it is told. A film is read beside; `beside` is kept for it. True: it is there, or being read.
  bool open(const std::string& path, bool beside = false);
  void remove();
  /// What was changed in hand is a step of the document.
  void commit();

  /// A film is being read; null: none.
  [[nodiscard]] const FilmReader* reads() const { return reader_.get(); }
  void cancel();
  /// What is wrong with the document's file: it is gone, or another one than the document was made with. Empty:
  /// nothing.
  [[nodiscard]] const std::string& doubt() const { return doubt_; }
  /// The file is there, and another one.
  [[nodiscard]] bool differs() const { return other_.has_value(); }
  /// The document goes on with the file as it is now.
  void accept();

  /// Brings what is shown up to the document and the moment.
  void follow();

 private:
  void take_document();
  void use(const std::string& path, base::Result<ReferenceFile> file);
  void place_new(const std::string& path, const ReferenceFile& file);
  [[nodiscard]] document::ReferencePicture beginning() const;
  [[nodiscard]] std::string project() const;

  With with_;
  std::shared_ptr<const document::ReferencePicture> known_;  ///< that look.backdrop is of
  std::unique_ptr<FilmReader> reader_;
  bool opens_ = false;   ///< what is read was opened by the user, and is not the document's own
  bool beside_ = false;  ///< where it will stand
  std::string doubt_;
  std::optional<ReferenceFile> other_;
};

}  // namespace penpose::app
