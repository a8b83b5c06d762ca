#include "bench/shards/shard.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "bench/scenario/testing/own_files.h"
#include "core/file/text_file.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

TEST(ShardText, IsReadAndWritten) {
  EXPECT_EQ(parse_shard("3/8"), (Shard{3, 8}));
  EXPECT_EQ(text_of(parse_shard("1/1")), "1/1");
  for (const char* text : {"", "3", "0/8", "9/8", "3/", "/8", "3/8/1", "3 / 8", "-1/8", "1/1001"}) {
    EXPECT_INPUT_ERROR(parse_shard(text), "is no shard; --shard 3/8 is the third of eight");
  }
}

class SplitRuns : public OwnFiles {
 protected:
  // Two levels with a recording a seed each, on which two variants run.
  ScenarioPlan plan_of(int seeds) const {
    const std::string file = scenario("room.yaml");
    std::string text = read_text_file(file);
    const auto replace = [&text](const std::string& old, const std::string& by) {
      text.replace(text.find(old), old.size(), by);
    };
    replace("recorder.longest: 1 s\n", "");
    replace("robot.odometry.distance_per_meter: [0 cm, 5 cm]", "recorder.longest: [1 s, 2 s]");
    return planned(write("two.yaml", text), {fmt::format("seeds={}", seeds)});
  }
};

TEST_F(SplitRuns, DivideAllRunsAndKeepThoseOfARecordingTogether) {
  const ScenarioPlan plan = plan_of(7);
  for (const int count : {1, 2, 3, 4, 5, 8, 14}) {
    SCOPED_TRACE(count);
    std::vector<int> all;
    std::vector<std::size_t> sizes;
    std::map<int, std::vector<int>> of_level;  // in each shard
    for (const std::vector<int>& runs : runs_of_all(plan, count)) {
      EXPECT_TRUE(std::is_sorted(runs.begin(), runs.end()));
      all.insert(all.end(), runs.begin(), runs.end());
      sizes.push_back(runs.size());
      for (const int level : {0, 1}) {
        of_level[level].push_back(static_cast<int>(std::count_if(
            runs.begin(), runs.end(), [&](int run) { return plan.row(run).level == level; })));
      }
      for (const int run : runs) {  // the other variant of its recording is the next or last one
        EXPECT_TRUE(std::binary_search(runs.begin(), runs.end(), run ^ 1)) << run;
      }
    }
    std::sort(all.begin(), all.end());
    EXPECT_EQ(all, plan.runs_to_do());
    const auto differ_by = [](const auto& counts) {
      const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
      return *most - *least;
    };
    EXPECT_LE(differ_by(sizes), 2u);  // a recording has two runs
    for (const auto& [level, counts] : of_level) EXPECT_LE(differ_by(counts), 2) << level;
  }
}

TEST_F(SplitRuns, ThoseOfASeedAreSpread) {
  const ScenarioPlan plan = plan_of(2);
  for (const std::vector<int>& runs : runs_of_all(plan, 2)) {
    const auto of_first = std::count_if(runs.begin(), runs.end(), [&](int run) {
      return plan.row(run).seed == plan.scenario.seed;
    });
    EXPECT_EQ(of_first, 2);
  }
}

TEST_F(SplitRuns, MoreShardsThanRecordingsDivideTheirRuns) {
  const ScenarioPlan plan = plan_of(1);
  const auto shards = runs_of_all(plan, 6);  // of 4 runs on 2 recordings
  EXPECT_EQ(std::count_if(shards.begin(), shards.end(),
                          [](const auto& runs) { return runs.size() == 1; }),
            4);
  EXPECT_TRUE(shards.back().empty());
}

TEST_F(SplitRuns, RunsOnALogThatIsTheSameForAllSeedsAreDivided) {
  write_log("own.log");
  const std::string file = write("y.yaml",
                                 "about: a log\nlog: own.log\nseeds: 3\nmetrics: [path_length]\n"
                                 "compare: {a: {estimator: odometry}, b: {estimator: rbpf}}\n");
  for (const auto& runs : runs_of_all(planned(file), 3)) EXPECT_EQ(runs.size(), 2u);
}

}  // namespace
}  // namespace mapbed
