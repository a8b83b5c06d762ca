#include "core/statistics/chi_square.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "core/check.h"

namespace mapbed {
namespace {

struct Class {
  double observed = 0.0;
  double expected = 0.0;
};

std::vector<Class> classes_of(std::span<const double> observed, std::span<const double> expected,
                              double least) {
  std::vector<Class> classes;
  Class open;
  for (std::size_t i = 0; i < observed.size(); ++i) {
    open.observed += observed[i];
    open.expected += expected[i];
    if (open.expected < least) continue;
    classes.push_back(open);
    open = {};
  }
  if (classes.empty()) return {open};
  classes.back().observed += open.observed;  // what is left is too little for a class of its own
  classes.back().expected += open.expected;
  return classes;
}

}  // namespace

double chi_square_score(double value, int freedoms) {
  CHECK(freedoms > 0);
  const double variance = 2.0 / (9.0 * freedoms);
  return (std::cbrt(value / freedoms) - (1.0 - variance)) / std::sqrt(variance);
}

ChiSquare chi_square(std::span<const double> observed, std::span<const double> expected,
                     double least) {
  CHECK(observed.size() == expected.size() && least > 0.0);
  ChiSquare result;
  const std::vector<Class> classes = classes_of(observed, expected, least);
  result.classes = static_cast<int>(classes.size());
  for (const Class& c : classes) {
    result.observed += c.observed;
    result.expected += c.expected;
  }
  if (classes.size() < 2) return result;
  for (const Class& c : classes) {
    const double off = c.observed - c.expected;
    result.value += off * off / c.expected;
  }
  result.freedoms = result.classes - 1;
  result.score = chi_square_score(result.value, result.freedoms);
  return result;
}

}  // namespace mapbed
