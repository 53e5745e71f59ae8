#include "core/picture/decode_picture.h"

#include <algorithm>
#include <array>
#include <png.h>
#include <string>
#include <webp/decode.h>

#include "core/picture/internal/limits.h"
#include "core/picture/jpeg.h"

namespace penpose::picture {
namespace {

constexpr std::uint64_t k_most_px = std::uint64_t{1} << 26;
constexpr std::uint64_t k_most_interlaced_px = std::uint64_t{1} << 24;

base::Error wrong(std::string what) { return {std::move(what), "", "export the picture again"}; }

bool too_large(std::uint64_t width, std::uint64_t height, std::size_t bytes) {
  const std::uint64_t px = width * height;
  return px > k_most_px || px > k_always_px + k_px_of_byte * bytes;
}

constexpr const char* k_too_large =
    "the picture has more than 8192 x 8192 px, or unfolds to far more pixels than the file has bytes";

/// Gathers rows of a picture into one that is `by` times smaller, each px the mean of those that it stands for.
class Shrinking {
 public:
  Shrinking(std::uint32_t width, std::uint32_t height, std::uint32_t by)
      : width_(width),
        height_(height),
        by_(by),
        small_{static_cast<int>((width + by - 1) / by), static_cast<int>((height + by - 1) / by), {}},
        sums_(by == 1 ? 0 : static_cast<std::size_t>(small_.width) * 4, 0) {
    small_.pixels.resize(static_cast<std::size_t>(small_.width) * static_cast<std::size_t>(small_.height) * 4);
  }

  /// Where row y may be unpacked to, where it stays as it is.
  [[nodiscard]] std::uint8_t* row(std::uint32_t y) { return small_.pixels.data() + std::size_t{y} * width_ * 4; }

  void add(std::uint32_t y, const std::uint8_t* row) {
    // Pointers: a look at every index would take most of the time of unpacking.
    std::uint32_t* sum = sums_.data();
    for (std::uint32_t x = 0; x < width_; sum += 4) {
      for (const std::uint32_t end = std::min(width_, x + by_); x < end; ++x, row += 4) {
        for (int c = 0; c < 4; ++c) sum[c] += row[c];
      }
    }
    if (y % by_ + 1 < by_ && y + 1 < height_) return;
    const std::uint32_t rows = y % by_ + 1;
    std::uint8_t* out = small_.pixels.data() + std::size_t{y / by_} * static_cast<std::size_t>(small_.width) * 4;
    for (std::uint32_t x = 0; x < static_cast<std::uint32_t>(small_.width); ++x) {
      const std::uint32_t count = rows * std::min(by_, width_ - x * by_);
      for (std::size_t c = 0; c < 4; ++c)
        out[std::size_t{x} * 4 + c] = static_cast<std::uint8_t>((sums_[std::size_t{x} * 4 + c] + count / 2) / count);
    }
    std::fill(sums_.begin(), sums_.end(), 0U);
  }

  Image take() { return std::move(small_); }

 private:
  std::uint32_t width_;
  std::uint32_t height_;
  std::uint32_t by_;
  Image small_;
  std::vector<std::uint32_t> sums_;
};

struct PngBytes {
  std::span<const std::uint8_t> bytes;
  std::size_t at = 0;
};

void take_bytes(png_structp png, png_bytep out, png_size_t size) {
  auto& from = *static_cast<PngBytes*>(png_get_io_ptr(png));
  if (size > from.bytes.size() - from.at) png_error(png, "the picture is cut off");
  std::copy_n(from.bytes.data() + from.at, size, out);
  from.at += size;
}

void keep_texture_quiet(png_structp, png_const_charp) {}
[[noreturn]] void give_up(png_structp png, png_const_charp why) {
  auto& text = *static_cast<std::array<char, 100>*>(png_get_error_ptr(png));
  for (std::size_t i = 0; i + 1 < text.size() && why[i] != 0; ++i) text[i] = why[i];
  png_longjmp(png, 1);
}

struct PngHead {
  png_uint_32 width = 0;
  png_uint_32 height = 0;
  int passes = 1;
};

/// Everything between setjmp and a jump out of libpng; holds no object with a destructor.
bool read_head(png_structp png, png_infop info, PngHead& head) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_read_info(png, info);
  head.width = png_get_image_width(png, info);
  head.height = png_get_image_height(png, info);
  png_set_expand(png);
  png_set_scale_16(png);
  png_set_gray_to_rgb(png);
  png_set_add_alpha(png, 0xff, PNG_FILLER_AFTER);
  head.passes = png_set_interlace_handling(png);
  png_read_update_info(png, info);
  return png_get_rowbytes(png, info) == png_size_t{head.width} * 4;
}

bool read_rows(png_structp png, const PngHead& head, Shrinking& picture, std::uint8_t* row) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  for (png_uint_32 y = 0; y < head.height; ++y) {
    if (row == nullptr) {
      png_read_row(png, picture.row(y), nullptr);
    } else {
      png_read_row(png, row, nullptr);
      picture.add(y, row);
    }
  }
  return true;
}

bool read_passes(png_structp png, const PngHead& head, std::uint8_t* pixels) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  for (int pass = 0; pass < head.passes; ++pass) {
    for (png_uint_32 y = 0; y < head.height; ++y) png_read_row(png, pixels + std::size_t{y} * head.width * 4, nullptr);
  }
  return true;
}

base::Result<Image> decode_rows(png_structp png, png_infop info, std::size_t size, std::uint32_t most_px,
                                const std::array<char, 100>& why) {
  const auto damaged = [&] { return wrong(std::string("is no PNG picture, or damaged: ") + why.data()); };
  PngHead head;
  if (!read_head(png, info, head)) return damaged();
  if (too_large(head.width, head.height, size)) return wrong(k_too_large);
  const std::uint32_t by = (std::max(head.width, head.height) + most_px - 1) / most_px;
  if (head.passes > 1) {
    if (std::uint64_t{head.width} * head.height > k_most_interlaced_px) return wrong(k_too_large);
    Image whole{static_cast<int>(head.width), static_cast<int>(head.height), {}};
    whole.pixels.resize(std::size_t{head.width} * head.height * 4);
    if (!read_passes(png, head, whole.pixels.data())) return damaged();
    return by == 1 ? std::move(whole) : shrunk(whole, static_cast<int>(most_px));
  }
  Shrinking picture(head.width, head.height, by);
  std::vector<std::uint8_t> row(by == 1 ? 0 : std::size_t{head.width} * 4);
  if (!read_rows(png, head, picture, by == 1 ? nullptr : row.data())) return damaged();
  return picture.take();
}

base::Result<Image> decode_png_rows(std::span<const std::uint8_t> bytes, std::uint32_t most_px) {
  std::array<char, 100> why{};
  PngBytes from{bytes};
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &why, &give_up, &keep_texture_quiet);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  if (info == nullptr) {
    png_destroy_read_struct(&png, nullptr, nullptr);
    return wrong("there is not enough memory for the picture");
  }
  png_set_read_fn(png, &from, &take_bytes);
  png_set_user_limits(png, 65535, 65535);
  png_set_chunk_malloc_max(png, 1 << 20);
  // A wrong check sum is no reason to show nothing: other programs show such pictures too.
  png_set_crc_action(png, PNG_CRC_QUIET_USE, PNG_CRC_QUIET_USE);
  png_set_option(png, PNG_IGNORE_ADLER32, PNG_OPTION_ON);
  png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, 0);
  auto image = decode_rows(png, info, bytes.size(), most_px, why);
  png_destroy_read_struct(&png, &info, nullptr);
  return image;
}

base::Result<Image> decode_webp(std::span<const std::uint8_t> bytes, std::uint32_t most_px) {
  WebPDecoderConfig config;
  if (WebPInitDecoderConfig(&config) == 0) return wrong("libwebp is another version than it was built for");
  if (WebPGetFeatures(bytes.data(), bytes.size(), &config.input) != VP8_STATUS_OK)
    return wrong("is no WebP picture, or damaged");
  if (config.input.has_animation != 0) return wrong("is an animation, not a picture");
  const auto width = static_cast<std::uint32_t>(config.input.width);
  const auto height = static_cast<std::uint32_t>(config.input.height);
  if (too_large(width, height, bytes.size())) return wrong(k_too_large);
  const std::uint32_t by = (std::max(width, height) + most_px - 1) / most_px;
  Image image{static_cast<int>((width + by - 1) / by), static_cast<int>((height + by - 1) / by), {}};
  image.pixels.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
  if (by > 1) {
    config.options.use_scaling = 1;
    config.options.scaled_width = image.width;
    config.options.scaled_height = image.height;
  }
  config.output.colorspace = MODE_RGBA;
  config.output.is_external_memory = 1;
  config.output.u.RGBA.rgba = image.pixels.data();
  config.output.u.RGBA.stride = image.width * 4;
  config.output.u.RGBA.size = image.pixels.size();
  const VP8StatusCode status = WebPDecode(bytes.data(), bytes.size(), &config);
  WebPFreeDecBuffer(&config.output);
  if (status != VP8_STATUS_OK) return wrong("is a damaged WebP picture");
  return image;
}

bool starts_with(std::span<const std::uint8_t> bytes, std::size_t at, std::string_view text) {
  return bytes.size() >= at + text.size() &&
         std::equal(text.begin(), text.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at),
                    [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

}  // namespace

base::Result<Image> decode_picture(std::span<const std::uint8_t> bytes, int most_px) {
  const auto most = static_cast<std::uint32_t>(std::max(1, most_px));
  if (starts_with(bytes, 0, "\x89PNG")) return decode_png_rows(bytes, most);
  if (starts_with(bytes, 0, "RIFF") && starts_with(bytes, 8, "WEBP")) return decode_webp(bytes, most);
  if (starts_with(bytes, 0, "\xff\xd8")) {
    auto image = decode_jpeg(bytes, static_cast<int>(most));
    if (!image) return image;
    return std::max(image->width, image->height) > static_cast<int>(most) ? shrunk(*image, static_cast<int>(most))
                                                                          : std::move(image);
  }
  return wrong("is no PNG, JPEG or WebP picture");
}

}  // namespace penpose::picture
