# Installs the build into a folder of its own, builds the program here against that, and runs it.
# Run with -D of BUILD_DIR, SOURCE_DIR (this folder), CXX.
set(place ${BUILD_DIR}/install_test)
file(REMOVE_RECURSE ${place})

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "failed: ${command}\n${output}")
  endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${place}/prefix)
run(${CMAKE_COMMAND} -G Ninja -S ${SOURCE_DIR} -B ${place}/build -D CMAKE_PREFIX_PATH=${place}/prefix
  -D CMAKE_CXX_COMPILER=${CXX})
run(${CMAKE_COMMAND} --build ${place}/build)
run(${place}/build/somebodys_own)
if(EXISTS ${place}/prefix/bin/mapbed)
  run(${place}/prefix/bin/mapbed --version)
endif()
