#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/io/project/read_document.h"
#include "core/sound/read/read_sound.h"
#include "tests/support/app_desk.h"
#include "tests/support/shared_data.h"
#include "tests/support/sound_files.h"
#include "ui/app/film/film_entry.h"
#include "ui/app/film/film_writer.h"
#include "ui/app/mouths/first_pass.h"
#include "ui/app/mouths/kept_mouths.h"
#include "ui/app/mouths/mouth_slots.h"
#include "ui/app/playback/arcs.h"
#include "ui/app/playback/keys.h"
#include "ui/app/playback/sheet/overlap_offer.h"
#include "ui/app/sound/sound_track.h"
#include "ui/render/picture/image.h"

// An animator's job from the sound to the film, as it is done in the window.

namespace penpose::app {
namespace {

/// Frames of a sheet are a quarter of a film's.
constexpr int k_cell_px = 160;

class Job : public Desk {
 public:
  Job() : Desk("job") {
    begin();
    app->of<FilmWriter>().use_program(PENPOSE_PROGRAM);
    number_of_controls_ = document().model->rig->parameters().size();
  }

  void lay_sound() {
    const auto bytes = tests::wav_bytes(tests::tone(330, 8000, 2), 8000);
    std::ofstream(path("talk.wav"), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    app->of<SoundTrack>().open(path("talk.wav"));
    frames();
  }
  /// Each of the mouths from the model's own, one of them as the pen pulls it.
  void keep_mouths() {
    app->of<KeptMouths>().keep_usual();
    frames();
    app->of<KeptMouths>().redraw("A");
    press('b');
    pose_mouth(*this);
    app->of<KeptMouths>().keep("A");
    press('c', false, true);
    frames();
  }
  void speak() {
    std::ofstream(path("talk.tsv")) << "0.00\tX\n0.40\tD\n0.70\tA\n0.80\tD\n1.10\tB\n1.30\tF\n1.60\tX\n";
    const auto taken = app->of<FirstPass>().take_cues(path("talk.tsv"));
    EXPECT_TRUE(taken.ok());
    frames();
  }
  /// A brow is drawn where it should be at a moment, and keyed with the controls that it moved.
  void express(double time_s, double up_px) {
    app->of<Playback>().go_to(time_s);
    frames();
    press('b');
    stroke(named_curve("brow_L"));
    stroke(named_curve("brow_L", {0, -up_px}));
    document::SetKey key{app->of<Playback>().time_s(), ""};
    for (const char* name : {"brow_inner_L", "brow_furrow"}) {
      if (rig::find_parameter(document().model->rig->parameters(), name)) key.names.emplace_back(name);
    }
    EXPECT_TRUE(app->of<EditingSession>().perform(key));
  }
  std::vector<ShownArc> arcs() {
    const auto& editing = app->of<EditingSession>();
    return arcs_of(editing.document(), editing.features(), app->of<Canvas>().view(), app->of<Playback>().rate());
  }
  [[nodiscard]] double value(const std::string& control, double time_s) const {
    return document::pose_at(document(), time_s)[*rig::find_parameter(document().model->rig->parameters(), control)];
  }
  /// A sheet of each fourth frame, decoded.
  render::Image sheet() {
    FilmEntry entry;
    entry.kind = film::FilmKind::sheet;
    entry.size = geometry::Viewport{4 * k_cell_px, 4 * k_cell_px};
    entry.range = FilmRange::all;
    entry.every = 4;
    EXPECT_TRUE(app->of<FilmWriter>().write(path("sheet.png"), entry));
    constexpr int k_looks = 6000;
    for (int i = 0; i < k_looks && app->of<FilmWriter>().writes(); ++i) {
      frames(1);
      ::usleep(10'000);
    }
    const std::vector<std::uint8_t> png = tests::read_file(path("sheet.png"));
    return render::decode_png(png).value();
  }

 private:
  std::size_t number_of_controls_ = 0;
};

TEST(AnimatorsJob, FromTheSoundToTheFilm) {
  if (!sound::reads_sounds()) GTEST_SKIP() << "built without libsndfile";
  Job job;
  job.lay_sound();
  job.keep_mouths();
  EXPECT_GE(job.document().mouths.size(), k_first_mouths);
  job.speak();
  ASSERT_NE(job.document().spoken, nullptr);
  job.express(0, 0);
  job.express(1, 24);
  job.express(1.75, 2);
  EXPECT_GT(job.value("brow_inner_L", 1), job.value("brow_inner_L", 0) + 0.1);
  const double closed = job.value("jaw", 0.7);
  EXPECT_GT(job.value("jaw", 0.4), closed + 0.1) << "the words stay under the expressions";
  // The brow rises sooner: a tick of its arc is pulled along to where a later one is.
  job.press('w');
  const auto arcs = job.arcs();
  const auto highest = std::min_element(arcs.begin(), arcs.end(), [](const ShownArc& one, const ShownArc& other) {
    return one.places.front().y < other.places.front().y;
  });
  ASSERT_NE(highest, arcs.end());
  const double sooner = job.value("brow_inner_L", 15 / 24.0);
  ASSERT_GT(sooner, job.value("brow_inner_L", 0.5) + 0.02);
  job.stroke({highest->places[12], (highest->places[12] + highest->places[15]) * 0.5, highest->places[15]});
  EXPECT_NEAR(job.value("brow_inner_L", 0.5), sooner, 0.02);
  // The other brow trails.
  job.press('t');
  for (const auto& key : job.document().timeline->keys) {
    const auto control = rig::find_parameter(job.document().model->rig->parameters(), "brow_inner_L");
    if (key.controls.has(*control)) job.app->of<Keys>().selected().add(key.time_s, *control);
  }
  const double led = job.value("brow_inner_L", 0.75);
  job.app->of<Actions>().run(Action{"overlap"});
  job.frames();
  ASSERT_TRUE(job.app->of<OverlapOffer>().open());
  job.app->of<OverlapOffer>().bake();
  job.frames();
  EXPECT_LT(job.value("brow_inner_L", 0.75), led - 0.02) << "it comes later";
  // What is saved is what was made, and the film shows that the face moves.
  ASSERT_TRUE(job.app->of<Files>().save(job.path("job.glb")).ok());
  const auto again = io::read_document(tests::read_file(job.path("job.glb")), "job.glb");
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(document::DocumentHasher()(*again).whole, job.app->of<EditingSession>().state().whole);
  const render::Image sheet = job.sheet();
  if (const char* folder = std::getenv("PENPOSE_KEEP_JOB"); folder != nullptr) {
    // To be looked at, and opened by other programs (tests/blender).
    for (const std::string name : {"job.glb", "sheet.png"}) {
      std::filesystem::copy_file(job.path(name), std::filesystem::path(folder) / name,
                                 std::filesystem::copy_options::overwrite_existing);
    }
  }
  // Cells lie k_gap px from each other; a film whose frames are all alike would have the same ones.
  constexpr int k_gap = 8;
  ASSERT_GE(sheet.width, 4 * (k_cell_px + k_gap)) << "thirteen frames beside each other";
  const auto cell_px = [&](int column) {
    const int left = k_gap + column * (k_cell_px + k_gap);
    std::vector<std::uint8_t> px;
    for (int y = k_gap; y < k_gap + k_cell_px; ++y)
      px.insert(px.end(), sheet.at(left, y), sheet.at(left, y) + 4 * k_cell_px);
    return px;
  };
  EXPECT_NE(cell_px(0), cell_px(3));
}

}  // namespace
}  // namespace penpose::app
