#pragma once

#include <string>
#include <vector>

namespace mapbed {

// What is written into a folder takes the place of what mapbed has written there before, and of
// nothing else. Throws InputError, before the work, where one of `coming`, paths below the folder,
// is there and not one of `ours`.
void refuse_foreign(const std::string& folder, const std::vector<std::string>& coming,
                    const std::vector<std::string>& ours);

// The same of a file that is known to be somebody else's.
[[noreturn]] void refuse_foreign(const std::string& path);

// What is written beside an output, or into a folder that is called after it, belongs to the output
// that it was written for: `path` holds what is `held` ("the map") of `log`. `detail` follows.
[[noreturn]] void refuse_of_another_log(const std::string& path, const std::string& held,
                                        const std::string& log, const std::string& detail,
                                        const std::string& remedy);

}  // namespace mapbed
