#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/poses/face_measure.h"
#include "core/poses/take_pose.h"
#include "ui/app/files/files.h"
#include "ui/app/notices.h"
#include "ui/app/preferences.h"
#include "ui/app/session/editing_session.h"
#include "ui/app/session/pose_library.h"
#include "ui/files/poses/pose_folder.h"

namespace penpose::app {

/// What is to be taken of a pose of the library.
struct ShelfChoice {
  FacePart part = FacePart::all;
  bool mirrored = false;
  double amount = 1;
  friend bool operator==(const ShelfChoice&, const ShelfChoice&) = default;
};

/// The poses of the user's folder, kept outside of any project, and how they are taken to the document's rig.
class PoseShelf {
 public:
  /// `usual`: the folder where none was chosen; empty: poses are kept nowhere.
  PoseShelf(std::string usual, EditingSession& editing, Preferences& preferences, Notices& notices, const Files& files)
      : usual_(std::move(usual)), editing_(editing), preferences_(preferences), notices_(notices), files_(files) {}

  [[nodiscard]] const std::string& folder() const;
  [[nodiscard]] const std::string& usual_folder() const { return usual_; }
  /// From now on that folder; empty: the usual one.
  void choose_folder(const std::string& folder);

  /// Looks whether something in the folder is new. Call it once a frame while poses are shown.
  void follow();
  [[nodiscard]] std::span<const files::PoseFile> poses() const { return poses_; }
  /// Grows with every reading of the folder.
  [[nodiscard]] std::uint64_t readings() const { return readings_; }
  /// Those whose name has a text in it and that do something to a part, by number; files that are no poses where all
  /// parts are asked for.
  [[nodiscard]] std::vector<std::size_t> listed(const std::string& search, FacePart part) const;
  /// The file of a path; null: it is there no more.
  [[nodiscard]] const files::PoseFile* find(const std::string& path) const;

  /// Keeps a pose of the document, with the lines that are shown where it is the present one. Gives its path; empty:
  /// that did not work, which was told.
  std::string keep(const rig::Pose& pose, const std::string& name);
  /// Gives its new path; empty: likewise.
  std::string rename(const std::string& path, const std::string& name);
  void bin(const std::string& path);
  /// The name of the pose that was last put into the trash; empty: none since the start.
  [[nodiscard]] const std::string& binned() const { return binned_name_; }
  void take_back();

  /// Brings the document to the pose, in one step of undo, and says how. Taken again at once with another amount, it
  /// starts from where the face was before.
  void take(const std::string& path, const ShelfChoice& choice);
  /// Shows that without doing it.
  void preview(const std::string& path, const ShelfChoice& choice);
  /// The amount at which the document has a pose right now, taken so but for the amount; none: something else was done
  /// since, or another was taken.
  [[nodiscard]] std::optional<double> amount_of(const std::string& path, ShelfChoice choice) const;

 private:
  /// A pose as it is for the document's rig, worked out once.
  struct Ready {
    std::string path;
    std::uint64_t reading = 0;
    FacePart part = FacePart::all;
    std::shared_ptr<const rig::CharacterRig> rig;
    base::Result<poses::TakenPose> taken;
  };
  struct Last {
    std::string path;
    ShelfChoice choice;
    std::uint64_t revision = 0;
    rig::Pose before;
  };

  [[nodiscard]] const poses::FaceMeasure* face();
  [[nodiscard]] const Ready* ready(const std::string& path, FacePart part);
  [[nodiscard]] document::SetParameters values_of(const poses::TakenPose& taken, const ShelfChoice& choice,
                                                  const rig::Pose& from) const;
  [[nodiscard]] bool goes_on(const std::string& path, ShelfChoice choice) const;
  void read();
  bool refused(const base::Error& error, const std::string& file);

  std::string usual_;
  EditingSession& editing_;
  Preferences& preferences_;
  Notices& notices_;
  const Files& files_;
  std::vector<files::PoseFile> poses_;
  std::string read_folder_;
  std::optional<std::filesystem::file_time_type> read_time_;
  std::uint64_t readings_ = 0;
  std::shared_ptr<const rig::CharacterRig> measured_;
  std::size_t measured_features_ = 0;
  std::optional<poses::FaceMeasure> face_;
  std::optional<Ready> ready_;
  std::optional<Last> last_;
  std::pair<std::string, std::string> binned_;  ///< where it is, and where it was
  std::string binned_name_;
};

}  // namespace penpose::app
