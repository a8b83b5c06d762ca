#include "bench/results/plot_spec.h"

#include <gmock/gmock.h>

#include "bench/results/results.h"
#include "core/testing/throws_input_error.h"

namespace mapbed {
namespace {

// Hits and misses are swept, two models compared.
Results cells() {
  Results plan;
  plan.axes = {{"hits", {"0", "1"}, {0, 1}, ""}, {"world", {"a", "b"}, {}, ""}};
  plan.variants = {"counting", "odds"};
  plan.metrics = {{"distance", Unit::meter, ""}};
  return plan;
}

PlotSpec read(const std::string& yaml) {
  return plot_of(parse_config(yaml, {"x.yaml", 7}));
}

TEST(PlotSpec, IsWrittenAsItIsRead) {
  for (const char* yaml : {"{y: distance}", "{y: distance, interval: binomial}",
                           "{x: hits, y: distance, log_y: true, variants: [odds]}",
                           "{x: hits, y: distance, title: 'a, b: c', references: {'of 2009': 2 m}}",
                           "{kind: heat_map, x: hits, y: misses, value: distance, file: map}",
                           "{y: distance, at: {hits: 1, world: [a, b]}}",
                           "{kind: matrix, y: fault, value: distance, mark: told, log_value: true, "
                           "value_range: [1 m, 2 m]}",
                           "{kind: matrix, file: all, rows: [distance, told], value_label: V}",
                           "{kind: series, y: residual, log_y: true, at: {hits: 1}}"}) {
    const std::string text = plot_text(read(yaml));
    EXPECT_EQ(plot_text(read(text)), text);
  }
  const std::string everything =
      "{file: m, title: T, kind: heat_map, x: hits, y: misses, value: distance, lines_by: world, "
      "variants: [odds], at: {world: [a]}, references: {p: 2 m}, interval: binomial, log_x: true, "
      "log_y: false, "
      "x_label: X, y_label: Y, value_label: V, thesis: F}";
  EXPECT_EQ(plot_text(read(everything)), everything);
  const PlotSpec matrix = read(plot_text(read("{kind: matrix, file: f, rows: [a, 'b c']}")));
  EXPECT_THAT(matrix.rows, ::testing::ElementsAre("a", "b c"));
  const PlotSpec plot = read(plot_text(read("{y: distance, references: {'of 2009': 2 m}}")));
  ASSERT_EQ(plot.references.size(), 1u);
  EXPECT_EQ(plot.references[0].name, "of 2009");
  EXPECT_EQ(plot.references[0].value, "2 m");
}

TEST(PlotSpec, NamesOnlyWhatTheScenarioHas) {
  const auto check = [](const std::string& yaml) { check_plot(read(yaml), cells()); };
  check("{x: hits, y: distance, references: {published: 20 cm}}");
  EXPECT_INPUT_ERROR(check("{x: hitz, y: distance}"), "x.yaml:7: the plot 'distance' shows 'hitz'");
  EXPECT_INPUT_ERROR(check("{x: hits, y: distence}"), "did you mean 'distance'?");
  EXPECT_INPUT_ERROR(check("{y: distance, variants: [odd]}"), "did you mean 'odds'?");
  EXPECT_INPUT_ERROR(check("{y: distance, references: {published: 20 deg}}"), "x.yaml:7");
  EXPECT_INPUT_ERROR(check("{y: distance, at: {hits: 2}}"), "no value of 'hits'");
  EXPECT_INPUT_ERROR(check("{y: distance, at: {hit: 1}}"), "did you mean 'hits'?");
  EXPECT_INPUT_ERROR(read("{y: distance, file: a/b}"), "is not a name for a picture");
}

TEST(PlotSpec, HasAFileOfItsOwn) {
  Results plan = cells();
  plan.plots = {read("{y: distance}"), read("{x: hits, y: distance}")};
  EXPECT_INPUT_ERROR(check_plot(plan.plots[0], plan),
                     "x.yaml:7: two plots have the name 'distance'; give one of them another name, "
                     "as in 'file: distance_2'");
  plan.plots[1].file = "distance_2";
  EXPECT_NO_THROW(check_plot(plan.plots[0], plan));
  EXPECT_INPUT_ERROR(read("{y: distance, file: ''}"), "is not a name for a picture");
}

TEST(PlotSpec, OfAHeatMapHasTwoAxesOfNumbersAndOneVariant) {
  const auto check = [](const std::string& yaml, const Results& plan) {
    check_plot(read(yaml), plan);
  };
  Results plan = cells();
  const std::string head = "{kind: heat_map, value: distance, x: hits, ";
  EXPECT_INPUT_ERROR(check(head + "y: world, variants: [odds]}", plan),
                     "the values of 'world' are not all numbers of one unit");
  plan.axes[1] = {"misses", {"0", "2"}, {0, 2}, ""};
  check(head + "y: misses, variants: [odds]}", plan);
  EXPECT_INPUT_ERROR(check(head + "y: misses}", plan), "it shows one variant");
  EXPECT_INPUT_ERROR(check(head + "y: hits, variants: [odds]}", plan), "over two axes");
  EXPECT_INPUT_ERROR(read("{kind: heat_map, x: hits, y: misses}"), "value");
}

TEST(PlotSpec, OfAMatrixHasOneValueForEachRowAndColumn) {
  Results plan = cells();
  plan.metrics.push_back({"told", Unit::none, ""});
  const auto check = [&](const std::string& more) {
    check_plot(read("{kind: matrix, value: distance, y: world" + more + "}"), plan);
  };
  check(", x: hits, mark: told, value_range: [1 cm, 10 m]");
  check(", at: {hits: 1}");
  EXPECT_INPUT_ERROR(check(""), "has no one value for each place");
  EXPECT_INPUT_ERROR(check(", x: world"), "has no one value for each place");
  EXPECT_INPUT_ERROR(check(", x: hits, mark: tolled"), "did you mean 'told'?");
  EXPECT_INPUT_ERROR(check(", x: hits, value_range: [1 cm]"), "has no two ends");
  EXPECT_INPUT_ERROR(check(", x: hits, value_range: [1 s, 2 s]"), "is not a length");
  EXPECT_INPUT_ERROR(read("{kind: matrix, y: world}"), "value");
}

TEST(PlotSpec, OfAMatrixOfMetricsHasRowsOfOneUnitAtOneLevel) {
  Results plan = cells();
  plan.metrics.push_back({"told", Unit::none, ""});
  plan.metrics.push_back({"width", Unit::meter, ""});
  const auto check = [&](const std::string& rows, const std::string& more) {
    check_plot(read("{kind: matrix, file: all, rows: " + rows + more + "}"), plan);
  };
  const std::string one_level = ", at: {hits: 1, world: a}";
  check("[distance, width]", one_level);
  EXPECT_INPUT_ERROR(check("[distance, width]", ""), "has no one value for each place");
  EXPECT_INPUT_ERROR(check("[distance, widht]", one_level), "did you mean 'width'?");
  EXPECT_INPUT_ERROR(check("[distance, told]", one_level), "have several units");
  EXPECT_INPUT_ERROR(read("{kind: matrix, rows: [distance]}"), "'' is not a name for a picture");
}

TEST(PlotSpec, OfASeriesKnowsWhatItGoesOver) {
  Results plan = cells();
  plan.series_metrics = {{"residual", Unit::meter, "iteration", Unit::none, ""}};
  const auto check = [&](const std::string& yaml) { check_plot(read(yaml), plan); };
  check("{kind: series, y: residual, references: {aim: 1 cm}}");
  check("{kind: series, x: iteration, y: residual}");
  EXPECT_INPUT_ERROR(check("{kind: series, y: residuum}"), "did you mean 'residual'?");
  EXPECT_INPUT_ERROR(check("{kind: series, y: distance}"), "not a series of this scenario");
  EXPECT_INPUT_ERROR(check("{kind: series, x: hits, y: residual}"), "not what the series goes");
  EXPECT_INPUT_ERROR(check("{kind: series, y: residual, references: {aim: 1 s}}"),
                     "is not a length");
}

}  // namespace
}  // namespace mapbed
