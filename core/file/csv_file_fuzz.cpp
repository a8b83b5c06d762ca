// Whatever the bytes: rows of equal length that read back from what is written of them, or an
// InputError.

#include "core/check.h"
#include "core/file/csv_file.h"
#include "core/input_error.h"
#include "core/testing/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace mapbed;
  std::vector<CsvRow> rows;
  try {
    rows = parse_csv("fuzz", fuzz_text(data, size));
  } catch (const InputError&) {
    return 0;
  }
  for (const CsvRow& row : rows) {
    CHECK(row.size() == rows.front().size());
    for (const std::string& field : row) (void)parse_csv_number(field);
  }
  CHECK(parse_csv("again", csv_text(rows)) == rows);
  return 0;
}
