#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <vector>

#include "algorithms/submaps/submap.h"

namespace mapbed {

// The fields of the local maps that were asked for last, so that memory is bounded however long the
// path is.
class SubmapFields {
 public:
  // For matches within windows of up to `window` [m].
  SubmapFields(const SubmapOptions& options, double window) : options_(options), window_(window) {}

  // `number` names the local map from now on.
  std::shared_ptr<const SubmapField> of(const Submap& submap, int number);

 private:
  static constexpr std::size_t kKept = 24;
  struct Entry {
    int number = 0;
    std::shared_ptr<const SubmapField> field;
  };
  SubmapOptions options_;
  double window_;
  std::deque<Entry> entries_;  // the last one asked for is the first
};

}  // namespace mapbed
