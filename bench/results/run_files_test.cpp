#include "bench/results/run_files.h"

#include <gmock/gmock.h>

namespace mapbed {
namespace {

using ::testing::ElementsAre;

// Levels of a sweep, two variants, first seed 7.
Results compared() {
  Results results{.seed = 7};
  results.axes = {axis_of("people", {"0", "5"})};
  results.levels = levels_of(results.axes);
  results.variants = {"raw", "not raw"};
  for (int run = 0; run < 8; ++run) {
    results.runs.push_back({.run = run,
                            .level = run % 4 / 2,
                            .variant = run % 2,
                            .seed = 7u + static_cast<unsigned>(run / 4)});
  }
  return results;
}

TEST(RunFiles, TheNameSaysLevelAndVariant) {
  const Results results = compared();
  const FileOfRun file = file_of_run({"maps/map.png", "", ""}, results.runs[3], results);
  EXPECT_EQ(file.path, "maps/map_level_1_not_raw.png");
  EXPECT_EQ(file.run, 3);
  EXPECT_EQ(file.title, "map");
  EXPECT_EQ(file_of_run({"maps/end_points.png", "", ""}, results.runs[0], results).title,
            "end points");
  EXPECT_EQ(file_of_run({"maps/map.png", "", "the map"}, results.runs[0], results).title,
            "the map");
}

TEST(RunFiles, OfASingleRunKeepTheirName) {
  Results results;
  results.levels = {{}};
  results.variants = {"all"};
  results.runs = {{.run = 0, .seed = 1}};
  EXPECT_EQ(file_of_run({"maps/map.png", "", ""}, results.runs[0], results).path, "maps/map.png");
}

TEST(RunFiles, AreFoundByTheirNames) {
  const Results results = compared();
  for (int run = 0; run < 4; ++run) {
    const FileOfRun file = file_of_run({"maps/the_map.png", "", ""}, results.runs[run], results);
    const std::vector<FileOfRun> found = files_by_name({file.path, "maps/of_my_own.png"}, results);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].path, file.path);
    EXPECT_EQ(found[0].run, run);
    EXPECT_EQ(found[0].title, "the map");
  }
}

// "raw" ends like "not raw".
TEST(RunFiles, AreOfTheVariantWhoseWholeNameTheyHave) {
  Results results{.seed = 7};
  results.levels = levels_of({});
  results.variants = {"not raw", "raw"};
  results.runs = {{.run = 0, .variant = 0, .seed = 7}, {.run = 1, .variant = 1, .seed = 7}};
  const std::vector<FileOfRun> found =
      files_by_name({"maps/map_not_raw.png", "maps/map_raw.png"}, results);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].run, 0);
  EXPECT_EQ(found[0].title, "map");
  EXPECT_EQ(found[1].run, 1);
}

TEST(RunFiles, VariantsWithoutLettersOfTheirOwnAreNumbered) {
  Results results{.seed = 7};
  results.levels = levels_of({});
  results.variants = {"\u00e4", "\u00f6", "a b", "a_b", "c"};
  std::vector<std::string> names;
  for (int i = 0; i < 5; ++i) {
    results.runs.push_back({.run = i, .variant = i, .seed = 7});
    names.push_back(file_of_run({"maps/map.png", "", ""}, results.runs.back(), results).path);
  }
  EXPECT_THAT(names,
              ElementsAre("maps/map_variant_0.png", "maps/map_variant_1.png",
                          "maps/map_variant_2.png", "maps/map_variant_3.png", "maps/map_c.png"));
}

TEST(RunFiles, SortAsPeopleDo) {
  std::vector<std::string> paths{"after_130_s", "after_90_s", "after", "after_90_s_b"};
  std::sort(paths.begin(), paths.end(), in_natural_order);
  EXPECT_THAT(paths, ElementsAre("after", "after_90_s", "after_90_s_b", "after_130_s"));
}

}  // namespace
}  // namespace mapbed
