#pragma once

#include <string>

#include "core/interrupted.h"

// The program curl, called once for a file. It is no library of ours: what speaks with the network
// is a process of its own, updated with the system, and only who fetches needs it.

namespace mapbed {

enum class TransferEnd {
  done,       // the file is there to its end, whatever it is
  not_there,  // nothing lies at that address
  no_ranges,  // the beginning cannot be left out: to be got from the start
  cut,        // the connection ended half-way
  failed,
};

struct Transfer {
  TransferEnd end = TransferEnd::failed;
  std::string reason;  // where it is not done: "the host was not found (no network?)"
};

// Adds to the file `part`, from its end on, what lies at the address. Throws InputError where there
// is no curl, and Interrupted where it shall not go on.
Transfer transfer(const std::string& address, const std::string& part, const GoesOn& goes_on);

// How an address is written that has the file `name`, with its folders, below `base`.
std::string address_below(const std::string& base, const std::string& name);

}  // namespace mapbed
