#include "core/picture/jpeg.h"

// jpeglib.h names FILE and size_t and includes neither.
#include <cstddef>
#include <cstdio>
//
#include <algorithm>
#include <array>
#include <csetjmp>
#include <jpeglib.h>

#include "core/picture/internal/limits.h"

namespace penpose::picture {
namespace {

constexpr unsigned k_largest = 16384;
/// Progressive pictures of a few bytes can ask for scan after scan.
constexpr int k_most_scans = 200;

struct Failure {
  jpeg_error_mgr manager;
  std::jmp_buf back;
  std::array<char, JMSG_LENGTH_MAX> why;
};

[[noreturn]] void fail(j_common_ptr info) {
  auto& failure = *reinterpret_cast<Failure*>(info->err);
  info->err->format_message(info, failure.why.data());
  std::longjmp(failure.back, 1);
}

void trace_nothing(j_common_ptr, int) {}
void say_nothing(j_common_ptr) {}

void count_scans(j_common_ptr info) {
  auto* const reader = reinterpret_cast<jpeg_decompress_struct*>(info);
  if (reader->input_scan_number > k_most_scans) {
    auto& failure = *reinterpret_cast<Failure*>(info->err);
    constexpr std::array k_many{"too many scans"};
    std::copy_n(k_many[0], 15, failure.why.begin());
    std::longjmp(failure.back, 1);
  }
}

/// What one step found out; everything between setjmp and a jump out of libjpeg holds no object with a destructor.
enum class Outcome : std::uint8_t { read, bad, too_large };

Outcome begin(jpeg_decompress_struct& reader, Failure& failure, std::span<const std::uint8_t> bytes, int most_px) {
  if (setjmp(failure.back) != 0) return Outcome::bad;
  jpeg_mem_src(&reader, bytes.data(), bytes.size());
  jpeg_read_header(&reader, TRUE);
  if (reader.image_width > k_largest || reader.image_height > k_largest) return Outcome::too_large;
  if (std::uint64_t{reader.image_width} * reader.image_height > k_always_px + k_px_of_byte * bytes.size())
    return Outcome::too_large;
  const unsigned side = std::max(reader.image_width, reader.image_height);
  reader.scale_num = 1;
  reader.scale_denom = 1;
  while (reader.scale_denom < 8 && side / reader.scale_denom > static_cast<unsigned>(std::max(1, most_px)))
    reader.scale_denom *= 2;
  reader.out_color_space = JCS_EXT_RGBA;
  jpeg_start_decompress(&reader);
  return Outcome::read;
}

Outcome read_rows(jpeg_decompress_struct& reader, Failure& failure, std::uint8_t* pixels) {
  if (setjmp(failure.back) != 0) return Outcome::bad;
  while (reader.output_scanline < reader.output_height) {
    JSAMPROW row = pixels + std::size_t{reader.output_scanline} * reader.output_width * 4;
    jpeg_read_scanlines(&reader, &row, 1);
  }
  return Outcome::read;
}

}  // namespace

base::Result<Image> decode_jpeg(std::span<const std::uint8_t> bytes, int most_px) {
  Failure failure{};
  jpeg_decompress_struct reader{};
  reader.err = jpeg_std_error(&failure.manager);
  failure.manager.error_exit = &fail;
  failure.manager.emit_message = &trace_nothing;
  failure.manager.output_message = &say_nothing;
  if (setjmp(failure.back) != 0) return base::Error{"there is not enough memory for the picture", "", ""};
  jpeg_create_decompress(&reader);
  jpeg_progress_mgr progress{};
  progress.progress_monitor = &count_scans;
  reader.progress = &progress;
  const Outcome begun = begin(reader, failure, bytes, most_px);
  Image image;
  Outcome outcome = begun;
  if (begun == Outcome::read) {
    image.width = static_cast<int>(reader.output_width);
    image.height = static_cast<int>(reader.output_height);
    image.pixels.assign(std::size_t{reader.output_width} * reader.output_height * 4, 128);
    outcome = read_rows(reader, failure, image.pixels.data());
  }
  jpeg_destroy_decompress(&reader);
  if (outcome == Outcome::too_large)
    return base::Error{"the picture is larger than 16384 px, or unfolds to far more pixels than the file has bytes", "",
                       "export it smaller"};
  if (outcome == Outcome::bad)
    return base::Error{"is no JPEG picture, or damaged: " + std::string(failure.why.data()), "", "export it again"};
  return image;
}

Image shrunk(const Image& image, int most_px) {
  const int by = (std::max(image.width, image.height) + most_px - 1) / std::max(1, most_px);
  if (by <= 1) return image;
  Image small{std::max(1, image.width / by), std::max(1, image.height / by), {}};
  small.pixels.resize(static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height) * 4);
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      std::array<unsigned, 4> sum{};
      unsigned count = 0;
      for (int v = y * by; v < std::min(image.height, (y + 1) * by); ++v) {
        for (int u = x * by; u < std::min(image.width, (x + 1) * by); ++u) {
          for (std::size_t c = 0; c < 4; ++c) sum[c] += image.at(u, v)[c];
          ++count;
        }
      }
      const std::size_t at =
          (static_cast<std::size_t>(y) * static_cast<std::size_t>(small.width) + static_cast<std::size_t>(x)) * 4;
      for (std::size_t c = 0; c < 4; ++c)
        small.pixels[at + c] = static_cast<std::uint8_t>((sum[c] + count / 2) / std::max(1U, count));
    }
  }
  return small;
}

}  // namespace penpose::picture
