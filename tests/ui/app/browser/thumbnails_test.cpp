#include "ui/app/browser/thumbnails.h"

#include <chrono>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <thread>
#include <unistd.h>

#include "ui/files/load_model.h"
#include "ui/files/save_model.h"
#include "ui/render/picture/image.h"

namespace penpose::app {
namespace {

namespace fs = std::filesystem;

constexpr auto k_side = static_cast<std::size_t>(Thumbnails::k_px);

struct Folder {
  fs::path path = fs::temp_directory_path() / ("penpose-thumbnails-" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
};

std::uint8_t alpha_at(const Thumbnails::Pixels& pixels, std::size_t x, std::size_t y) {
  return pixels[4 * (y * k_side + x) + 3];
}

TEST(Thumbnails, APictureIsSeenWholeInTheMiddle) {
  const Folder folder;
  render::Image image{200, 100, std::vector<std::uint8_t>(4 * 200 * 100, 255)};
  const auto bytes = render::encode_png(image);
  ASSERT_TRUE(bytes.ok());
  const std::string path = (folder.path / "wide.png").string();
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
  const auto pixels = thumbnail_of(path);
  ASSERT_EQ(pixels.size(), 4 * k_side * k_side);
  EXPECT_EQ(alpha_at(pixels, k_side / 2, k_side / 2), 255);
  EXPECT_EQ(alpha_at(pixels, k_side / 2, 4), 0) << "it is twice as wide as high";
}

TEST(Thumbnails, AModelIsDrawnBesideAndNobodyWaits) {
  const Folder folder;
  const std::string path = (folder.path / "head.glb").string();
  const auto model = files::load_model("builtin:head");
  ASSERT_TRUE(model.ok() && files::save_model(*model, path, files::SaveNotes::quiet).ok());
  Thumbnails thumbnails;
  EXPECT_EQ(thumbnails.of(path, 1), nullptr) << "not yet";
  EXPECT_TRUE(thumbnails.waits());
  const Thumbnails::Pixels* pixels = nullptr;
  for (int i = 0; i < 3000 && pixels == nullptr; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    pixels = thumbnails.of(path, 1);
  }
  ASSERT_NE(pixels, nullptr);
  ASSERT_EQ(pixels->size(), 4 * k_side * k_side);
  EXPECT_EQ(alpha_at(*pixels, k_side / 2, k_side / 2), 255);
  EXPECT_EQ(alpha_at(*pixels, 0, 0), 0);
  EXPECT_FALSE(thumbnails.waits());
  EXPECT_EQ(thumbnails.of(path, 2), nullptr) << "it was changed since";
}

TEST(Thumbnails, WhatIsNoneHasNone) {
  const Folder folder;
  const std::string path = (folder.path / "broken.glb").string();
  std::ofstream(path) << "glTF no more";
  EXPECT_TRUE(thumbnail_of(path).empty());
  EXPECT_TRUE(thumbnail_of((folder.path / "none.png").string()).empty());
  EXPECT_TRUE(Thumbnails::may_have("A.PNG"));
  EXPECT_TRUE(Thumbnails::may_have("a.obj"));
  EXPECT_FALSE(Thumbnails::may_have("a.session"));
}

}  // namespace
}  // namespace penpose::app
