// Opening an avatar with six textures of 2048 x 2048 px, in a file of 10 MB: seconds and memory of the window's first
// picture and of `penpose render`, beside the same file without textures and the built-in head.
//
//   look_bench PENPOSE [FOLDER]     (the window only where DISPLAY names one, such as Xvfb's)

#include <sys/resource.h>
#include <sys/wait.h>

// jpeglib.h names FILE and size_t and includes neither.
#include <cstddef>
#include <cstdio>
//
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <jpeglib.h>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

#include "core/character/demo_head.h"
#include "core/io/model/write_model.h"
#include "ui/files/files.h"
#include "ui/render/picture/image.h"

namespace penpose {
namespace {

constexpr int k_side = 2048;
constexpr int k_textures = 6;
using FileBytes = std::vector<std::uint8_t>;

/// Skin with pores: soft fields and a little noise, as a painted texture has.
render::Image texture(int number) {
  render::Image image{k_side, k_side, FileBytes(std::size_t{k_side} * k_side * 4)};
  std::uint32_t noise = 12345U + static_cast<std::uint32_t>(number);
  for (int y = 0; y < k_side; ++y) {
    for (int x = 0; x < k_side; ++x) {
      noise = noise * 1664525U + 1013904223U;
      const double wave = std::sin(x * 0.004 * (number + 1)) * std::cos(y * 0.003 * (number + 2));
      const int pore = (noise >> 24) < 40 ? static_cast<int>((noise >> 16) & 15U) : 0;
      auto* px =
          image.pixels.data() + (std::size_t{k_side} * static_cast<std::size_t>(y) + static_cast<std::size_t>(x)) * 4;
      for (int c = 0; c < 3; ++c) px[c] = static_cast<std::uint8_t>(150 + 15 * c + static_cast<int>(40 * wave) + pore);
      px[3] = 255;
    }
  }
  return image;
}

FileBytes jpeg_of(const render::Image& image) {
  jpeg_compress_struct writer{};
  jpeg_error_mgr errors{};
  writer.err = jpeg_std_error(&errors);
  jpeg_create_compress(&writer);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&writer, &bytes, &size);
  writer.image_width = k_side;
  writer.image_height = k_side;
  writer.input_components = 4;
  writer.in_color_space = JCS_EXT_RGBA;
  jpeg_set_defaults(&writer);
  jpeg_set_quality(&writer, 92, TRUE);
  jpeg_start_compress(&writer, TRUE);
  while (writer.next_scanline < writer.image_height) {
    JSAMPROW row = const_cast<JSAMPROW>(image.at(0, static_cast<int>(writer.next_scanline)));
    jpeg_write_scanlines(&writer, &row, 1);
  }
  jpeg_finish_compress(&writer);
  FileBytes made(bytes, bytes + size);
  jpeg_destroy_compress(&writer);
  std::free(bytes);
  return made;
}

std::uint32_t number_at(const FileBytes& bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

void put_number(FileBytes& bytes, std::uint32_t value) {
  const auto* from = reinterpret_cast<const std::uint8_t*>(&value);
  bytes.insert(bytes.end(), from, from + 4);
}

/// The demo's head with its controls as morph targets, coordinates around its axis and, if asked, six textures.
FileBytes avatar(bool textured) {
  const auto model = character::make_demo_head().value();
  const FileBytes plain = io::write_glb(model).value();
  const std::size_t json_size = number_at(plain, 12);
  auto json = nlohmann::json::parse(plain.begin() + 20, plain.begin() + 20 + static_cast<std::ptrdiff_t>(json_size));
  FileBytes binary(plain.begin() + 28 + static_cast<std::ptrdiff_t>(json_size), plain.end());
  const auto add_view = [&](const FileBytes& bytes) {
    binary.resize((binary.size() + 3) / 4 * 4);
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
    binary.insert(binary.end(), bytes.begin(), bytes.end());
    return json["bufferViews"].size() - 1;
  };
  json["extras"] = nullptr;
  json["materials"] = nlohmann::json::array();
  for (int i = 0; i < k_textures; ++i) {
    nlohmann::json base = {{"metallicFactor", 0}};
    if (textured) {
      const auto image = texture(i);
      const bool png = i % 2 == 0;
      const FileBytes bytes = png ? render::encode_png(image).value() : jpeg_of(image);
      json["images"].push_back({{"bufferView", add_view(bytes)}, {"mimeType", png ? "image/png" : "image/jpeg"}});
      json["textures"].push_back({{"source", i}});
      base["baseColorTexture"] = {{"index", i}};
    }
    json["materials"].push_back({{"pbrMetallicRoughness", base}});
  }
  std::size_t made = 0;
  for (auto& mesh : json["meshes"]) {
    for (auto& primitive : mesh["primitives"]) {
      const auto& accessor = json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
      const auto& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
      const auto count = accessor["count"].get<std::size_t>();
      const std::size_t at = view.value("byteOffset", std::size_t{0}) + accessor.value("byteOffset", std::size_t{0});
      FileBytes coordinates;
      for (std::size_t v = 0; v < count; ++v) {
        float p[3];
        std::memcpy(p, binary.data() + at + v * 12, sizeof p);
        const float uv[2] = {std::atan2(p[0], p[2]) / 6.2831853F + 0.5F, 0.5F - 3 * p[1]};
        const auto* from = reinterpret_cast<const std::uint8_t*>(uv);
        coordinates.insert(coordinates.end(), from, from + sizeof uv);
      }
      json["accessors"].push_back(
          {{"bufferView", add_view(coordinates)}, {"componentType", 5126}, {"count", count}, {"type", "VEC2"}});
      primitive["attributes"]["TEXCOORD_0"] = json["accessors"].size() - 1;
      primitive["material"] = made++ % k_textures;
    }
  }
  binary.resize((binary.size() + 3) / 4 * 4);
  json["buffers"] = {{{"byteLength", binary.size()}}};
  std::string text = json.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  FileBytes bytes;
  for (const std::uint32_t word : {0x46546c67U, 2U, static_cast<std::uint32_t>(28 + text.size() + binary.size()),
                                   static_cast<std::uint32_t>(text.size()), 0x4e4f534aU})
    put_number(bytes, word);
  bytes.insert(bytes.end(), text.begin(), text.end());
  put_number(bytes, static_cast<std::uint32_t>(binary.size()));
  put_number(bytes, 0x004e4942U);
  bytes.insert(bytes.end(), binary.begin(), binary.end());
  return bytes;
}

struct Run {
  double seconds = 0;
  double processor_seconds = 0;  ///< of all its threads
  double peak_mb = 0;
};

/// Runs a program to its end, or, with `ends_after_s`, until it was asked to end; its output goes to `output`.
Run run(std::vector<std::string> words, const std::string& output, double ends_after_s = 0) {
  const auto began = std::chrono::steady_clock::now();
  const pid_t child = ::fork();
  if (child == 0) {
    const int out = ::open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::dup2(out, STDOUT_FILENO);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ::execv(arguments.front(), arguments.data());
    ::_exit(127);
  }
  if (ends_after_s > 0) {
    std::this_thread::sleep_for(std::chrono::duration<double>(ends_after_s));
    ::kill(child, SIGTERM);
  }
  int status = 0;
  rusage usage{};
  ::wait4(child, &status, 0, &usage);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) std::fprintf(stderr, "%s failed\n", words.front().c_str());
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count(),
          seconds(usage.ru_utime) + seconds(usage.ru_stime), static_cast<double>(usage.ru_maxrss) / 1024};
}

void measure(const std::string& penpose, const std::string& folder, const std::string& name, const std::string& model) {
  std::error_code code;
  const auto size = std::filesystem::file_size(model, code);
  std::printf("%s (%.1f MB)\n", name.c_str(), code ? 0.0 : static_cast<double>(size) / 1e6);
  const std::string text = folder + "/look_bench.txt";
  for (int i = 0; i < 3; ++i) {
    const Run render = run({penpose, "render", model, "-o", folder + "/look_bench.png", "--size", "1280x800"}, text);
    std::printf("  render            %.2f s, %.2f s of processors, %.0f MB at the peak\n", render.seconds,
                render.processor_seconds, render.peak_mb);
  }
  if (std::getenv("DISPLAY") == nullptr) return;
  for (int i = 0; i < 3; ++i) {
    const Run window = run({penpose, "--timings", model}, text, 4);
    const auto bytes = files::read_file(text);
    const std::string line = bytes ? std::string(bytes->begin(), bytes->end()) : std::string();
    const double first_us = line.starts_with("first_frame_us ") ? std::atof(line.c_str() + 15) : 0;
    std::printf("  window            %.2f s to the first picture, %.0f MB at the peak\n", first_us * 1e-6,
                window.peak_mb);
  }
}

int measure_all(const std::string& penpose, const std::string& folder) {
  for (const bool textured : {true, false}) {
    const std::string path = folder + (textured ? "/look_bench_textured.glb" : "/look_bench_plain.glb");
    if (auto written = files::write_file(path, avatar(textured)); !written) {
      std::fprintf(stderr, "%s\n", written.error().line(path).c_str());
      return 1;
    }
    measure(penpose, folder, textured ? "six textures of 2048 x 2048 px" : "the same without textures", path);
  }
  measure(penpose, folder, "the built-in head", "builtin:demo");
  return 0;
}

}  // namespace
}  // namespace penpose

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "look_bench PENPOSE [FOLDER]\n");
    return 2;
  }
  return penpose::measure_all(argv[1], argc > 2 ? argv[2] : std::filesystem::temp_directory_path().string());
}
