#pragma once

#include <string>
#include <vector>

#include "algorithms/remark.h"

namespace mapbed {

inline std::vector<std::string> texts_of(const std::vector<Remark>& remarks) {
  std::vector<std::string> texts;
  for (const Remark& remark : remarks) texts.push_back(remark.text);
  return texts;
}

}  // namespace mapbed
