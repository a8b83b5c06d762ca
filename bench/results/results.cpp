#include "bench/results/results.h"

namespace mapbed {

std::string level_text(const Results& results, int level) {
  const Level& at = results.levels[static_cast<std::size_t>(level)];
  std::string text;
  for (std::size_t axis = 0; axis < results.axes.size(); ++axis) {
    const std::string& path = results.axes[axis].path;
    text += (text.empty() ? "" : ", ") + path.substr(path.rfind('.') + 1) + " = " +
            results.axes[axis].texts[static_cast<std::size_t>(at.choice[axis])];
  }
  return text.empty() ? "all" : text;
}

}  // namespace mapbed
