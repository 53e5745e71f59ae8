#include "ui/app/files/dropped_file.h"

#include <fstream>
#include <gtest/gtest.h>

#include "tests/support/app_desk.h"

namespace penpose::app {
namespace {

DroppedKind kind(std::string_view content, std::string_view name = "file") {
  return kind_of_content(base::as_bytes(content), name);
}

TEST(DroppedFile, IsKnownByWhatIsInItWhateverItIsCalled) {
  using namespace std::string_view_literals;
  EXPECT_EQ(kind("RIFF\0\0\0\0WAVEfmt "sv, "picture.png"), DroppedKind::sound);
  EXPECT_EQ(kind("fLaC"), DroppedKind::sound);
  EXPECT_EQ(kind("\x89PNG\r\n\x1a\n", "song.wav"), DroppedKind::picture);
  EXPECT_EQ(kind("\xFF\xD8\xFF\xE0"), DroppedKind::picture);
  EXPECT_EQ(kind("RIFF\0\0\0\0WEBPVP8 "sv), DroppedKind::picture);
  EXPECT_EQ(kind("\0\0\0\x20"
                 "ftypisom"sv,
                 "model.glb"),
            DroppedKind::film);
  EXPECT_EQ(kind("\x1A\x45\xDF\xA3"), DroppedKind::film);
  EXPECT_EQ(kind("GIF89a"), DroppedKind::film);
  EXPECT_EQ(kind("<?xml version=\"1.0\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\">"), DroppedKind::drawing);
  EXPECT_EQ(kind("glTF\2\0\0\0"sv, "take.csv"), DroppedKind::model);
  EXPECT_EQ(kind("# hid-recorder\nR: 3 05 0d 09\nN: pen\n"), DroppedKind::session);
  EXPECT_EQ(kind("frame, face_id, timestamp, confidence, success, x_0, x_1, y_0, y_1\n"), DroppedKind::take);
  EXPECT_EQ(kind("", "face.obj"), DroppedKind::model) << "its name, where nothing else tells";
  EXPECT_EQ(kind("v 1 2 3\n", "face.obj"), DroppedKind::model);
  EXPECT_EQ(kind("hello"), DroppedKind::unknown);
  EXPECT_EQ(kind(""), DroppedKind::unknown);
}

TEST(DroppedFile, EveryKindSaysWhatCanBeDoneWithIt) {
  for (int i = 0; i <= static_cast<int>(DroppedKind::unknown); ++i) {
    const auto one = static_cast<DroppedKind>(i);
    EXPECT_FALSE(words_of(one).empty());
    EXPECT_EQ(deeds_of(one).empty(), one == DroppedKind::unknown);
    for (const DropDeed deed : deeds_of(one)) EXPECT_STRNE(words_of(deed).label, "");
  }
}

TEST(DroppedFile, AFolderAndAFileThatIsNotThereAreNothing) {
  EXPECT_EQ(kind_of_dropped("/"), DroppedKind::unknown);
  EXPECT_EQ(kind_of_dropped("/no/such/file.glb"), DroppedKind::unknown);
}

void write_svg(const std::string& path) { std::ofstream(path) << "<svg xmlns=\"http://www.w3.org/2000/svg\"></svg>"; }

TEST(DropDesk, NothingHappensBeforeTheCardIsAnswered) {
  Desk desk("drop");
  desk.begin();
  ASSERT_TRUE(desk.app->of<Files>().save(desk.path("one.glb")).ok());
  const std::string before = desk.app->of<Files>().path();
  desk.app->of<DropDesk>().drop(desk.path("one.glb"));
  desk.frames();
  EXPECT_EQ(desk.app->of<DropDesk>().kind(), DroppedKind::project);
  EXPECT_EQ(desk.app->of<Files>().path(), before);
  EXPECT_NE(desk.interface->find("Add it beside##drop"), nullptr);
  desk.hit_return();
  EXPECT_EQ(desk.app->of<Files>().path(), desk.path("one.glb"));
  EXPECT_FALSE(desk.app->of<Dialogs>().any());
}

TEST(DropDesk, AModelIsAddedBesideTheOneThatIsOpen) {
  Desk desk("drop-beside");
  desk.begin();
  ASSERT_TRUE(desk.app->of<Files>().save(desk.path("one.glb")).ok());
  desk.app->of<DropDesk>().drop(desk.path("one.glb"));
  desk.frames();
  desk.click("Add it beside##drop");
  desk.frames();
  EXPECT_EQ(desk.app->of<Cast>().size(), 2U);
  EXPECT_FALSE(desk.app->of<Dialogs>().any());
}

TEST(DropDesk, SeveralFilesAreAskedAboutOneAfterTheOther) {
  Desk desk("drop-many");
  desk.begin();
  write_svg(desk.path("a.svg"));
  std::ofstream(desk.path("b.txt")) << "hello";
  DropDesk& drops = desk.app->of<DropDesk>();
  drops.drop(desk.path("b.txt"));
  drops.drop(desk.path("a.svg"));
  desk.frames();
  EXPECT_EQ(drops.kind(), DroppedKind::unknown);
  EXPECT_EQ(drops.more(), 1U);
  desk.hit_return();
  EXPECT_EQ(drops.path(), desk.path("b.txt")) << "there is nothing to do with it";
  desk.hit_escape();
  EXPECT_TRUE(drops.path().empty());
  EXPECT_FALSE(desk.app->of<Dialogs>().any());
}

TEST(DropDesk, APictureBecomesAReferenceAtOnce) {
  Desk desk("drop-picture");
  desk.begin();
  render::Image image{8, 8, {}};
  image.pixels.assign(std::size_t{8} * 8 * 4, 200);
  const auto bytes = render::encode_png(image);
  std::ofstream(desk.path("p.png"), std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
  desk.app->of<DropDesk>().drop(desk.path("p.png"));
  desk.frames();
  EXPECT_EQ(desk.document().reference, nullptr);
  desk.click("Reference on a card##drop");
  ASSERT_NE(desk.document().reference, nullptr);
  EXPECT_TRUE(desk.document().reference->beside);
}

}  // namespace
}  // namespace penpose::app
