#pragma once

#include <string>

namespace mapbed {

// Makes the folder where it is missing and makes sure, before any work is done, that files can be
// written into it. Throws InputError.
void make_output_folder(const std::string& folder);

}  // namespace mapbed
