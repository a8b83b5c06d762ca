# Writes OUTPUT from version_data.cpp.in; touches it only where something changed, so that building
# an unchanged tree compiles nothing. Run at build time with -D of SOURCE_DIR, OUTPUT, PROGRAM,
# COMPILER, BUILD, LIBRARY_VERSIONS ("Eigen3 3.4.0|fmt 9.1.0").

# An archive made by `git archive` has its revision in this file; elsewhere it holds the placeholder.
file(READ ${SOURCE_DIR}/bench/process/revision.txt REVISION)
string(STRIP "${REVISION}" REVISION)
if(REVISION MATCHES "Format")
  set(REVISION unknown)
  # Not a revision of some other repository that this tree was unpacked into.
  if(EXISTS ${SOURCE_DIR}/.git)
    execute_process(COMMAND git describe --always --abbrev=10 --dirty=-changed
      WORKING_DIRECTORY ${SOURCE_DIR} RESULT_VARIABLE status OUTPUT_VARIABLE described
      OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(status EQUAL 0)
      set(REVISION ${described})
    endif()
  endif()
endif()

string(REGEX REPLACE "([^ |]+) ([^|]+)" "{\"\\1\", \"\\2\"}" LIBRARIES "${LIBRARY_VERSIONS}")
string(REPLACE "|" ", " LIBRARIES "${LIBRARIES}")
configure_file(${SOURCE_DIR}/bench/process/version_data.cpp.in ${OUTPUT} @ONLY)
