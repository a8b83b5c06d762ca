#include "core/config/option.h"

namespace mapbed::option_detail {

Collector::Collector(OptionList& list, std::string prefix)
    : list_(list), prefix_(std::move(prefix)) {}

void Collector::add(std::string_view name, OptionValue value, Unit unit, const Bounds& bounds,
                    std::string_view about) {
  list_.push_back(
      {prefix_ + std::string(name), std::move(value), unit, bounds, std::string(about)});
}

}  // namespace mapbed::option_detail
