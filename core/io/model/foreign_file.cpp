#include "core/io/model/foreign_file.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/text/letters.h"
#include "core/io/model/model_formats.h"

namespace penpose::io {
namespace {

using namespace std::string_view_literals;

constexpr const char* k_download = "download the file itself";
constexpr const char* k_unpack = "unpack it and open the model inside";
constexpr const char* k_to_glb = "open it in Blender and export it as glTF (.glb)";
constexpr const char* k_a_model = "choose a file with a model";
constexpr const char* k_again = "download or export the file again";

struct Mark {
  std::string_view start;
  const char* what;
};

/// Starts of files with the same remedy.
struct Marks {
  const char* remedy;
  std::vector<Mark> marks;
};

std::vector<Marks> known_marks() {
  return {
      {"fetch the file itself with `git lfs pull`, or download it from the page of the repository",
       {{"version https://git-lfs.github.com/spec/"sv, "this is a Git LFS pointer, not the model"},
        {"version https://hawser.github.com/spec/"sv, "this is a Git LFS pointer, not the model"}}},
      {"fetch the file itself with `git annex get`",
       {{"/annex/objects/"sv, "this is a pointer of git-annex, not the model"}}},
      {k_unpack,
       {{"7z\xbc\xaf\x27\x1c"sv, "this is a 7z archive"},
        {"Rar!\x1a\x07"sv, "this is a RAR archive"},
        {"\xfd\x37zXZ\0"sv, "this is an archive compressed by xz"},
        {"BZh"sv, "this is a file compressed by bzip2"}}},
      {"unpack it, or open it in Blender and export it as glTF (.glb)",
       {{"\x1f\x8b"sv, "this is a file compressed by gzip, such as .gz or a compressed .blend"},
        {"\x28\xb5\x2f\xfd"sv, "this is a file compressed by Zstandard, such as a compressed .blend"}}},
      {k_to_glb,
       {{"BLENDER"sv, "this is a .blend file of Blender"},
        {"PXR-USDC"sv, "this is a USD file"},
        {"#usda "sv, "this is a USD file"},
        {"Ogawa"sv, "this is an Alembic file"},
        {"xof 0"sv, "this is a DirectX .x file"},
        {"#VRML"sv, "this is a VRML file"}}},
      {"import it into Blender and export it as glTF (.glb)",
       {{"PMX "sv, "this is a model of MikuMikuDance (PMX)"}, {"Pmd"sv, "this is a model of MikuMikuDance (PMD)"}}},
      {"export it from Maya as FBX",
       {{"//Maya ASCII"sv, "this is a scene of Maya"},
        {"FOR4"sv, "this is a scene of Maya"},
        {"FOR8"sv, "this is a scene of Maya"}}},
      {"export the model itself as .vrm or .glb", {{"UnityFS"sv, "this is an asset bundle of Unity"}}},
      {"export it from the editor as FBX or glTF (.glb)",
       {{"\xc1\x83\x2a\x9e"sv, "this is an asset of Unreal Engine"}}},
      {k_a_model,
       {{"Vocaloid Motion Data"sv, "this is a motion of MikuMikuDance (.vmd), not a model"},
        {"\x89PNG\r\n\x1a\n"sv, "this is a picture (PNG), not a model"},
        {"\xff\xd8\xff"sv, "this is a picture (JPEG), not a model"},
        {"%PDF-"sv, "this is a PDF document, not a model"}}},
  };
}

/// A zip by the name of its first file, which stands in its header (APPNOTE 4.3.7: the length at 26, the name at 30).
base::Error zip(std::string_view text) {
  const auto byte = [&](std::size_t at) { return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U; };
  const std::size_t length = byte(26) + 256U * byte(27);
  const std::string name =
      base::lower_case(text.size() > 30 ? text.substr(30, std::min<std::size_t>(length, 260)) : "");
  const auto is = [](const char* what, const char* remedy) { return base::Error{what, "byte offset 0", remedy}; };
  if (name.ends_with(".usd") || name.ends_with(".usda") || name.ends_with(".usdc")) {
    return is("this is a USDZ file", k_to_glb);
  }
  if (name.starts_with("3d/") || name.starts_with("[content_types]")) {
    return is("this is a 3MF file or an office document", "save the model in it as OBJ or glTF (.glb)");
  }
  return is("this is a zip archive", k_unpack);
}

bool is_page(std::string_view text) {
  const std::string start = base::lower_case(text.substr(0, 512));
  constexpr std::array<std::string_view, 6> k_starts = {"<!doctype html", "<html",   "<head",
                                                        "<body",          "<script", "<meta"};
  return std::any_of(k_starts.begin(), k_starts.end(), [&](auto begin) { return start.starts_with(begin); }) ||
         (start.starts_with("<") &&
          (start.find("<html") != std::string::npos || start.find("<!doctype html") != std::string::npos));
}

}  // namespace

std::optional<base::Error> foreign_file(base::Bytes bytes) {
  if (format_of_content(bytes) != nullptr) return std::nullopt;
  const std::string_view raw = base::as_text(bytes);
  const auto is = [](const char* what, const char* remedy) { return base::Error{what, "byte offset 0", remedy}; };
  for (const Marks& known : known_marks()) {
    for (const Mark& mark : known.marks) {
      if (raw.starts_with(mark.start)) return is(mark.what, known.remedy);
    }
  }
  if (raw.starts_with("PK\x03\x04")) return zip(raw);
  if (raw.starts_with("PK\x05\x06")) return is("this is an empty zip archive", k_again);
  if (raw.starts_with("\xff\xfe") || raw.starts_with("\xfe\xff")) {
    return is("this is text in UTF-16", "save it as UTF-8");
  }
  if (raw.substr(0, 16).find_first_not_of('\0') == std::string_view::npos && raw.size() >= 16 &&
      raw.substr(0, 4096).find_first_not_of('\0') == std::string_view::npos) {
    return is("the file begins with nothing but zeros: a download or copy that was not finished", k_again);
  }
  std::string_view text = base::without_mark(raw.substr(0, 4096));
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (is_page(text)) return is("this is a web page, not the model", k_download);
  if (text.starts_with("<")) {
    if (text.find("<COLLADA") != std::string_view::npos) return is("this is a COLLADA file", k_to_glb);
    if (text.find("<X3D") != std::string_view::npos) return is("this is an X3D file", k_to_glb);
    if (text.find("<svg") != std::string_view::npos) {
      return is("this is a drawing (SVG), not a model", k_a_model);
    }
    if (text.find("<Error>") != std::string_view::npos) {
      return is("this is the error message of a server, not the model", k_download);
    }
    if (text.starts_with("<?xml")) return is("this is XML, not a model", k_a_model);
  }
  return std::nullopt;
}

}  // namespace penpose::io
