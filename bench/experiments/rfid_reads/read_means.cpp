#include "bench/experiments/rfid_reads/read_means.h"

#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "core/statistics/moments.h"

namespace mapbed {

std::vector<StrengthCell> strength_cells(const PlacedReads& reads, int port) {
  std::map<std::tuple<int, int, int>, Moments> moments;
  for (const PlacedRead& read : reads.reads) {
    moments[{read.antenna, read.place, read.tag}].add(
        read.strength[static_cast<std::size_t>(port - 1)]);
  }
  std::vector<StrengthCell> cells;
  for (const auto& [key, of_cell] : moments) {
    const auto [antenna, place, tag] = key;
    const auto count = static_cast<double>(of_cell.count());
    cells.push_back({{antenna, tag, reads.places[static_cast<std::size_t>(place)], of_cell.mean()},
                     place,
                     count,
                     count * of_cell.variance()});
  }
  return cells;
}

double noise_of(const PlacedReads& reads, int port) {
  std::map<std::tuple<int, int, int, double>, Moments> moments;
  for (const PlacedRead& read : reads.reads) {
    moments[{read.antenna, read.place, read.tag, read.frequency.value_or(0.0)}].add(
        read.strength[static_cast<std::size_t>(port - 1)]);
  }
  double squares = 0.0, freedoms = 0.0;
  for (const auto& [key, of_cell] : moments) {
    squares += static_cast<double>(of_cell.count()) * of_cell.variance();
    freedoms += static_cast<double>(of_cell.count() - 1);
  }
  return std::sqrt(squares / freedoms);
}

double spread_beside_places(const std::vector<StrengthCell>& cells) {
  // Least squares by turns: the places' numbers given the tags', and these given those.
  std::map<std::pair<int, int>, double> of_place;
  std::map<int, double> of_tag;
  double mean_square = 0.0;
  for (int round = 0; round < 50; ++round) {
    std::map<std::pair<int, int>, Moments> places;
    for (const StrengthCell& cell : cells) {
      places[{cell.reading.antenna, cell.place}].add(cell.reading.strength -
                                                     of_tag[cell.reading.tag]);
    }
    for (const auto& [key, moments] : places) of_place[key] = moments.mean();
    std::map<int, Moments> tags;
    for (const StrengthCell& cell : cells) {
      tags[cell.reading.tag].add(cell.reading.strength -
                                 of_place[{cell.reading.antenna, cell.place}]);
    }
    for (const auto& [key, moments] : tags) of_tag[key] = moments.mean();
    Moments left;
    for (const StrengthCell& cell : cells) {
      const double off = cell.reading.strength - of_tag[cell.reading.tag] -
                         of_place[{cell.reading.antenna, cell.place}];
      left.add(off * off);
    }
    mean_square = left.mean();
  }
  return std::sqrt(mean_square);
}

}  // namespace mapbed
