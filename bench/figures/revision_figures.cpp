#include "bench/figures/revision_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "algorithms/scan/level_lasers.h"
#include "bench/plot/map_picture.h"
#include "bench/results/association_file.h"
#include "core/image/png.h"

namespace mapbed {
namespace {

double finite_or_gap(double value) {
  return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
}

// The scans that methods in the plane take in, as many as the path has poses.
std::vector<LaserScan> scans_of_path(const SensorLog& log, const Trajectory& path) {
  LevelLasers lasers;
  std::vector<LaserScan> scans;
  for (const Measurement& measurement : log) {
    const auto* scan = std::get_if<LaserScan>(&measurement);
    if (scan == nullptr || scans.size() == path.size()) continue;
    if (lasers.take(*scan)) scans.push_back(*scan);
  }
  return scans;
}

std::string png_of_map(const SensorLog& log, const Trajectory& path, const MapOptions& options) {
  return png_of(picture_of(build_map(scans_of_path(log, path), path, options),
                           {{"estimated path", path}}, {.longest_side = 1000}));
}

}  // namespace

Plot likelihood_plot(const AssociationTree& tree, const std::string& label) {
  const double start = tree.local_maps.empty() ? 0.0 : tree.local_maps.front().from;
  PlotSeries then{.name = "decisions of that moment", .mark = Mark::path, .like = 1};
  for (const AssociationTree::Choice& choice : tree.choices) {
    then.x.push_back(choice.time - start);
    then.y.push_back(finite_or_gap(choice.newest));
  }
  PlotSeries in_the_end{.name = "decisions chosen in the end", .like = 0};
  for (const std::size_t node : path_to(tree, tree.chosen)) {
    const auto local_map = static_cast<std::size_t>(tree.nodes[node].local_map);
    in_the_end.x.push_back(tree.local_maps[local_map].to - start);
    in_the_end.y.push_back(finite_or_gap(tree.nodes[node].newest));
  }
  Plot plot{.title = "What each local map saw, given those before it",
            .subtitle = label,
            .x = {"time", "s"},
            .y = {"log-likelihood", ""}};
  for (PlotSeries* series : {&in_the_end, &then}) {
    if (!series->x.empty()) plot.series.push_back(std::move(*series));
  }
  return plot;
}

std::optional<AssociationTree::Revision> largest_revision(const AssociationTree& tree) {
  const auto size_of = [](const AssociationTree::Revision& revision) {
    return std::tuple(revision.changed,
                      revision.log_likelihood_after - revision.log_likelihood_before);
  };
  const auto largest =
      std::max_element(tree.revisions.begin(), tree.revisions.end(),
                       [&](const auto& a, const auto& b) { return size_of(a) < size_of(b); });
  if (largest == tree.revisions.end()) return {};
  return *largest;
}

std::vector<std::pair<std::string, std::string>> revision_maps(const AssociationTree& tree,
                                                               const SensorLog& log,
                                                               const MapOptions& options) {
  const std::optional<AssociationTree::Revision> revision = largest_revision(tree);
  if (!revision || revision->path_before.empty()) return {};
  return {{kRevisionMaps[0], png_of_map(log, revision->path_before, options)},
          {kRevisionMaps[1], png_of_map(log, revision->path_after, options)}};
}

}  // namespace mapbed
