#pragma once

#include <string>

#include "core/log/bags/bag_messages.h"

namespace mapbed {

// An MCAP file with chunks that are not packed, and its index.
std::string mcap_bytes(const BagToWrite& bag);

}  // namespace mapbed
