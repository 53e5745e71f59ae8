#pragma once

#include <deque>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "ui/app/files/dropped_file.h"
#include "ui/app/files/leaving.h"
#include "ui/app/files/program_run.h"
#include "ui/app/reference/reference_desk.h"
#include "ui/app/sound/sound_track.h"

namespace penpose::app {

/// Files that were dropped on the window. Nothing is done before a card has said what each is and was answered.
class DropDesk {
 public:
  struct With {
    EditingSession& editing;
    Notices& notices;
    Dialogs& dialogs;
    Leaving& leaving;
    Files& files;
    SoundTrack& sound;
    ReferenceDesk& references;
    Playback& playback;
    std::string program;  ///< whose `draw` and `animate` read drawings and takes
  };
  explicit DropDesk(With with) : with_(std::move(with)) {}

  /// Another program than this one reads drawings and takes.
  void use_program(std::string program) { with_.program = std::move(program); }

  /// One of the files of a drop.
  void drop(const std::string& path);

  /// The file that waits for an answer; empty: none.
  [[nodiscard]] std::string path() const { return waiting_.empty() ? std::string() : waiting_.front(); }
  [[nodiscard]] DroppedKind kind() const { return kind_; }
  /// How many more wait behind it.
  [[nodiscard]] std::size_t more() const { return waiting_.empty() ? 0 : waiting_.size() - 1; }
  /// Does it, and goes on to the next file.
  void answer(DropDeed deed);
  /// Nothing is done with it, nor with those behind it.
  void cancel();

  /// A drawing or a take is being read; empty: none.
  [[nodiscard]] const std::string& reads() const { return reads_; }
  void follow();

 private:
  void next();
  void read(const std::string& path, DropDeed deed);
  void take_drawing(const std::string& said);
  void take_keys();

  With with_;
  std::deque<std::string> waiting_;
  DroppedKind kind_ = DroppedKind::unknown;
  std::unique_ptr<ProgramRun> run_;
  std::string reads_;
  DropDeed reads_as_ = DropDeed::read_drawing;
  std::shared_ptr<const document::Model> of_model_;  ///< that it is read for
};

}  // namespace penpose::app
