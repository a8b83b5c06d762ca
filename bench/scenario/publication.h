#pragma once

#include <string>

#include "bench/results/results.h"

// How a finished result takes the place of the older one of its folder, as a whole: what comes is
// made below .publication/ and synced to the disk, and then listed there, with what goes. Up to
// that list the older result stands as it was. From it on the new one takes its place, whatever
// stops the program on the way: the next one in the folder goes on. In between there is no
// config.yaml, so that nobody takes a part of each for a result. What no result lists stays.

namespace mapbed {

// `staging`, below the folder, has the files that the results list below files/, and goes in the
// end; empty: they are in place already, and what is as written is not touched. The folder is
// locked. Throws InputError where it cannot be written.
void publish(const std::string& folder, const Results& results, const std::string& staging = "");

// Ends what a program that was killed has begun. The folder is locked.
void finish_publication(const std::string& folder);

// Whether there is such a thing.
bool is_being_published(const std::string& folder);

}  // namespace mapbed
