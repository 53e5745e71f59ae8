#include <filesystem>
#include <iostream>

#include "core/animation/points/eigen_points.h"
#include "core/animation/points/face_layout.h"
#include "core/io/tracks/label_file.h"
#include "core/io/tracks/read_pgm.h"
#include "ui/cli/number_range.h"
#include "ui/cli/progress.h"
#include "ui/cli/subcommand.h"
#include "ui/files/file_roles.h"
#include "ui/files/files.h"
#include "ui/files/folder_files.h"
#include "ui/render/picture/image.h"

namespace penpose::cli {
namespace {

struct TrackArguments {
  std::vector<std::string> pictures;
  std::string labels;
  std::string out;
  double fps = 25;
};

base::Result<animation::GreyImage> read_grey(const base::Result<std::vector<std::uint8_t>>& bytes) {
  if (!bytes) return bytes.error();
  if (bytes->size() > 1 && (*bytes)[0] == 'P') return io::read_pgm(*bytes);
  const auto picture = render::decode_png(*bytes);
  if (!picture) return picture.error();
  animation::GreyImage grey{picture->width, picture->height, {}};
  grey.pixels.reserve(picture->pixels.size() / 4);
  for (std::size_t i = 0; i < picture->pixels.size(); i += 4) {
    // Luma of ITU-R BT.601, in whole numbers.
    const int sum = 299 * picture->pixels[i] + 587 * picture->pixels[i + 1] + 114 * picture->pixels[i + 2];
    grey.pixels.push_back(static_cast<std::uint8_t>(sum / 1000));
  }
  return grey;
}

/// Places found in pictures are places in those that were labelled: all have to be of one size.
base::Status check_size(const animation::GreyImage& image, const animation::GreyImage& first, const std::string& name) {
  if (image.width == first.width && image.height == first.height) return base::Done{};
  const auto size = [](const animation::GreyImage& of) {
    return std::to_string(of.width) + "x" + std::to_string(of.height);
  };
  return base::Error{"the picture is " + size(image) + " px, the first one that is labelled " + size(first), name,
                     "give pictures of one size"};
}

struct Learned {
  animation::EigenPoints points;
  animation::FaceLayout layout;
  animation::GreyImage first;  ///< of the labelled pictures
};

base::Result<Learned> learn(const io::LabelFile& file, const std::string& folder) {
  std::vector<animation::LabelledImage> labelled;
  // All of them are held at once, and small files may be large pictures.
  constexpr std::uint64_t k_always_px = 20'000'000;
  constexpr std::uint64_t k_px_of_byte = 32;
  std::uint64_t most_px = k_always_px;
  std::uint64_t held_px = 0;
  for (std::size_t k = 0; k < file.images.size(); ++k) {
    const auto bytes = files::read_beside(folder, file.images[k], files::k_most_picture_bytes);
    auto image = read_grey(bytes);
    if (image) {
      most_px += k_px_of_byte * bytes->size();
      held_px += image->pixels.size();
    }
    if (held_px > most_px) image = base::Error{"the pictures unfold to far more pixels than bytes", "", "label fewer"};
    if (!image) {
      base::Error error = image.error();
      const bool names_it = error.place.empty() || error.place == file.images[k];
      error.place = file.images[k] + (names_it ? "" : ": " + error.place);
      return error;
    }
    labelled.push_back({std::move(image).value(), file.track.frames[k].points, file.images[k]});
    if (auto fits = check_size(labelled.back().image, labelled.front().image, file.images[k]); !fits)
      return fits.error();
  }
  auto points = animation::learn_eigen_points(labelled, file.features);
  if (!points) return points.error();
  animation::FaceLayout layout = animation::learn_layout(labelled);
  return Learned{std::move(points).value(), std::move(layout), std::move(labelled.front().image)};
}

/// Files as they are named, a folder's pictures in the order of their names, numbers as numbers. An error is that of
/// the folder `blamed`.
base::Result<std::vector<std::string>> picture_files(const std::vector<std::string>& named, std::string& blamed) {
  std::vector<std::string> files;
  for (const std::string& path : named) {
    blamed = path;
    const auto inside = files::folder_files(path, [](const std::filesystem::path& file) {
      return file.extension() == ".png" || file.extension() == ".pgm";
    });
    if (!inside) return inside.error();
    if (*inside) {
      files.insert(files.end(), (*inside)->begin(), (*inside)->end());
    } else {
      files.push_back(path);
    }
  }
  return files;
}

int track(const TrackArguments& arguments) {
  files::FileRoles roles;
  roles.reads(arguments.labels);
  for (const std::string& picture : arguments.pictures) roles.reads(picture);
  if (const auto fits = roles.writes(arguments.out, "-o"); !fits) return files::report(fits.error(), arguments.out);
  std::string blamed;
  const auto named = picture_files(arguments.pictures, blamed);
  if (!named) return files::report(named.error(), blamed);
  const std::vector<std::string>& files = *named;
  if (files.empty())
    return files::report({"there is no .png or .pgm picture", "", "name pictures or a folder of them"});
  const auto bytes = files::read_file(arguments.labels, files::k_most_text_bytes);
  if (!bytes) return files::report(bytes.error(), arguments.labels);
  const auto labels = io::read_label_file(*bytes);
  if (!labels) return files::report(labels.error(), arguments.labels);
  for (const std::string& note : labels->track.notes) files::warn(note, arguments.labels);
  const auto learned = learn(*labels, std::filesystem::path(arguments.labels).parent_path().string());
  if (!learned) return files::report(learned.error(), arguments.labels);
  animation::PointTrack result;
  result.point_count = learned->points.point_count;
  result.groups = labels->track.groups;
  std::vector<geometry::PxPoint> shifts;
  std::size_t unseen = 0;
  std::vector<std::size_t> poor;
  constexpr double k_least_trust = 0.2;  // what animate holds by itself
  Progress progress("tracking", files.size());
  for (std::size_t f = 0; f < files.size(); ++f) {
    const auto image = read_grey(files::read_file(files[f], files::k_most_picture_bytes));
    if (!image) return files::report(image.error(), files[f]);
    if (auto fits = check_size(*image, learned->first, "frame " + std::to_string(f)); !fits)
      return files::report(fits.error(), files[f]);
    auto found = animation::find_face(learned->points, learned->layout, *image, shifts);
    if (!found) return files::report(found.error(), files[f]);
    shifts = std::move(found->shifts);
    if (!(found->confidence > 0)) {
      ++unseen;
    } else if (found->confidence < k_least_trust) {
      poor.push_back(f);
    }
    result.frames.push_back({static_cast<double>(f) / arguments.fps, found->confidence, std::move(found->points), {}});
    progress.advance();
  }
  progress.finish();
  const std::string text = io::write_curve_track(result, arguments.fps);
  if (auto written = files::write_file(arguments.out, base::as_bytes(text)); !written)
    return files::report(written.error(), arguments.out);
  std::cout << files.size() << " pictures, " << result.point_count << " points of " << result.groups.size()
            << " curves";
  if (unseen > 0) std::cout << ", " << unseen << " pictures that show none of them";
  std::cout << '\n';
  if (!poor.empty()) {
    constexpr std::size_t k_most_listed = 40;
    std::cout << poor.size() << " pictures in which what was found does not fit together, which animate holds:";
    for (std::size_t i = 0; i < std::min(poor.size(), k_most_listed); ++i) std::cout << ' ' << poor[i];
    std::cout << (poor.size() > k_most_listed ? " ...; " : "; ") << "label some of them\n";
  }
  return k_success;
}

void add_options(const Command& command, TrackArguments& arguments) {
  command.add_option("PICTURES", arguments.pictures, "PNG or PGM files, or folders of them, in order").required();
  command
      .add_option("--labels", arguments.labels,
                  R"(JSON file: {"frames": [{"image": FILE, "curves": {NAME: [[x, y], ...]}}, ...]})")
      .required();
  command.add_option("-o", arguments.out, "Track of curves to write, .json, for penpose animate").required();
  command.add_option("--fps", arguments.fps, "Frames a second of the sequence")
      .check(number_range(0.1, 10000.0), "0.1 to 10000")
      .show_default();
}

}  // namespace

Subcommand track_subcommand() {
  return subcommand<TrackArguments>(
      "track", files::Rights::no_programs, "Finds curves in a picture sequence, learned from labelled pictures",
      add_options, track, {"penpose track frames --labels labels.json -o lips.json", "curves in a folder of pictures"},
      {"penpose track frames --labels labels.json -o lips.json --fps 30", "of a faster camera"});
}

}  // namespace penpose::cli
