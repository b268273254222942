# Builds and installs geomesh::core alone, then the consumer against it. Fails the test on the first command that fails.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${out}")
  endif()
endfunction()
get_filename_component(here "${CMAKE_SCRIPT_MODE_FILE}" DIRECTORY)
file(REMOVE_RECURSE "${work}/prefix" "${work}/consumer")
run("${CMAKE_COMMAND}" -G Ninja -S "${source}" -B "${work}/core" -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER=${compiler}
    -D GEOMESH_BUILD_GEOMODEL=OFF -D GEOMESH_BUILD_TESTS=OFF -D GEOMESH_BUILD_PYTHON=OFF -D CMAKE_INSTALL_PREFIX=${work}/prefix)
run("${CMAKE_COMMAND}" --build "${work}/core")
run("${CMAKE_COMMAND}" --install "${work}/core")
run("${CMAKE_COMMAND}" -G Ninja -S "${here}/consumer" -B "${work}/consumer" -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_PREFIX_PATH=${work}/prefix)
run("${CMAKE_COMMAND}" --build "${work}/consumer")
run("${work}/consumer/consumer")
