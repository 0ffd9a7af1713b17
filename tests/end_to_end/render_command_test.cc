// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures and scenes of a stored layout, by the programs that people run.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "cli/exit_code.h"
#include "tests/fixtures/designed_bedroom.h"

namespace flair::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

namespace fs = std::filesystem;

class RenderCommand : public DesignedBedroom {
 protected:
  static fs::path Layout() { return Design() / "layout.pb"; }
  Finished Flair(std::vector<std::string> arguments) const {
    return RunProgram("flair", arguments, {{"FLAIR_HOME", folder_ / "home"}});
  }
  Finished Render(const std::string& out, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments = {"render", Layout(), "--out", folder_ / out};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Flair(arguments);
  }
  void ExpectNothingLeft() const {
    for (const auto& entry : fs::directory_iterator(folder_.path()))
      EXPECT_EQ(entry.path().filename().string().find(".flair-"), std::string::npos) << entry.path();
  }
};

TEST_F(RenderCommand, TheEndingOfTheFileDecidesItsFormat) {
  const std::pair<std::string, std::string> kStarts[] = {{"plan.png", "\x89PNG"},
                                                         {"plan.jpg", "\xFF\xD8\xFF"},
                                                         {"plan.tif", "II*"},
                                                         {"plan.svg", "<?xml"},
                                                         {"plan.pdf", "%PDF"}};
  for (const auto& [name, start] : kStarts) {
    const Finished run = Render(name);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(ReadAll(folder_ / name), StartsWith(start));
  }
  ExpectNothingLeft();
}

TEST_F(RenderCommand, ThePlanOfADesignIsThePlanOfItsLayout) {
  ASSERT_EQ(Render("plan.png").exit_code, 0);
  EXPECT_TRUE(ReadAll(folder_ / "plan.png") == ReadAll(Design() / "plan.png"));
  EXPECT_THAT(ReadAll(folder_ / "plan.png"), HasSubstr("A bedroom that is 3m x 4m."));
}

TEST_F(RenderCommand, ADesignMayHaveViewsBesideItsPlan) {
  ASSERT_EQ(Flair({"design", "A bedroom that is 3m x 4m.", "--seed", "7", "--view", "birdseye", "--out",
                   folder_ / "design", "--quiet"})
                .exit_code,
            0);
  ASSERT_EQ(Render("again.png", {"--view", "birdseye"}).exit_code, 0);
  EXPECT_TRUE(ReadAll(folder_ / "design" / "birdseye.png") == ReadAll(folder_ / "again.png"));
  EXPECT_FALSE(fs::exists(folder_ / "design" / "perspective.png"));
  const Finished bad = Flair({"design", "A bedroom.", "--view", "below", "--out", folder_ / "bad"});
  EXPECT_EQ(bad.exit_code, cli::kExitBadInput);
  EXPECT_THAT(bad.err, HasSubstr("--view: below: expected plan, birdseye or perspective"));
}

TEST_F(RenderCommand, MeshesOfASceneStateLieWhereItsReadersLook) {
  const Finished run =
      Flair({"export", "sceneeval", Layout(), "--out", folder_ / "room.json", "--meshes", folder_ / "meshes"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  int count = 0;
  for (const auto& entry : fs::directory_iterator(folder_ / "meshes")) {
    const std::string id = entry.path().filename().string();
    EXPECT_THAT(ReadAll(entry.path() / (id + ".glb")), StartsWith("glTF"));
    EXPECT_TRUE(nlohmann::json::accept(ReadAll(entry.path() / "data.json")));
    EXPECT_THAT(ReadAll(folder_ / "room.json"), HasSubstr(id));
    ++count;
  }
  EXPECT_GT(count, 3);
}

TEST_F(RenderCommand, AManifestThatIsNoneIsRefused) {
  fs::create_directories(folder_ / "assets");
  WriteAll(folder_ / "assets" / "manifest.json", "{\"assets\": [");
  const Finished run = Flair({"export", "scene", Layout(), "--assets", folder_ / "assets", "--out", folder_ / "r.glb"});
  EXPECT_EQ(run.exit_code, cli::kExitBadInput);
  EXPECT_THAT(run.err, HasSubstr("manifest.json"));
  EXPECT_FALSE(fs::exists(folder_ / "r.glb"));
}

TEST_F(RenderCommand, ABrokenModelIsToldAndReplaced) {
  fs::create_directories(folder_ / "assets");
  WriteAll(folder_ / "assets" / "manifest.json",
           R"({"assets": [{"id": "b", "file": "bed.glb", "name": "bed", "width_m": 1.6, "depth_m": 2, "height_m": 0.6},
                          {"id": "c", "file": "../../bed.glb", "name": "bed"}]})");
  WriteAll(folder_ / "assets" / "bed.glb", "glTF but no more");
  const Finished run = Flair({"export", "scene", Layout(), "--assets", folder_ / "assets", "--out", folder_ / "r.glb"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("bed.glb"));
  EXPECT_THAT(ReadAll(folder_ / "r.glb"), StartsWith("glTF"));
}

TEST_F(RenderCommand, ABriefThatIsNotTheLayoutsIsNotTaken) {
  fs::copy(Design(), folder_ / "mixed");
  ASSERT_EQ(Flair({"design", "A kitchen for an ogre.", "--out", folder_ / "other", "--quiet"}).exit_code, 0);
  fs::copy(folder_ / "other" / "brief.pb", folder_ / "mixed" / "brief.pb", fs::copy_options::overwrite_existing);
  const Finished run = Flair({"render", folder_ / "mixed" / "layout.pb", "--out", folder_ / "plan.svg"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(ReadAll(folder_ / "plan.svg"), Not(HasSubstr("ogre")));
}

TEST_F(RenderCommand, AnExrComesWithItsAnnotations) {
  const Finished run = Render("view.exr", {"--view", "birdseye", "--size", "256", "--samples", "1"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(ReadAll(folder_ / "view.exr"), StartsWith("\x76\x2f\x31\x01"));
  const nlohmann::json json = nlohmann::json::parse(ReadAll(folder_ / "view.exr.json"));
  EXPECT_EQ(json["camera"]["width_px"], 256);
  EXPECT_GT(json["instances"].size(), 3U);
  ASSERT_EQ(Render("bare.exr", {"--view", "birdseye", "--size", "256", "--samples", "1", "--no-annotations"}).exit_code,
            0);
  EXPECT_FALSE(fs::exists(folder_ / "bare.exr.json"));
}

TEST_F(RenderCommand, AnnotationsOfAPngGoWhereAskedFor) {
  const Finished run = Render("view.png", {"--view", "perspective", "--size", "256", "--samples", "1", "--annotations",
                                           folder_ / "objects.json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(nlohmann::json::accept(ReadAll(folder_ / "objects.json")));
  EXPECT_EQ(Render("plan.png", {"--annotations", folder_ / "no.json"}).exit_code, cli::kExitBadInput);
}

TEST_F(RenderCommand, ARendererOfItsOwnProcessGivesTheSameBytes) {
  AllPrograms programs(folder_.path());
  ASSERT_NE(programs.renderer(), "");
  const std::vector<std::string> view = {"--view", "birdseye", "--size", "256", "--samples", "2"};
  std::vector<std::string> there = view;
  there.insert(there.end(), {"--renderer", programs.renderer()});
  ASSERT_EQ(Render("here.png", view).exit_code, 0);
  ASSERT_EQ(Render("there.png", there).exit_code, 0);
  EXPECT_TRUE(ReadAll(folder_ / "here.png") == ReadAll(folder_ / "there.png"));
  ASSERT_EQ(Render("here.pdf").exit_code, 0);
  ASSERT_EQ(Render("there.pdf", {"--renderer", programs.renderer()}).exit_code, 0);
  EXPECT_TRUE(ReadAll(folder_ / "here.pdf") == ReadAll(folder_ / "there.pdf"));
}

TEST_F(RenderCommand, ScenesAreExported) {
  Finished run = Flair({"export", "scene", Layout(), "--format", "glb", "--out", folder_ / "room.glb"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(ReadAll(folder_ / "room.glb"), StartsWith("glTF"));
  EXPECT_THAT(ReadAll(folder_ / "room.glb"), HasSubstr("A bedroom that is 3m x 4m."));
  run = Flair({"export", "sceneeval", Layout(), "--out", folder_ / "room.json"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(nlohmann::json::accept(ReadAll(folder_ / "room.json")));
  run = Flair({"export", "scene", Layout(), "--format", "fbx", "--out", folder_ / "room.fbx"});
  EXPECT_EQ(run.exit_code, cli::kExitBadInput);
  EXPECT_THAT(run.err, HasSubstr("--format: fbx: is not a scene format; expected glb"));
}

// OpenImageIO takes 0.4 s to load: with a folder of modules that has none, what needs none must work.
TEST_F(RenderCommand, SvgAndPdfAndScenesNeedNoImageLibrary) {
  for (const std::string name : {"plan.svg", "plan.pdf"}) {
    const Finished run = RunProgram("flair", {"render", Layout(), "--out", folder_ / name},
                                    {{"FLAIR_HOME", folder_ / "home"}, {"LD_DEBUG", "files"}});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.err, Not(HasSubstr("OpenImageIO")));
  }
  const Finished run = RunProgram("flair", {"export", "scene", Layout(), "--out", folder_ / "room.glb"},
                                  {{"FLAIR_HOME", folder_ / "home"}, {"LD_DEBUG", "files"}});
  ASSERT_EQ(run.exit_code, 0);
  EXPECT_THAT(run.err, Not(HasSubstr("OpenImageIO")));
}

TEST_F(RenderCommand, AFullDiskLeavesNothing) {
  const Finished run = Flair({"render", Layout(), "--out", "/dev/full"});
  EXPECT_EQ(run.exit_code, cli::kExitBadInput) << "no ending, no format";
  fs::create_symlink("/dev/full", folder_ / "full.png");
  const Finished full = Render("full.png");
  EXPECT_EQ(full.exit_code, cli::kExitFiles) << full.err;
  EXPECT_THAT(full.err, HasSubstr("No space left on device"));
  EXPECT_TRUE(fs::is_symlink(folder_ / "full.png")) << "the device is still the device";
  ExpectNothingLeft();
}

// Lowers the limit for children that start while it lives.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    rlimit lower = before_;
    lower.rlim_cur = bytes;
    setrlimit(RLIMIT_FSIZE, &lower);
  }
  ~FileSizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }

 private:
  rlimit before_ = {};
};

TEST_F(RenderCommand, AFileThatMayNotGrowLeavesNothing) {
  WriteAll(folder_ / "plan.png", "old");
  Finished run;
  {
    const FileSizeLimit limit(4096);
    run = Render("plan.png");
  }
  EXPECT_EQ(run.exit_code, cli::kExitFiles) << run.err;
  EXPECT_THAT(run.err, HasSubstr("plan.png"));
  EXPECT_EQ(ReadAll(folder_ / "plan.png"), "old");
  ExpectNothingLeft();
}

struct Bad {
  const char* name;
  std::vector<std::string> arguments;  // LAYOUT, OUT and FOLDER stand for paths
  int exit_code;
  const char* message;
};

class BadPictureInput : public RenderCommand, public ::testing::WithParamInterface<Bad> {};

TEST_P(BadPictureInput, IsRefusedAndLeavesNothing) {
  WriteAll(folder_ / "garbage.pb", "garbage");
  std::vector<std::string> arguments;
  for (const std::string& argument : GetParam().arguments) {
    std::string text = argument;
    for (const auto& [word, path] : {std::pair<std::string, fs::path>{"LAYOUT", Layout()},
                                     {"OUT", folder_ / "out"},
                                     {"BRIEF", Design() / "brief.pb"},
                                     {"FOLDER", folder_.path()}}) {
      if (text.starts_with(word)) text = path.string() + text.substr(word.size());
    }
    arguments.push_back(text);
  }
  const Finished run = Flair(arguments);
  EXPECT_EQ(run.exit_code, GetParam().exit_code) << run.err;
  EXPECT_THAT(run.err, HasSubstr(GetParam().message));
  for (const auto& entry : fs::directory_iterator(folder_.path()))
    EXPECT_EQ(entry.path().filename(), "garbage.pb") << entry.path();
}

const Bad kBad[] = {
    {"NoEnding", {"render", "LAYOUT", "--out", "OUT"}, 2, "its extension chooses the format: png, jpg"},
    {"UnknownEnding", {"render", "LAYOUT", "--out", "OUT.webp"}, 2, "its extension chooses the format"},
    {"PlanAsExr", {"render", "LAYOUT", "--out", "OUT.exr"}, 2, "EXR is for the ray-traced views"},
    {"ViewAsSvg", {"render", "LAYOUT", "--view", "birdseye", "--out", "OUT.svg"}, 2, "SVG is for plans"},
    {"UnknownView",
     {"render", "LAYOUT", "--view", "top", "--out", "OUT.png"},
     2,
     "--view: top: expected plan, birdseye or perspective"},
    {"SizeOfWords", {"render", "LAYOUT", "--size", "big", "--out", "OUT.png"}, 2, "--size"},
    {"SizeTooSmall",
     {"render", "LAYOUT", "--size", "10", "--out", "OUT.png"},
     2,
     "--size: 10: expected a whole number, 256 to 8192"},
    {"DpiAndSize", {"render", "LAYOUT", "--size", "800", "--dpi", "90", "--out", "OUT.png"}, 2, "one of them"},
    {"ScaleThatDoesNotFit", {"render", "LAYOUT", "--scale", "1:5", "--paper", "a4", "--out", "OUT.pdf"}, 2, "scale"},
    {"CameraAlone",
     {"render", "LAYOUT", "--view", "birdseye", "--camera", "1,1,4", "--out", "OUT.png"},
     2,
     "--look-at"},
    {"CameraOfNan",
     {"render", "LAYOUT", "--view", "birdseye", "--camera", "nan,1,4", "--look-at", "1,2,0", "--out", "OUT.png"},
     2,
     "--camera: nan,1,4: expected several, separated by commas, of: a number"},
    {"SamplesOfZero",
     {"render", "LAYOUT", "--view", "birdseye", "--samples", "0", "--out", "OUT.png"},
     2,
     "--samples: 0"},
    {"ViewTooLarge", {"render", "LAYOUT", "--view", "birdseye", "--size", "8192", "--out", "OUT.exr"}, 2, "at most"},
    {"NoSuchLayout", {"render", "FOLDER/none.pb", "--out", "OUT.png"}, 2, "none.pb"},
    {"GarbageForALayout", {"render", "FOLDER/garbage.pb", "--out", "OUT.png"}, 5, "not a Flair artifact"},
    {"ABriefForALayout", {"render", "BRIEF", "--out", "OUT.png"}, 2, "not a layout"},
    {"FolderForALayout", {"render", "FOLDER", "--out", "OUT.png"}, 4, ""},
    {"UnwritableFolder", {"render", "LAYOUT", "--out", "/proc/flair/plan.png"}, 4, "/proc"},
    {"NobodyAtTheAddress", {"render", "LAYOUT", "--renderer", "127.0.0.1:1", "--out", "OUT.png"}, 3, "127.0.0.1:1"},
    {"AssetsAndRenderer",
     {"render", "LAYOUT", "--renderer", "127.0.0.1:1", "--assets", "FOLDER", "--out", "OUT.png"},
     2,
     "not together with"},
    {"NoSuchAssets",
     {"render", "LAYOUT", "--view", "birdseye", "--assets", "FOLDER/none", "--out", "OUT.png"},
     2,
     "none"},
    {"SceneOfGarbage", {"export", "scene", "FOLDER/garbage.pb", "--out", "OUT.glb"}, 5, "not a Flair artifact"},
    {"SceneOfABrief", {"export", "scene", "BRIEF", "--out", "OUT.glb"}, 2, "not a layout"},
    {"SceneOfUnknownFormat", {"export", "scene", "LAYOUT", "--format", "usd", "--out", "OUT.usd"}, 2, "--format: usd"},
    {"SceneAsUsdz", {"export", "scene", "LAYOUT", "--out", "OUT.usdz"}, 2, "scenes are written as .glb"},
    {"SceneWithoutOut", {"export", "scene", "LAYOUT"}, 2, "--out: missing"},
    {"StateIntoNowhere", {"export", "sceneeval", "LAYOUT", "--out", "/proc/flair/a.json"}, 4, "/proc"},
    {"SheetOfAFile", {"contact-sheet", "LAYOUT", "--out", "OUT.png"}, 4, "is not a folder"},
    {"SheetOfNothing", {"contact-sheet", "FOLDER", "--out", "OUT.png"}, 2, "no folder in it holds a layout.pb"},
    {"SheetAsSvg", {"contact-sheet", "FOLDER", "--out", "OUT.svg"}, 2, "png, jpg, jpeg, tif, tiff"},
    {"SheetOfHugeTiles", {"contact-sheet", "FOLDER", "--tile", "5000", "--out", "OUT.png"}, 2, "--tile"},
    {"SheetOfPicturesAndViews",
     {"contact-sheet", "FOLDER", "--picture", "a.png", "--view", "birdseye", "--out", "OUT.png"},
     2,
     "not together with"},
    {"SheetOfUnknownView", {"contact-sheet", "FOLDER", "--view", "below", "--out", "OUT.png"}, 2, "--view: below"},
};

INSTANTIATE_TEST_SUITE_P(All, BadPictureInput, ::testing::ValuesIn(kBad),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace flair::testing
