#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/truth/truth.h"

namespace mapbed {

// The contents of a truth file's blocks, see truth_file.h.

// Of moments with the same parts of the same things, one or more.
std::string bytes_of(std::span<const StampedStates> states);
// Of scans of one laser with as many beams each, one or more.
std::string bytes_of(std::span<const BeamTruthOfScan> scans);

// Of one or more reads.
std::string bytes_of(std::span<const TruthRead> reads);

// None where the bytes are damaged: too few or too many, or numbers that mean nothing. Entities,
// parts and materials are those of `header`.
std::optional<std::vector<StampedStates>> states_in(std::string_view bytes,
                                                    const TruthHeader& header);
std::optional<std::vector<BeamTruthOfScan>> beams_in(std::string_view bytes,
                                                     const TruthHeader& header);

std::optional<std::vector<TruthRead>> reads_in(std::string_view bytes, const TruthHeader& header);

}  // namespace mapbed
