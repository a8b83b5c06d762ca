#include <numeric>

#include <fmt/format.h>

#include "algorithms/pose_graph/graph_file.h"
#include "algorithms/pose_graph/graph_lines.h"
#include "core/file/text_file.h"

namespace mapbed {
namespace {

template <class Pose>
std::string text_of(const PoseGraph<Pose>& graph, const std::vector<std::int64_t>& ids,
                    GraphFormat format) {
  const GraphKind vertex{.is_in_space = kDegreesOfFreedom<Pose> == 6,
                         .is_toro = format == GraphFormat::toro};
  GraphKind edge = vertex;
  edge.is_edge = true;
  const auto id_of = [&](int node) { return ids[static_cast<std::size_t>(node)]; };
  std::string text;
  for (std::size_t node = 0; node < graph.nodes.size(); ++node) {
    text += fmt::format("{} {}{}\n", graph_tag(vertex), ids[node],
                        pose_words(vertex, graph.nodes[node]));
  }
  for (const int node : graph.held) text += fmt::format("FIX {}\n", id_of(node));
  for (const PoseConstraint<Pose>& constraint : graph.constraints) {
    text += fmt::format("{} {} {}{}{}\n", graph_tag(edge), id_of(constraint.from),
                        id_of(constraint.to), pose_words(edge, constraint.from_from_to),
                        information_words<Pose>(edge, constraint.information));
  }
  return text;
}

}  // namespace

std::string graph_text(const AnyPoseGraph& graph, const std::vector<std::int64_t>& ids,
                       GraphFormat format) {
  return std::visit([&](const auto& g) { return text_of(g, ids, format); }, graph);
}

std::string graph_text(const PoseGraph<Pose2>& graph) {
  std::vector<std::int64_t> ids(graph.nodes.size());
  std::iota(ids.begin(), ids.end(), 0);
  return graph_text(graph, ids);
}

GraphFormat format_for(std::string_view path) {
  if (path.ends_with(".gz")) path.remove_suffix(3);
  return path.ends_with(".toro") || path.ends_with(".graph") ? GraphFormat::toro : GraphFormat::g2o;
}

void write_graph(const std::string& path, const AnyPoseGraph& graph,
                 const std::vector<std::int64_t>& ids) {
  write_text_file(path, graph_text(graph, ids, format_for(path)));
}

}  // namespace mapbed
