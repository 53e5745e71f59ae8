#include "ui/film/write_film.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/numbers.h"
#include "ui/files/files.h"
#include "ui/film/contact_sheet.h"
#include "ui/film/film_output.h"
#include "ui/film/frame_name.h"
#include "ui/film/frame_number.h"

namespace penpose::film {
namespace {

/// Where programs have files that are passed to them.
constexpr const char* k_first_file = "/proc/self/fd/3";
constexpr const char* k_second_file = "/proc/self/fd/4";
/// The colours of a GIF are chosen by so many of its pictures.
constexpr std::size_t k_palette_pictures = 48;

using Words = std::vector<std::string>;

void add(Words& words, const Words& more) { words.insert(words.end(), more.begin(), more.end()); }

/// Draws one picture after the other and counts them.
class Pictures {
 public:
  Pictures(const FilmPlan& plan, const DrawFrame& draw, const Waiting& waiting, std::size_t all)
      : plan_(plan), draw_(draw), waiting_(waiting), all_(all) {}

  [[nodiscard]] base::Result<render::Image> of(int frame) {
    if (waiting_.stop && waiting_.stop()) return given_up();
    auto image = draw_(frame);
    if (!image) return image;
    if (plan_.numbers && plan_.kind != FilmKind::sheet) draw_frame_number(*image, frame);
    if (waiting_.progress) waiting_.progress(++done_, all_);
    return image;
  }
  /// Draws frames into ffmpeg.
  [[nodiscard]] base::Status into(Ffmpeg& ffmpeg, const std::vector<int>& frames) {
    for (const int frame : frames) {
      const auto image = of(frame);
      if (!image) return image.error();
      if (auto written = ffmpeg.write(image->pixels, waiting_.stop); !written) return written;
    }
    return ffmpeg.finish(waiting_.stop);
  }

 private:
  const FilmPlan& plan_;
  const DrawFrame& draw_;
  const Waiting& waiting_;
  std::size_t all_;
  std::size_t done_ = 0;
};

/// What comes through ffmpeg's standard input.
Words raw_input(const FilmPlan& plan, double rate) {
  const std::string size = std::to_string(plan.size.width) + "x" + std::to_string(plan.size.height);
  return {"-f", "rawvideo",   "-pixel_format",           "rgba", "-video_size",
          size, "-framerate", base::format_double(rate), "-i",   "pipe:0"};
}

/// Colours as high-definition films have them, and sizes that their codecs take.
const Words k_video{"-vf",
                    "crop=trunc(iw/2)*2:trunc(ih/2)*2:0:0,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
                    "-colorspace",
                    "bt709",
                    "-color_primaries",
                    "bt709",
                    "-color_trc",
                    "bt709",
                    "-color_range",
                    "tv"};

Words codec_of(FilmKind kind, bool sounds) {
  Words words;
  if (kind == FilmKind::mp4) {
    words = {"-c:v", "libx264", "-crf", "18", "-preset", "medium", "-movflags", "+faststart", "-f", "mp4"};
    if (sounds) add(words, {"-c:a", "aac", "-b:a", "192k", "-ar", "48000"});
  } else {
    words = {"-c:v", "libvpx-vp9", "-crf", "24",      "-b:v", "0",  "-deadline",
             "good", "-cpu-used",  "4",    "-row-mt", "1",    "-f", "webm"};
    // Opus would begin 7 ms before the pictures.
    if (sounds) add(words, {"-c:a", "libvorbis", "-q:a", "6", "-ar", "48000"});
  }
  return words;
}

base::Status write_video(const FilmPlan& plan, const DrawFrame& draw, const PlacedSound* sound,
                         const Waiting& waiting) {
  auto output = FilmOutput::begin(plan.output);
  if (!output) return output.error();
  const MemoryFile heard;
  Words words = raw_input(plan, plan.rate);
  std::vector<int> files{output->descriptor()};
  if (sound != nullptr) {
    const auto part =
        sound_of_frames(sound->sound, sound->offset_s, plan.frames.front(), plan.frames.size(), plan.rate);
    if (!part) return part.error();
    if (auto filled = heard.fill(wav_bytes(*part)); !filled) return filled;
    add(words, {"-f", "wav", "-i", k_second_file, "-map", "0:v", "-map", "1:a"});
    files.push_back(heard.descriptor());
  }
  add(words, k_video);
  add(words, codec_of(plan.kind, sound != nullptr));
  words.emplace_back(k_first_file);
  auto ffmpeg = Ffmpeg::start(words, files);
  if (!ffmpeg) return ffmpeg.error();
  Pictures pictures(plan, draw, waiting, plan.frames.size());
  if (auto drawn = pictures.into(*ffmpeg, plan.frames); !drawn) return drawn;
  return output->place();
}

std::vector<int> every(const std::vector<int>& frames, std::size_t step) {
  std::vector<int> some;
  for (std::size_t i = 0; i < frames.size(); i += step) some.push_back(frames[i]);
  return some;
}

/// First the 256 colours that fit the pictures best, then the pictures in them.
base::Status write_gif(const FilmPlan& plan, const DrawFrame& draw, const Waiting& waiting) {
  auto output = FilmOutput::begin(plan.output);
  if (!output) return output.error();
  const auto step = static_cast<std::size_t>(std::max(1.0, std::ceil(plan.rate / k_most_gif_rate - 1e-9)));
  const double rate = plan.rate / static_cast<double>(step);
  const std::vector<int> shown = every(plan.frames, step);
  const std::vector<int> tried = every(shown, (shown.size() + k_palette_pictures - 1) / k_palette_pictures);
  Pictures pictures(plan, draw, waiting, tried.size() + shown.size());
  const MemoryFile palette;
  Words words = raw_input(plan, rate);
  add(words, {"-vf", "palettegen", "-c:v", "png", "-f", "image2pipe", k_first_file});
  auto chooses = Ffmpeg::start(words, {palette.descriptor()});
  if (!chooses) return chooses.error();
  if (auto chosen = pictures.into(*chooses, tried); !chosen) return chosen;
  words = raw_input(plan, rate);
  add(words,
      {"-f", "png_pipe", "-i", k_second_file, "-lavfi",
       "[0:v][1:v]paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle", "-loop", "0", "-f", "gif", k_first_file});
  auto writes = Ffmpeg::start(words, {output->descriptor(), palette.descriptor()});
  if (!writes) return writes.error();
  if (auto drawn = pictures.into(*writes, shown); !drawn) return drawn;
  return output->place();
}

base::Status write_pictures(const FilmPlan& plan, const DrawFrame& draw, const Waiting& waiting) {
  auto folder = PictureFolder::begin(plan.output);
  if (!folder) return folder.error();
  Pictures pictures(plan, draw, waiting, plan.frames.size());
  for (const int frame : plan.frames) {
    const auto image = pictures.of(frame);
    if (!image) return image.error();
    const auto png = render::encode_png(*image);
    if (!png) return png.error();
    const std::string path = frame_name(plan.output, static_cast<std::size_t>(frame));
    if (auto written = folder->write(path, *png); !written) return written;
  }
  return folder->place();
}

base::Status write_sheet(const FilmPlan& plan, const DrawFrame& draw, const Waiting& waiting) {
  auto sheet = ContactSheet::make(plan.frames.size(), plan.size);
  if (!sheet) return sheet.error();
  Pictures pictures(plan, draw, waiting, plan.frames.size());
  for (std::size_t i = 0; i < plan.frames.size(); ++i) {
    const auto image = pictures.of(plan.frames[i]);
    if (!image) return image.error();
    sheet->put(i, *image, plan.frames[i]);
  }
  const auto png = render::encode_png(sheet->image());
  if (!png) return png.error();
  return files::write_file(plan.output, *png);
}

}  // namespace

base::Status write_film(const FilmPlan& plan, const DrawFrame& draw, const PlacedSound* sound, const Waiting& waiting) {
  if (plan.frames.empty()) return base::Error{"there is nothing to film", "", "name other frames"};
  const FilmKindRow& row = row_of(plan.kind);
  if (row.needs_ffmpeg && !has_ffmpeg()) return no_ffmpeg();
  switch (plan.kind) {
    case FilmKind::gif:
      return write_gif(plan, draw, waiting);
    case FilmKind::pictures:
      return write_pictures(plan, draw, waiting);
    case FilmKind::sheet:
      return write_sheet(plan, draw, waiting);
    default:
      return write_video(plan, draw, row.sounds ? sound : nullptr, waiting);
  }
}

}  // namespace penpose::film
