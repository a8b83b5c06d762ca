// A course becomes frames, and these a file.

#include "bench/film/film.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "bench/film/film_painter.h"
#include "bench/plot/map_raster.h"
#include "bench/plot/track_style.h"
#include "bench/process/child_process.h"
#include "core/file/text_file.h"
#include "core/image/animation.h"
#include "core/testing/temporary_folder.h"

namespace mapbed {
namespace {

using ::testing::HasSubstr;

constexpr double kTurn = 2.0 * M_PI;

// A robot in the middle of a room of 6 m x 4 m that looks round and goes 0.5 m a second along x for
// 2 s; in its second step it believes to have been 1 m off to the side.
Course course_of_a_room() {
  Course course{.method = "told", .end = 2.0};
  for (int i = 0; i <= 2; ++i) {
    LaserScan scan{.time = 1.0 * i, .bearing_step = kTurn / 180.0, .max_range = 10.0};
    for (int beam = 0; beam < 180; ++beam) {
      const double bearing = scan.bearing(static_cast<std::size_t>(beam));
      const double ahead = std::cos(bearing) > 0.0 ? 3.0 - 0.5 * i : 3.0 + 0.5 * i;
      const double x = ahead / std::max(std::abs(std::cos(bearing)), 1e-9);
      const double y = 2.0 / std::max(std::abs(std::sin(bearing)), 1e-9);
      scan.ranges.push_back(std::min(x, y));
    }
    course.scans[static_cast<std::size_t>(i)] = scan;
    course.of_map.push_back(static_cast<std::size_t>(i));
    course.truth.push_back({1.0 * i, {0.5 * i, 0.0, 0.0}});
  }
  course.steps.push_back({.time = 0.0, .kept = 0, .later = {{0.0, 0.0, 0.0}}});
  course.steps.push_back({.time = 1.0, .kept = 1, .later = {{0.5, 1.0, 0.0}}});
  course.steps.push_back({.time = 2.0,
                          .kept = 1,
                          .later = {{0.5, 0.0, 0.0}, {1.0, 0.0, 0.0}},
                          .particles = {{1.0, 0.0, 0.0}, {1.0, 0.3, 0.0}}});
  return course;
}

int count_of(const RgbImage& image, const Rgb& color) {
  return static_cast<int>(std::count(image.pixels().begin(), image.pixels().end(), color));
}

TEST(FilmPainter, TheMapGrowsAndFollowsThePath) {
  const Course course = course_of_a_room();
  FilmPainter painter(course, 300, 1.0);
  const int unknown_at_first = count_of(painter.frame_at(0.0), kUnknownColor);
  const int unknown_when_astray = count_of(painter.frame_at(1.0), kUnknownColor);
  const int unknown_in_the_end = count_of(painter.frame_at(2.0), kUnknownColor);
  EXPECT_LT(unknown_when_astray, unknown_at_first) << "the room of the wrong pose, too";
  // All three scans see the same room from where they were: but for the walls' edges nothing is
  // left of the wrong one. A room of 4 m that is off by 1 m has a quarter more.
  EXPECT_NEAR(unknown_in_the_end, unknown_at_first, 0.2 * (unknown_at_first - unknown_when_astray));
}

TEST(FilmPainter, FramesHaveEvenSidesNearTheSizeThatWasAskedFor) {
  const Course course = course_of_a_room();
  for (const int side : {100, 301, 640, 1001}) {
    FilmPainter painter(course, side, 1.0);
    EXPECT_EQ(painter.width() % 2, 0) << side;
    EXPECT_EQ(painter.height() % 2, 0) << side;
    EXPECT_NEAR(painter.width(), side, 0.1 * side + 2) << "7.4 m x 5.4 m with the border";
  }
}

TEST(FilmPainter, ItsPaletteHasWhatItPaints) {
  const std::vector<Rgb> palette = FilmPainter::palette();
  EXPECT_LT(palette.size(), 256u);
  const Course course = course_of_a_room();
  FilmPainter painter(course, 400, 1.0);
  painter.frame_at(0.0);
  const RgbImage& frame = painter.frame_at(2.0);
  // In words of a median over all pixels: most are plain areas, whose colours are there as they
  // are.
  const auto is_there = [&](const Rgb& color) {
    return std::any_of(palette.begin(), palette.end(), [&](const Rgb& other) {
      return std::abs(other.red - color.red) <= 2 && std::abs(other.green - color.green) <= 2 &&
             std::abs(other.blue - color.blue) <= 2;
    });
  };
  const auto there = std::count_if(frame.pixels().begin(), frame.pixels().end(), is_there);
  EXPECT_GT(static_cast<double>(there), 0.9 * static_cast<double>(frame.pixels().size()));
}

TEST(FilmPainter, ShowsWhatIsCalledDynamicAndWhoIsFollowed) {
  Course course = course_of_a_room();
  const auto picture = [](const Course& shown, double time) {
    FilmPainter painter(shown, 300, 1.0);
    RgbImage image;
    for (double t = 0.0; t <= time; t += 1.0) image = painter.frame_at(t);
    const int above_legend = image.height() - 60;
    image.pixels().resize(static_cast<std::size_t>(image.width()) *
                          static_cast<std::size_t>(above_legend));
    return image;
  };
  EXPECT_EQ(count_of(picture(course, 2.0), kDynamicColor), 0);
  ScanLabels labels{.static_probability = std::vector<float>(180, 1.0F)};
  labels.static_probability[45] = 0.0F;  // to the left
  course.labels[2] = labels;
  EXPECT_GT(count_of(picture(course, 2.0), kDynamicColor), 0);

  const Rgb color = track_color(4);
  EXPECT_EQ(count_of(picture(course, 2.0), color), 0);
  course.tracks = {
      {4, {{.time = 0.0, .position = {1.0, 1.0}}, {.time = 1.0, .position = {1.0, 1.0}}}}};
  EXPECT_GT(count_of(picture(course, 1.0), color), 20) << "a disc, its number";
  EXPECT_EQ(count_of(picture(course, 2.0), color), 0) << "no longer";
  EXPECT_EQ(count_of(picture(course_of_a_room(), 1.0), color), 0);
}

TEST(FilmPainter, SomebodyHiddenIsARingOfHowSurelyHeIsThere) {
  Course course = course_of_a_room();
  course.tracks = {{4, {{.time = 0.0, .position = {1.0, 1.0}, .occluded = true}}}};
  const auto extent = [&](double sigma) {
    course.tracks[0].states[0].covariance = sigma * sigma * Eigen::Matrix2d::Identity();
    FilmPainter painter(course, 600, 1.0);
    const RgbImage& image = painter.frame_at(0.0);
    int left = image.width(), right = 0;
    for (int y = 0; y < image.height() - 60; ++y) {
      for (int x = 0; x < image.width(); ++x) {
        if (image.at(x, y) != track_color(4)) continue;
        left = std::min(left, x);
        right = std::max(right, x);
      }
    }
    return right - left;
  };
  const double pixels_per_meter = 600 / 7.4;  // 6 m and the border
  EXPECT_NEAR(extent(0.5), 2 * 0.5 * pixels_per_meter, 6.0);
  EXPECT_NEAR(extent(1.0), 2 * 1.0 * pixels_per_meter, 6.0);
}

class FilmFile : public ::testing::Test {
 protected:
  FilmMade made(const std::string& name) const {
    const FilmOptions options{.rate = 5.0, .to = 2.0, .longest_side = 100};
    return write_film(course_of_a_room(), options, folder_.file(name), [](auto, auto) {}, {});
  }
  TemporaryFolder folder_;
};

TEST_F(FilmFile, HasAFrameForEachMomentAndAnEndThatStays) {
  for (const char* name : {"a.gif", "a.webp"}) {
    const FilmMade film = made(name);
    EXPECT_EQ(film.frames, 11 + 10) << "two seconds and the first moment, and two seconds of rest";
    EXPECT_DOUBLE_EQ(film.seconds, 21 / 5.0);
    EXPECT_TRUE(is_film_of_ours(folder_.file(name)));
  }
  EXPECT_EQ(folder_.files(), 2u) << "nothing else is left";
}

TEST_F(FilmFile, IsTheSameToTheByteAgain) {
  for (const std::string ending : {".gif", ".webp"}) {
    made("a" + ending);
    made("b" + ending);
    EXPECT_EQ(read_text_file(folder_.file("a" + ending)),
              read_text_file(folder_.file("b" + ending)));
  }
}

TEST_F(FilmFile, IsAnMp4ThatOthersRead) {
  if (program_in_path("ffmpeg").empty()) GTEST_SKIP() << "ffmpeg is not installed";
  const FilmMade film = made("a.mp4");
  EXPECT_TRUE(is_film_of_ours(folder_.file("a.mp4")));
  const std::string command = fmt::format(
      "ffprobe -v error -count_frames -select_streams v -show_entries "
      "stream=width,height,nb_read_frames -of csv=p=0 '{}' >'{}' 2>&1",
      folder_.file("a.mp4"), folder_.file("said"));
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(read_text_file(folder_.file("said")),
            fmt::format("{},{},{}\n", film.width, film.height, film.frames));
}

TEST_F(FilmFile, IsNotThereWhereItWasInterrupted) {
  for (const char* name : {"a.gif", "a.webp", "a.mp4"}) {
    if (name == std::string("a.mp4") && program_in_path("ffmpeg").empty()) continue;
    int frames = 0;
    const FilmOptions options{.rate = 5.0, .to = 2.0, .longest_side = 100};
    EXPECT_THROW(write_film(
                     course_of_a_room(), options, folder_.file(name), [](auto, auto) {},
                     [&] { return ++frames < 4; }),
                 Interrupted);
    EXPECT_EQ(folder_.files(), 0u) << name;
  }
}

}  // namespace
}  // namespace mapbed
