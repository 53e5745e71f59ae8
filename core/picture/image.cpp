#include "core/picture/image.h"

#include <png.h>

#include "core/picture/internal/limits.h"

namespace penpose::picture {
namespace {

void append(png_structp png, png_bytep data, png_size_t size) {
  auto& bytes = *static_cast<std::vector<std::uint8_t>*>(png_get_io_ptr(png));
  // An exception must not travel through libpng's C frames.
  try {
    bytes.insert(bytes.end(), data, data + size);
  } catch (...) {
    png_error(png, "out of memory");
  }
}

void keep_quiet(png_structp, png_const_charp) {}

/// Everything between setjmp and a jump out of libpng; holds no object with a destructor.
bool write(png_structp png, png_infop info, const Image& image) {
  if (setjmp(png_jmpbuf(png)) != 0) return false;
  png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
               PNG_COLOR_TYPE_RGBA, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
  png_set_compression_level(png, 6);
  png_write_info(png, info);
  for (int y = 0; y < image.height; ++y) png_write_row(png, image.at(0, y));
  png_write_end(png, nullptr);
  return true;
}

}  // namespace

base::Result<std::vector<std::uint8_t>> encode_png(const Image& image) {
  const auto wanted = static_cast<std::uint64_t>(image.width) * static_cast<std::uint64_t>(image.height) * 4;
  if (image.width < 1 || image.height < 1 || image.pixels.size() != wanted) {
    return base::Error{"the picture's size does not fit its pixels", "", "give width * height * 4 bytes"};
  }
  std::vector<std::uint8_t> bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, &keep_quiet);
  png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
  bool good = info != nullptr;
  if (good) {
    png_set_write_fn(png, &bytes, &append, nullptr);
    good = write(png, info, image);
  }
  png_destroy_write_struct(&png, &info);
  if (!good) return base::Error{"the picture could not be encoded", "", "try a smaller picture"};
  return bytes;
}

base::Result<Image> decode_png(std::span<const std::uint8_t> bytes) {
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  const auto fail = [&](const char* what) { return base::Error{what, png.message, "export the picture again"}; };
  if (png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()) == 0) return fail("is no PNG picture");
  constexpr std::uint32_t k_largest = 16384;
  if (png.width > k_largest || png.height > k_largest) {
    png_image_free(&png);
    return fail("the picture is larger than 16384 px");
  }
  // A few bytes may say that they are a huge picture.
  constexpr std::uint64_t k_px_of_png_byte = 8;
  if (std::uint64_t{png.width} * png.height > k_always_px + k_px_of_png_byte * bytes.size()) {
    png_image_free(&png);
    return fail("the picture unfolds to far more pixels than the file has bytes");
  }
  png.format = PNG_FORMAT_RGBA;
  Image image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  image.pixels.resize(PNG_IMAGE_SIZE(png));
  if (png_image_finish_read(&png, nullptr, image.pixels.data(), 0, nullptr) == 0) return fail("the picture is damaged");
  return image;
}

}  // namespace penpose::picture
