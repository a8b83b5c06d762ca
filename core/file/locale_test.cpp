// Numbers are read and written with a point, whatever the locale of the program that uses the
// library.

#include <clocale>
#include <filesystem>
#include <locale>
#include <regex>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "core/config/config_node.h"
#include "core/config/quantity.h"
#include "core/file/csv_file.h"
#include "core/file/text_file.h"
#include "core/geometry/tum_file.h"
#include "core/image/map_server.h"
#include "core/log/dialects/carmen_log.h"
#include "core/testing/source_tree.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

class Comma : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

// C++ streams have commas and groups of thousands; C functions too where such a locale is
// installed.
class InACommaLocale : public ::testing::Test {
 protected:
  InACommaLocale() : before_(std::locale::global(std::locale(std::locale(), new Comma))) {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "nl_NL.UTF-8"}) {
      if (std::setlocale(LC_NUMERIC, name) != nullptr) break;
    }
  }
  ~InACommaLocale() override {
    std::locale::global(before_);
    std::setlocale(LC_NUMERIC, "C");
  }

  std::locale before_;
};

TEST_F(InACommaLocale, SettingsHavePoints) {
  EXPECT_EQ(parse_quantity("1234.5 cm", Unit::meter, {}), 12.345);
  EXPECT_EQ(quantity_text(1234.5, Unit::meter), "1234.5 m");
  EXPECT_EQ(parse_config("{a: 1234.5}", {"x.yaml", 1}).at("a").number(), 1234.5);
}

TEST_F(InACommaLocale, TablesAndTrajectoriesHavePoints) {
  EXPECT_EQ(csv_number(12345.5), "12345.5");
  EXPECT_EQ(parse_csv_number("12345.5"), 12345.5);
  const Trajectory path{{1234567.5, {1234.5, -0.25, 0.0}}};
  EXPECT_THAT(tum_text(path), HasSubstr("1234567.500000 1234.500000000 -0.250000000"));
  EXPECT_EQ(parse_trajectory("a.tum", tum_text(path))[0].pose.x, 1234.5);
}

TEST_F(InACommaLocale, LogsHavePoints) {
  RecordedLog log;
  LaserScan scan;
  scan.time = 12345.5;
  scan.first_bearing = -0.5;
  scan.bearing_step = 0.5;
  scan.max_range = 8.5;
  scan.ranges = {1.25, 2.5, 3.75};
  log.measurements = {scan};
  const RecordedLog back = parse_log("a.log", carmen_text(log));
  EXPECT_EQ(std::get<LaserScan>(back.measurements[0]).ranges[2], 3.75);
  EXPECT_EQ(time_of(back.measurements[0]), 12345.5);
}

TEST_F(InACommaLocale, MapsHavePoints) {
  const TemporaryFolder folder;
  MapServerMap map{.occupancy = Image<float>(2, 1, 1.0F), .resolution = 0.125};
  map.map_from_image = {-1234.5, 0.25, 0.0};
  write_map_server(folder.file("map"), map);
  const MapServerMap back = read_map_server(folder.file("map.yaml"));
  EXPECT_EQ(back.resolution, 0.125);
  EXPECT_EQ(back.map_from_image.x, -1234.5);
}

// C's functions obey the locale, which not every machine has one with commas to show it by.
TEST(Locale, NobodyReadsNumbersByFunctionsThatObeyIt) {
  namespace fs = std::filesystem;
  const std::regex obeys(
      R"(\b(strto[df]|strtold|atof|sto[df]|stold|f?scanf|sscanf|snprintf)\s*\()");
  std::vector<std::string> found;
  int files = 0;
  for (const char* folder : {"core", "worlds", "robots", "sim", "algorithms", "bench"}) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_tree()) / folder)) {
      const std::string path = entry.path().string();
      const bool is_source = path.ends_with(".cpp") || path.ends_with(".h");
      if (!is_source || path.ends_with("_test.cpp")) continue;
      ++files;
      const std::string text = read_text_file(path);
      if (std::regex_search(text, obeys)) found.push_back(path);
    }
  }
  EXPECT_THAT(found, ::testing::IsEmpty());
  EXPECT_GT(files, 100) << "looked in the wrong place: " << source_tree();
}

}  // namespace
}  // namespace mapbed
