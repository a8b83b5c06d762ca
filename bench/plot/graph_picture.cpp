#include "bench/plot/graph_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "bench/plot/plot_frame.h"
#include "bench/plot/svg_text.h"
#include "core/geometry/angle.h"

namespace mapbed {
namespace {

constexpr double kEdge = 10.0;  // [px] left and right of panels, and between them
constexpr double kTitle = 12.0;
constexpr double kBar = 26.0;  // [px] below a panel, for its scale bar
constexpr double kMostHeight = 420.0;

// Of Okabe and Ito: blue, orange, vermilion.
enum Kind : int { odometry, closure, switched_off };
struct Style {
  const char* name;
  const char* pen;
};
constexpr std::array<Style, 3> kStyles = {
    {{"odometry", "stroke=\"#0072b2\" stroke-width=\"0.9\""},
     {"loop closures", "stroke=\"#e69f00\" stroke-width=\"0.6\" stroke-opacity=\"0.85\""},
     {"switched off", "stroke=\"#d55e00\" stroke-width=\"0.9\" stroke-dasharray=\"3 1.5\""}}};

Eigen::Vector2d seen(const Pose2& pose) {
  return {pose.x, pose.y};
}
// From 30 degrees above, from the side of -y and a little of x.
Eigen::Vector2d seen(const Pose3& pose) {
  static const double turn = radians(25.0);
  static const double tilt = radians(30.0);
  const Eigen::Vector3d& p = pose.position;
  const double right = std::cos(turn) * p.x() + std::sin(turn) * p.y();
  const double away = -std::sin(turn) * p.x() + std::cos(turn) * p.y();
  return {right, std::sin(tilt) * away + std::cos(tilt) * p.z()};
}

struct Edge {
  int from = 0, to = 0;
  Kind kind = odometry;
};

struct FlatGraph {
  std::vector<Eigen::Vector2d> nodes;
  std::vector<Edge> edges;
  Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();
};

FlatGraph flat(const GraphPanel& panel) {
  FlatGraph result;
  std::visit(
      [&](const auto& graph) {
        for (const auto& node : graph.nodes) result.nodes.push_back(seen(node));
        for (std::size_t i = 0; i < graph.constraints.size(); ++i) {
          const auto& c = graph.constraints[i];
          const bool is_off = !panel.weights.empty() && panel.weights[i] < 0.5;
          result.edges.push_back({c.from, c.to,
                                  is_off          ? switched_off
                                  : c.closes_loop ? closure
                                                  : odometry});
        }
      },
      panel.graph);
  if (result.nodes.empty()) return result;
  result.low = result.high = result.nodes.front();
  for (const Eigen::Vector2d& node : result.nodes) {
    result.low = result.low.cwiseMin(node);
    result.high = result.high.cwiseMax(node);
  }
  return result;
}

struct Area {
  double left = 0.0, top = 0.0, width = 0.0, height = 0.0;  // [px]
  double scale = 1.0;                                       // [px/m]
  Eigen::Vector2d middle;                                   // [m]

  Eigen::Vector2d at(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d off = scale * (point - middle);
    return {left + 0.5 * width + off.x(), top + 0.5 * height - off.y()};
  }
};

// "M1 2L3 4L5 6": edges that follow each other are one line, and steps too short to be seen none.
std::string path_of(const FlatGraph& graph, const Area& area, Kind kind) {
  constexpr double kVisible = 0.4;  // [px]
  std::string path;
  int end = -1;
  Eigen::Vector2d drawn = Eigen::Vector2d::Zero();
  for (const Edge& edge : graph.edges) {
    if (edge.kind != kind) continue;
    const Eigen::Vector2d from = area.at(graph.nodes[static_cast<std::size_t>(edge.from)]);
    const Eigen::Vector2d to = area.at(graph.nodes[static_cast<std::size_t>(edge.to)]);
    const bool goes_on = edge.from == end;
    end = edge.to;
    if (!goes_on) {
      path += "M" + coordinate(from.x()) + " " + coordinate(from.y());
      drawn = from;
    }
    if (kind == odometry && (to - drawn).norm() < kVisible) continue;
    path += "L" + coordinate(to.x()) + " " + coordinate(to.y());
    drawn = to;
  }
  return path;
}

// 1, 2 or 5 times a power of ten, at most `longest`.
double round_length(double longest) {
  const double power = std::pow(10.0, std::floor(std::log10(longest)));
  for (const double times : {5.0, 2.0}) {
    if (times * power <= longest) return times * power;
  }
  return power;
}

std::string scale_bar(const Area& area) {
  const double length = round_length(0.3 * area.width / area.scale);
  const double right = area.left + area.scale * length;
  const double y = area.top + area.height + 14.0;
  const double ends[] = {area.left, right};
  std::string bar = fmt::format(
      "<path d=\"M{0} {1}V{2}M{0} {3}H{4}M{4} {1}V{2}\" fill=\"none\" "
      "stroke=\"#000\"/>\n",
      coordinate(ends[0]), coordinate(y - 3.0), coordinate(y + 3.0), coordinate(y),
      coordinate(ends[1]));
  return bar + svg_text(right + 6.0, y + 4.0, fmt::format("{:g} m", length), {11.0});
}

bool has_kind(const std::vector<FlatGraph>& graphs, Kind kind) {
  return std::any_of(graphs.begin(), graphs.end(), [&](const FlatGraph& graph) {
    return std::any_of(graph.edges.begin(), graph.edges.end(),
                       [&](const Edge& edge) { return edge.kind == kind; });
  });
}

}  // namespace

std::string graph_svg(const std::string& title, const std::string& subtitle,
                      const std::vector<GraphPanel>& panels) {
  std::vector<FlatGraph> graphs;
  for (const GraphPanel& panel : panels) graphs.push_back(flat(panel));
  FrameText text{.title = title, .subtitle = subtitle};
  for (const Kind kind : {odometry, closure, switched_off}) {
    if (!has_kind(graphs, kind)) continue;
    text.legend.push_back({kStyles[kind].name, fmt::format("<path d=\"M0 6H28\" fill=\"none\" {}/>",
                                                           kStyles[kind].pen)});
  }
  double top = 0.0;
  const std::string head = head_of(text, top);
  top += kTitle + 10.0;

  const auto count = static_cast<double>(std::max<std::size_t>(1, panels.size()));
  const double width = (kPlotWidth - (count + 1.0) * kEdge) / count;
  double height = 0.3 * width;  // as high as the highest of them needs
  for (const FlatGraph& graph : graphs) {
    const Eigen::Vector2d size = (graph.high - graph.low).cwiseMax(1e-9);
    height = std::max(height, std::min(kMostHeight, width * size.y() / size.x()));
  }
  std::string content = head;
  for (std::size_t i = 0; i < graphs.size(); ++i) {
    const FlatGraph& graph = graphs[i];
    const Eigen::Vector2d size = (graph.high - graph.low).cwiseMax(1e-9);
    Area area{.left = kEdge + static_cast<double>(i) * (width + kEdge),
              .top = top,
              .width = width,
              .height = height};
    area.scale = std::min(width / size.x(), height / size.y());
    area.middle = 0.5 * (graph.low + graph.high);
    content += svg_text(area.left, top - 8.0, panels[i].title,
                        {fitting_size(panels[i].title, kTitle, width)});
    for (const Kind kind : {closure, odometry, switched_off}) {
      const std::string path = path_of(graph, area, kind);
      if (path.empty()) continue;
      content += fmt::format("<path d=\"{}\" fill=\"none\" stroke-linejoin=\"round\" {}/>\n", path,
                             kStyles[kind].pen);
    }
    if (size.maxCoeff() > 1e-9) content += scale_bar(area);
  }
  return svg_file(top + height + kBar, title, content);
}

}  // namespace mapbed
