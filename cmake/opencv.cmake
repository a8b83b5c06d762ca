# OpenCV's modules core and imgproc, each a package of its own in Debian. OpenCV's CMake package is
# not used: it comes with all modules, and with FFmpeg and the like behind them. Makes the target
# OpenCV::OpenCV for the headers; the libraries go by their names, opencv_imgproc and opencv_core.
mapbed_headers(OpenCV opencv2/imgproc.hpp libopencv-imgproc-dev PATH_SUFFIXES opencv4)
file(STRINGS ${OpenCV_INCLUDE_DIR}/opencv2/core/version.hpp opencv_version_lines
  REGEX "^#define CV_VERSION_(MAJOR|MINOR|REVISION) ")
string(REGEX MATCHALL "[0-9]+" opencv_version "${opencv_version_lines}")
list(JOIN opencv_version "." opencv_version)
set_property(GLOBAL APPEND PROPERTY mapbed_library_versions "OpenCV ${opencv_version}")
