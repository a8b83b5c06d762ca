#include "algorithms/submaps/submap_fields.h"

#include <algorithm>

namespace mapbed {

std::shared_ptr<const SubmapField> SubmapFields::of(const Submap& submap, int number) {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const Entry& entry) { return entry.number == number; });
  Entry entry;
  if (found != entries_.end()) {
    entry = *found;
    entries_.erase(found);
  } else {
    entry = {number, std::make_shared<const SubmapField>(make_field(submap, options_, window_))};
  }
  entries_.push_front(entry);
  if (entries_.size() > kKept) entries_.pop_back();
  return entry.field;
}

}  // namespace mapbed
