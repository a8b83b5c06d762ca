# Compiles through ccache where it is installed, so that an unchanged source is compiled once for all
# clones: paths are hashed as seen from the source tree, and precompiled headers by their content.
# What a source includes is known from the compiler's list (depend mode), so that a source that is
# compiled for the first time is not preprocessed once more before.
# Its folder is ccache's own, ~/.cache/ccache, or what CCACHE_DIR says.
find_program(MAPBED_CCACHE ccache DOC "The compiler cache; OFF to compile without one")
if(MAPBED_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
    /usr/bin/env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
    ${MAPBED_CCACHE})
endif()
