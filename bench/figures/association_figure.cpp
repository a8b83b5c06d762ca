#include "bench/figures/association_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "bench/results/association_file.h"

namespace mapbed {
namespace {

constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
constexpr double kLeastDepth = 20.0;  // below the chosen decisions, that is shown in any case

// Log-likelihoods over local maps, less those of the decisions chosen in the end.
class Heights {
 public:
  explicit Heights(const AssociationTree& tree) : tree_(tree) {
    for (const std::size_t node : path_to(tree, tree.chosen)) {
      chosen_[tree.nodes[node].local_map] = tree.nodes[node].log_likelihood;
    }
  }

  double of(double log_likelihood, int local_map) const {
    const auto chosen = chosen_.find(local_map);
    return chosen == chosen_.end() ? kGap : log_likelihood - chosen->second;
  }
  double of(std::size_t node) const {
    return of(tree_.nodes[node].log_likelihood, tree_.nodes[node].local_map);
  }

 private:
  const AssociationTree& tree_;
  std::map<int, double> chosen_;
};

void add_point(double x, double y, PlotSeries& series) {
  series.x.push_back(x);
  series.y.push_back(std::isfinite(y) ? y : kGap);
}

// From a node's parent to it.
void add_branch(const AssociationTree& tree, const Heights& heights, std::size_t node,
                PlotSeries& series) {
  const int parent = tree.nodes[node].parent;
  if (parent >= 0) {
    const auto from = static_cast<std::size_t>(parent);
    add_point(tree.nodes[from].local_map, heights.of(from), series);
  }
  add_point(tree.nodes[node].local_map, heights.of(node), series);
  add_point(kGap, kGap, series);
}

// Those of the leaves that were chosen for a while, without what is chosen still.
std::set<std::size_t> nodes_taken_back(const AssociationTree& tree,
                                       const std::set<std::size_t>& chosen) {
  std::set<std::size_t> taken_back;
  const auto add = [&](std::size_t leaf) {
    for (const std::size_t node : path_to(tree, leaf)) {
      if (!chosen.contains(node)) taken_back.insert(node);
    }
  };
  for (const AssociationTree::Choice& choice : tree.choices) add(choice.node);
  for (const AssociationTree::Revision& revision : tree.revisions) {
    add(revision.before);
    add(revision.after);
  }
  return taken_back;
}

double lowest_of(const std::vector<const PlotSeries*>& series) {
  double lowest = -kLeastDepth;
  for (const PlotSeries* one : series) {
    for (const double y : one->y) {
      if (std::isfinite(y)) lowest = std::min(lowest, y);
    }
  }
  return lowest;
}

std::string counted(std::size_t number, const std::string& one, const std::string& many) {
  return fmt::format("{} {}", number, number == 1 ? one : many);
}

std::string title_of(const AssociationTree& tree) {
  int changed = 0;
  for (const AssociationTree::Revision& revision : tree.revisions) changed += revision.changed;
  const std::string maps = counted(tree.local_maps.size(), "local map", "local maps");
  if (changed == 0) return "Data associations of " + maps + ", none taken back";
  return fmt::format("Data associations of {}: {} taken back in {}", maps,
                     counted(static_cast<std::size_t>(changed), "decision", "decisions"),
                     counted(tree.revisions.size(), "revision", "revisions"));
}

}  // namespace

Plot association_plot(const AssociationTree& tree, const std::string& label) {
  const Heights heights(tree);
  const std::vector<std::size_t> path = path_to(tree, tree.chosen);
  const std::set<std::size_t> on_path(path.begin(), path.end());
  const std::set<std::size_t> taken_back = nodes_taken_back(tree, on_path);

  PlotSeries chosen{.name = "chosen in the end", .like = 0};
  for (const std::size_t node : path) {
    add_point(tree.nodes[node].local_map, heights.of(node), chosen);
  }
  PlotSeries left{.name = "taken back", .mark = Mark::path, .like = 1};
  for (const std::size_t node : taken_back) add_branch(tree, heights, node, left);
  PlotSeries before{.name = "before a revision", .mark = Mark::points, .like = 1};
  PlotSeries after{.name = "after it", .mark = Mark::points, .like = 2};
  for (const AssociationTree::Revision& revision : tree.revisions) {
    const auto height = [&](double value) { return heights.of(value, revision.at); };
    add_point(revision.at, height(revision.log_likelihood_before), before);
    add_point(revision.at, height(revision.log_likelihood_after), after);
  }
  const double low = lowest_of({&left, &before, &after});
  PlotSeries others{.name = "looked at", .mark = Mark::path, .like = 5};
  for (std::size_t node = 0; node < tree.nodes.size(); ++node) {
    if (on_path.contains(node) || taken_back.contains(node)) continue;
    if (heights.of(node) >= low) add_branch(tree, heights, node, others);
  }

  Plot plot{.title = title_of(tree),
            .subtitle = (label.empty() ? "" : label + "; ") +
                        "up to each local map; alternatives far below are left out",
            .x = {"number of the local map", ""},
            .y = {"log-likelihood less the chosen one's", ""}};
  for (PlotSeries* series : {&others, &chosen, &left, &before, &after}) {
    if (!series->x.empty()) plot.series.push_back(std::move(*series));
  }
  return plot;
}

}  // namespace mapbed
