#include "core/io/project/cast_file.h"

#include <gtest/gtest.h>
#include <string>

#include "core/base/byte_writer.h"
#include "core/head/head.h"
#include "core/io/model/write_model.h"
#include "core/io/project/read_document.h"
#include "core/io/project/write_document.h"

namespace penpose::io {
namespace {

/// A binary glTF file with a text in place of JSON, and nothing else.
std::vector<std::uint8_t> small_file(const std::string& text) {
  base::ByteWriter out;
  out.append(std::string_view("glTF"));
  out.write(std::uint32_t{2});
  out.write(static_cast<std::uint32_t>(20 + text.size()));
  out.write(static_cast<std::uint32_t>(text.size()));
  out.write(std::uint32_t{0x4e4f534a});
  out.append(text);
  return out.take();
}

Cast three() {
  Cast cast;
  cast.active = 2;
  cast.members = {{"Anna", {}, true}, {"Ben", {{1, -2, 0.25}, -45, 1.5}, false}, {"Čeněk", {{0, 0, 3}, 180, 1}, true}};
  cast.files = {small_file("{}  "), small_file("[one]   "), small_file("[2] ")};
  return cast;
}

std::string refusal(const std::vector<std::uint8_t>& bytes) {
  const auto cast = read_cast(bytes);
  return cast.ok() ? "" : cast.error().place + ": " + cast.error().what;
}

/// The file with another text in place of one of the same length.
std::vector<std::uint8_t> changed_bytes(const std::string& from, const std::string& to) {
  const auto bytes = *write_cast(three());
  std::string text(bytes.begin(), bytes.end());
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  EXPECT_EQ(from.size(), to.size());
  text.replace(at, from.size(), to);
  return {text.begin(), text.end()};
}

TEST(CastFile, ReadsBackWhoThereIsWhereTheyStandAndEveryFileByteForByte) {
  const auto bytes = write_cast(three());
  ASSERT_TRUE(bytes.ok());
  EXPECT_TRUE(holds_cast(*bytes));
  EXPECT_FALSE(holds_cast(three().files.front()));
  const auto cast = read_cast(*bytes);
  ASSERT_TRUE(cast.ok()) << cast.error().line();
  EXPECT_EQ(cast->active, 2U);
  EXPECT_EQ(cast->files, three().files);
  ASSERT_EQ(cast->members.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(cast->members[i].name, three().members[i].name);
    EXPECT_EQ(cast->members[i].placement, three().members[i].placement);
    EXPECT_EQ(cast->members[i].shown, three().members[i].shown);
  }
}

TEST(CastFile, OtherReadersOpenTheFirstCharacter) {
  Cast cast;
  const auto head = head::make_head();
  const auto file = write_project(document::make_document(head));
  ASSERT_TRUE(file.ok());
  cast.members = {{"One", {}}, {"Two", {}}};
  cast.files = {*file, *file};
  const auto bytes = write_cast(cast);
  ASSERT_TRUE(bytes.ok());
  const auto first = read_document(*bytes, "two.glb");
  ASSERT_TRUE(first.ok()) << first.error().line();
  EXPECT_EQ(first->model->mesh->vertex_count(), head.mesh->vertex_count());
}

TEST(CastFile, SaysWhereItIsWrong) {
  EXPECT_EQ(refusal(small_file("{}  ")), ": this is no project of several characters");
  EXPECT_EQ(refusal(changed_bytes("\"active\":2", "\"active\":3")), "/active: the number of a character was expected");
  EXPECT_EQ(refusal(changed_bytes("\"penpose_cast\":1", "\"penpose_cast\":7")),
            "/penpose_cast: characters of format 7, this program reads 1");
  EXPECT_EQ(refusal(changed_bytes("\"scale\":1.5", "\"scale\":0.0")),
            "/characters/1/scale: a number from 0.000001 to 1000000 was expected");
  EXPECT_EQ(refusal(changed_bytes("-2.0,0.25]", "-2.0,\"25\"]")), "/characters/1/at: three numbers were expected");
  EXPECT_EQ(refusal(changed_bytes("\"name\":\"Ben\"", "\"name\":12345")),
            "/characters/1/name: a name of 1 to 100 bytes was expected");
  EXPECT_EQ(refusal(changed_bytes("\"bytes\":28", "\"bytes\":99")),
            "/characters/1/bytes: the file of the character is cut off");
}

TEST(CastFile, AFileThatIsCutOffAnywhereIsRefusedOrHasNoCast) {
  const auto bytes = *write_cast(three());
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const std::vector<std::uint8_t> part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(read_cast(part).ok()) << size;
  }
}

TEST(CastFile, ANoteAlsoKeepsWhatIsRecordedWhere) {
  Cast cast = three();
  cast.files.clear();
  cast.members[1].session = "/sessions/two.session";
  cast.members[1].model = "two.vrm";
  const std::string note = write_cast_note(cast);
  const auto again = read_cast_note(base::as_bytes(note));
  ASSERT_TRUE(again.ok()) << again.error().line();
  EXPECT_EQ(again->members[1].session, "/sessions/two.session");
  EXPECT_EQ(again->members[1].model, "two.vrm");
  EXPECT_EQ(again->members[0].session, "");
  EXPECT_EQ(again->active, 2U);
}

}  // namespace
}  // namespace penpose::io
