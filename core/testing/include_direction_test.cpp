// An include root shared by all would let every folder include every other. This test reads each
// #include of the tree and fails on one against the direction of the data: core <- worlds, robots,
// algorithms <- sim <- bench, the chapters of algorithms/ as listed, third-party headers where
// they belong.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/testing/source_tree.h"

namespace mapbed {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using Folders = std::set<std::string>;

// Which of the top folders a top folder may include, besides itself.
const std::map<std::string, Folders> kBelow = {
    {"core", {}},
    {"worlds", {"core"}},
    {"robots", {"core"}},
    {"algorithms", {"core"}},
    {"sim", {"core", "worlds", "robots"}},
    {"bench", {"core", "worlds", "robots", "sim", "algorithms"}},
};

// Within a top folder, from the ground up: a folder may use those of the levels before its own, not
// its neighbours. Each row is a chain of its own.
using Levels = std::vector<Folders>;
const std::map<std::string, std::vector<Levels>> kInnerOrder = {
    {"algorithms",
     {{{"scan", "motion", "particles"},
       {"input"},
       {"grid"},
       {"field"},
       {"scan_matching"},
       {"localization", "refinement", "pose_graph"},
       {"submaps"},
       {"rbpf", "people", "visibility", "dynamic_em", "lazy_association", "rfid"},
       {"segments"}},
      {{"registration3d"}, {"surface"}, {"nonrigid", "exploration", "flight"}}}},
    {"bench",
     {{{"process", "plot", "metrics", "faults"},
       {"results", "methods", "fetch"},
       {"sources"},
       {"figures"},
       {"experiments"},
       {"scenario"},
       {"shards"},
       {"film", "pages"},
       {"cli", "micro"}}}},
};

// Third-party headers that belong to one place, in source files only.
struct Confined {
  std::string header;               // how the include begins
  std::vector<std::string> places;  // how the path of an including file begins
};
const std::vector<Confined> kConfined = {
    {"yaml-cpp/", {"core/config/"}},
    {"png.h", {"core/image/"}},
    {"gif_lib.h", {"core/image/gif_animation"}},
    {"webp/", {"core/image/webp_animation"}},
    {"embree", {"sim/scene/"}},
    {"box2d/", {"sim/physics/"}},
    {"btBullet", {"sim/physics/"}},
    {"bullet/", {"sim/physics/"}},
    {"Eigen/Sparse", {"algorithms/pose_graph/"}},
    {"Eigen/OrderingMethods", {"algorithms/pose_graph/"}},
    {"GL/", {"sim/render/"}},
    {"opencv2/", {"core/image/"}},
    {"benchmark/", {"bench/micro/"}},
    {"ceres/", {"bench/micro/pose_graph_ceres.cpp"}},
    {"CLI/", {"bench/cli/command_line.cpp"}},
    {"gtest/", {"core/testing/", "bench/cli/testing/"}},
    {"gmock/", {"core/testing/", "bench/cli/testing/"}},
    {"nlohmann/", {"bench/", "core/"}},
    {"zlib.h", {"core/file/"}},
    {"bzlib.h", {"core/file/"}},
    {"lz4frame.h", {"core/file/"}},
    {"zstd.h", {"core/file/"}},
    {"sqlite3.h", {"core/log/bags/"}},
    {"boost/", {"core/statistics/"}},
    {"Random123/", {"core/random.cpp"}},
};

bool begins_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string first_part(const std::string& path) {
  return path.substr(0, path.find('/'));
}

// "rbpf" of "algorithms/rbpf/grid_slam.h"; nothing for a file that stands in algorithms/ itself.
std::string inner_folder(const std::string& path) {
  const std::string rest = path.substr(first_part(path).size() + 1);
  return rest.find('/') == std::string::npos ? "" : first_part(rest);
}

// The number of the level that holds the folder; none where the chain does not.
std::optional<std::size_t> level_of(const std::string& folder, const Levels& chain) {
  for (std::size_t level = 0; level < chain.size(); ++level) {
    if (chain[level].contains(folder)) return level;
  }
  return {};
}

// Why the folder `from` may not use the folder `to` of the same top folder.
std::string objection_within(const std::string& top, const std::string& from,
                             const std::string& to) {
  if (from == "testing" || to == "testing") return "";
  for (const Levels& chain : kInnerOrder.at(top)) {
    const auto own = level_of(from, chain);
    const auto other = level_of(to, chain);
    if (own && other) return *other < *own ? "" : from + " may not know " + to;
    if (own) return from + " may not know " + to;
  }
  return top + "/" + from + " is not listed in this test";
}

bool is_test(const std::string& path) {
  return ends_with(path, "_test.cpp") || ends_with(path, "_fuzz.cpp") ||
         path.find("/testing/") != std::string::npos;
}

// A table of everything that a folder holds.
bool is_table(const std::string& header) {
  return header == "algorithms/methods.h";
}

// Why the file may not include the project's own header; empty where it may.
std::string objection_to_own(const std::string& file, const std::string& header) {
  const std::string from = first_part(file);
  const std::string to = first_part(header);
  if (!kBelow.contains(to)) return "is not a path from the root of the tree";
  if (from != to && !kBelow.at(from).contains(to)) return from + " may not know " + to;
  if (begins_with(header, "core/testing/") && !is_test(file)) return "is for tests only";
  if (from != to || !kInnerOrder.contains(from)) return "";
  const std::string inner = inner_folder(file);
  const std::string other = inner_folder(header);
  // A table that stands in a top folder itself knows what it lists, and nobody else does.
  if (inner.empty() || inner == other) return "";
  if (other.empty()) return is_table(header) ? "tables are for what stands above them" : "";
  return objection_within(from, inner, other);
}

// The same for <…>: the standard library and Eigen everywhere, others in source files only.
std::string objection_to_other(const std::string& file, const std::string& header) {
  const bool of_cpp = header.find('/') == std::string::npos && !ends_with(header, ".h");
  if (of_cpp || begins_with(header, "Eigen/")) return "";
  if (is_test(file)) {
    if (begins_with(header, "gtest/") || begins_with(header, "gmock/")) return "";
  }
  for (const Confined& rule : kConfined) {
    if (!begins_with(header, rule.header)) continue;
    const auto holds = [&](const std::string& place) { return begins_with(file, place); };
    if (std::none_of(rule.places.begin(), rule.places.end(), holds)) {
      return "belongs in " + rule.places.front() + " only";
    }
  }
  const bool of_system = begins_with(header, "sys/") || header.find('/') == std::string::npos;
  if (ends_with(file, ".h") && !of_system) return "third-party headers belong in .cpp files";
  return "";
}

// "file:line: <header> reason" for each include that is against the rules.
std::vector<std::string> objections_to(const std::string& file, std::istream& text) {
  static const std::regex include(R"re(^\s*#\s*include\s*(["<])([^">]+)[">].*)re");
  std::vector<std::string> found;
  std::string line;
  for (int number = 1; std::getline(text, line); ++number) {
    if (line.find("include") == std::string::npos) continue;
    std::smatch match;
    if (!std::regex_match(line, match, include)) continue;
    const std::string header = match[2];
    const bool own = match[1] == "\"";
    const std::string why = own ? objection_to_own(file, header) : objection_to_other(file, header);
    if (!why.empty())
      found.push_back(file + ":" + std::to_string(number) + ": " + header + " " + why);
  }
  return found;
}

std::vector<std::string> objections_to(const std::string& file, const std::string& text) {
  std::istringstream stream(text);
  return objections_to(file, stream);
}

TEST(IncludeDirection, HoldsInTheWholeTree) {
  const fs::path root = source_tree();
  std::vector<std::string> found;
  int files = 0;
  for (const auto& [folder, below] : kBelow) {
    if (!fs::exists(root / folder)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      std::ifstream text(entry.path());
      const auto more = objections_to(fs::relative(entry.path(), root).generic_string(), text);
      found.insert(found.end(), more.begin(), more.end());
      ++files;
    }
  }
  EXPECT_THAT(found, IsEmpty());
  EXPECT_GT(files, 20) << "looked in the wrong place: " << root;
}

TEST(IncludeDirection, KeepsTheTruthFromAlgorithms) {
  EXPECT_THAT(
      objections_to("algorithms/rbpf/grid_slam.cpp", "#include \"sim/truth.h\"\n"),
      ElementsAre("algorithms/rbpf/grid_slam.cpp:1: sim/truth.h algorithms may not know sim"));
}

TEST(IncludeDirection, KeepsChaptersApartButForThoseTheyBuildOn) {
  EXPECT_THAT(
      objections_to("algorithms/rbpf/grid_slam.h", "#include \"algorithms/people/legs.h\"\n"),
      ElementsAre("algorithms/rbpf/grid_slam.h:1: algorithms/people/legs.h rbpf may not know "
                  "people"));
  EXPECT_THAT(objections_to("algorithms/rbpf/grid_slam.h",
                            "#include \"algorithms/grid/counting_map.h\"\n"
                            "#include \"algorithms/pose_graph/graph.h\"\n"),
              IsEmpty());
  EXPECT_THAT(objections_to("algorithms/grid/counting_map.h",
                            "#include \"algorithms/scan_matching/scan_matcher.h\"\n"),
              ElementsAre(::testing::HasSubstr("grid may not know scan_matching")));
  EXPECT_THAT(
      objections_to("algorithms/surface/triangles.h", "#include \"algorithms/rbpf/grid_slam.h\"\n"),
      ElementsAre(::testing::HasSubstr("surface may not know rbpf")));
  EXPECT_THAT(objections_to("algorithms/rbpf/grid_slam.h", "#include \"algorithms/methods.h\"\n"),
              ElementsAre(::testing::HasSubstr("tables are for what stands above them")));
}

TEST(IncludeDirection, LetsABenchFolderUseThoseBeforeIt) {
  EXPECT_THAT(objections_to("bench/results/summary.cpp", "#include \"bench/plot/plot.h\"\n"),
              IsEmpty());
  EXPECT_THAT(objections_to("bench/results/summary.cpp", "#include \"bench/scenario/plan.h\"\n"),
              ElementsAre(::testing::HasSubstr("results may not know scenario")));
}

TEST(IncludeDirection, KeepsThirdPartyHeadersInSourcesOfTheirFolder) {
  EXPECT_THAT(objections_to("sim/scene/ray_caster.cpp", "#include <embree3/rtcore.h>\n"),
              IsEmpty());
  EXPECT_THAT(objections_to("sim/scene/ray_caster.h", "#include <embree3/rtcore.h>\n"),
              ElementsAre(::testing::HasSubstr("belong in .cpp files")));
  EXPECT_THAT(objections_to("sim/recorder.cpp", "#include <box2d/box2d.h>\n"),
              ElementsAre(::testing::HasSubstr("belongs in sim/physics/ only")));
  EXPECT_THAT(objections_to("core/geometry/pose2.h", "#include <Eigen/Core>\n#include <vector>\n"),
              IsEmpty());
}

TEST(IncludeDirection, KeepsTestHelpersInTests) {
  EXPECT_THAT(
      objections_to("core/log/dialects/carmen_log.cpp", "#include \"core/testing/is_near.h\"\n"),
      ElementsAre(::testing::HasSubstr("is for tests only")));
  EXPECT_THAT(objections_to("core/log/dialects/carmen_log_test.cpp",
                            "#include \"core/testing/is_near.h\"\n"),
              IsEmpty());
}

}  // namespace
}  // namespace mapbed
