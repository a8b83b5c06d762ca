# OpenCV's modules core and imgproc, each a package of its own in Debian. OpenCV's CMake package is
# not used: it comes with all modules, and with FFmpeg and the like behind them.
#
# Linked as archives: as shared libraries they bring LAPACK, Fortran and X11 along, 5 ms and 6 MB at
# every start of the program. What draws through OpenGL in them is never called; nor do they get it.
# What uses cv::MatExpr inside (filters, morphology, distance transforms, colour maps) needs LAPACK
# and BLAS; nothing here does yet, and whoever begins to adds them.
mapbed_headers(OpenCV opencv2/imgproc.hpp libopencv-imgproc-dev PATH_SUFFIXES opencv4)
foreach(module imgproc core)
  find_library(OpenCV_${module}_LIBRARY libopencv_${module}.a)
  if(NOT OpenCV_${module}_LIBRARY)
    message(FATAL_ERROR "libopencv_${module}.a not found; "
      "install it with: apt-get install libopencv-${module}-dev")
  endif()
  target_link_libraries(OpenCV::OpenCV INTERFACE ${OpenCV_${module}_LIBRARY})
endforeach()
target_link_libraries(OpenCV::OpenCV INTERFACE ZLIB::ZLIB TBB::tbb ${CMAKE_DL_LIBS})
foreach(symbol glXGetProcAddressARB glXGetCurrentDisplay glXGetCurrentContext)
  target_link_options(OpenCV::OpenCV INTERFACE LINKER:--defsym=${symbol}=0)
endforeach()

# For `mapbed --version`.
file(STRINGS ${OpenCV_INCLUDE_DIR}/opencv2/core/version.hpp opencv_version
  REGEX "^#define CV_VERSION_(MAJOR|MINOR|REVISION) ")
string(REGEX MATCHALL "[0-9]+" opencv_version "${opencv_version}")
list(JOIN opencv_version "." opencv_version)
set_property(GLOBAL APPEND PROPERTY mapbed_library_versions "OpenCV ${opencv_version}")
