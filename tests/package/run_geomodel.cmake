# Installs this build, looks whether everything is there, then builds and runs a program that finds and links geomesh::geomodel.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE out ERROR_VARIABLE out)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${out}")
  endif()
endfunction()
get_filename_component(here "${CMAKE_SCRIPT_MODE_FILE}" DIRECTORY)
file(REMOVE_RECURSE "${work}")
run("${CMAKE_COMMAND}" --install "${build}" --prefix "${work}/prefix")
foreach(file bin/geomesh share/doc/geomesh/LICENSE share/doc/geomesh/LICENSE.core share/doc/geomesh/project-file.md
             share/geomesh/project.schema.json share/geomesh/samples/salt-dome/project.yaml share/man/man1/geomesh.1
             share/bash-completion/completions/geomesh)
  if(NOT EXISTS "${work}/prefix/${file}")
    message(FATAL_ERROR "cmake --install left out ${file}")
  endif()
endforeach()
run("${work}/prefix/bin/geomesh" "${work}/prefix/share/geomesh/samples/layer-cake/project.yaml" -o "${work}/out" --quiet)
run("${CMAKE_COMMAND}" -G Ninja -S "${here}/geomodel_consumer" -B "${work}/consumer" -D CMAKE_BUILD_TYPE=Release
    -D CMAKE_CXX_COMPILER=${compiler} -D CMAKE_PREFIX_PATH=${work}/prefix)
run("${CMAKE_COMMAND}" --build "${work}/consumer")
run("${work}/consumer/geomodel_consumer")
