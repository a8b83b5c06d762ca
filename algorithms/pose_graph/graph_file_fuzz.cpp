// Whatever the bytes: a graph that is sound and reads back from what is written of it, or an
// InputError.

#include "algorithms/pose_graph/graph_file.h"
#include "core/check.h"
#include "core/input_error.h"
#include "core/testing/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mapbed;
  GraphFile file;
  try {
    file = parse_graph("fuzz", fuzz_text(data, size));
  } catch (const InputError&) {
    return 0;
  }
  std::visit(
      [&](const auto& graph) {
        CHECK(graph.nodes.size() == file.ids.size());
        for (const auto& node : graph.nodes) CHECK(is_finite(node));
        for (const auto& constraint : graph.constraints) {
          CHECK(constraint.from != constraint.to);
          for (const int node : {constraint.from, constraint.to}) {
            CHECK(node >= 0 && static_cast<std::size_t>(node) < graph.nodes.size());
          }
          CHECK(constraint.information.allFinite());
        }
        const std::string text = graph_text(file.graph, file.ids);
        const GraphFile again = parse_graph("again", text);
        CHECK(graph_text(again.graph, again.ids) == text);
      },
      file.graph);
  return 0;
}
