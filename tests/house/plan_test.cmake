# A check that cannot fail is none: every forbidden include below must turn house.plan red.
cmake_minimum_required(VERSION 3.25)
set(forbidden
    "analysis/a.cpp|\"haptics/engine/force_engine.h\""
    "analysis/a.h|<nlohmann/json.hpp>"
    "analysis/a.h|<Eigen/Dense>"
    "haptics/engine/a.cpp|\"questionnaires/answer.h\""
    "haptics/engine/a.cpp|\"protocols/protocol.h\""
    "haptics/models/a.h|\"haptics/engine/force_engine.h\""
    "haptics/models/a.h|<vector>"
    "haptics/engine/a.cpp|\"haptics/bench/stopwatch.h\""
    "haptics/engine/a.cpp|<gsl/gsl_spline.h>"
    "haptics/bench/a.cpp|<gsl/gsl_spline.h>"
    "study/a.cpp|\"haptics/bench/stopwatch.h\""
    "haptics/models/a.h|<Eigen/Dense>"
    "questionnaires/a.cpp|\"protocols/protocol.h\""
    "questionnaires/a.cpp|<nlohmann/json.hpp>"
    "protocols/a.cpp|\"study/session.h\""
    "protocols/a.cpp|\"analysis/welch.h\""
    "study/a.cpp|<sqlite3.h>"
    "study/storage/a.h|<sqlite3.h>"
    "study/a.cpp|<QString>"
    "study/a.cpp|\"study/gui/page.h\""
    "study/report/a.cpp|<QWidget>"
    "study/gui/a.cpp|\"study/app/main.h\""
    "study/gui/a.cpp|<QOpenGLContext>"
    "study/a.cpp|\"tests/support/scratch_folder.h\""
    "study/a.cpp|<boost/math/distributions.hpp>")
foreach(case IN LISTS forbidden)
  string(REPLACE "|" ";" parts "${case}")
  list(GET parts 0 file)
  list(GET parts 1 include)
  file(REMOVE_RECURSE ${SCRATCH})
  file(WRITE ${SCRATCH}/${file} "#include ${include}\n")
  execute_process(
    COMMAND ${CMAKE_COMMAND} -D SOURCE_DIR=${SCRATCH} -P ${SOURCE_DIR}/tests/house/plan.cmake
    RESULT_VARIABLE result ERROR_QUIET OUTPUT_QUIET)
  if(result EQUAL 0)
    message(SEND_ERROR "house.plan did not notice ${include} in ${file}")
  endif()
endforeach()
file(REMOVE_RECURSE ${SCRATCH})
