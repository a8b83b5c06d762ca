#include "algorithms/rfid/simplex_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mapbed {
namespace {

struct Corner {
  std::vector<double> at;
  double value = 0.0;
};

class Simplex {
 public:
  Simplex(const std::function<double(const std::vector<double>&)>& function,
          const std::vector<double>& start, const std::vector<double>& step)
      : function_(function) {
    corners_.push_back(corner(start));
    for (std::size_t i = 0; i < start.size(); ++i) {
      std::vector<double> moved = start;
      moved[i] += step[i];
      corners_.push_back(corner(moved));
    }
    sort();
  }

  const Corner& best() const { return corners_.front(); }
  int evaluations() const { return evaluations_; }
  bool is_flat(double tolerance) const {
    const double low = corners_.front().value, high = corners_.back().value;
    return high - low <= tolerance * (std::abs(low) + std::abs(high) + 1e-300);
  }

  void step() {
    Corner& worst = corners_.back();
    const double second_worst = corners_[corners_.size() - 2].value;
    const Corner reflected = from_centre(-1.0);
    if (reflected.value < best().value) {
      const Corner expanded = from_centre(-2.0);
      worst = expanded.value < reflected.value ? expanded : reflected;
    } else if (reflected.value < second_worst) {
      worst = reflected;
    } else {
      const Corner contracted = from_centre(reflected.value < worst.value ? -0.5 : 0.5);
      if (contracted.value < std::min(reflected.value, worst.value)) {
        worst = contracted;
      } else {
        shrink();
      }
    }
    sort();
  }

 private:
  Corner corner(std::vector<double> at) {
    ++evaluations_;
    const double value = function_(at);
    return {std::move(at), std::isnan(value) ? std::numeric_limits<double>::infinity() : value};
  }

  // On the line from the centre of all corners but the worst to that one, `factor` of the way.
  Corner from_centre(double factor) {
    const std::size_t others = corners_.size() - 1;
    std::vector<double> at(corners_.front().at.size(), 0.0);
    for (std::size_t d = 0; d < at.size(); ++d) {
      for (std::size_t i = 0; i < others; ++i) at[d] += corners_[i].at[d];
      at[d] /= static_cast<double>(others);
      at[d] += factor * (corners_.back().at[d] - at[d]);
    }
    return corner(std::move(at));
  }

  void shrink() {
    const std::vector<double> to = best().at;
    for (std::size_t i = 1; i < corners_.size(); ++i) {
      std::vector<double> at = corners_[i].at;
      for (std::size_t d = 0; d < at.size(); ++d) at[d] = to[d] + 0.5 * (at[d] - to[d]);
      corners_[i] = corner(std::move(at));
    }
  }

  void sort() {
    std::stable_sort(corners_.begin(), corners_.end(),
                     [](const Corner& a, const Corner& b) { return a.value < b.value; });
  }

  const std::function<double(const std::vector<double>&)>& function_;
  std::vector<Corner> corners_;
  int evaluations_ = 0;
};

}  // namespace

std::vector<double> minimized(const std::function<double(const std::vector<double>&)>& function,
                              std::vector<double> start, const std::vector<double>& step,
                              const SimplexOptions& options) {
  for (int run = 0; run <= options.restarts; ++run) {
    Simplex simplex(function, start, step);
    while (!simplex.is_flat(options.tolerance) && simplex.evaluations() < options.max_evaluations) {
      simplex.step();
    }
    start = simplex.best().at;
  }
  return start;
}

}  // namespace mapbed
