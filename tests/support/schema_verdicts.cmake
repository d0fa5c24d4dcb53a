# The schemas that ship for editors and the readers that speak to people must agree. Needs node and
# its package ajv; the tests say so where one of them is missing.
set(PALPATE_AJV "${PROJECT_SOURCE_DIR}/build/node_modules" CACHE PATH "The node_modules folder that holds ajv")
find_program(NODE_PROGRAM node)

# schema_verdicts(<room> <program that says what the reader says> <the schema of the room's library>)
function(schema_verdicts room verdict schema)
  target_sources(${verdict} PRIVATE ${PROJECT_SOURCE_DIR}/tests/support/verdicts.cpp)
  target_link_libraries(${verdict} PRIVATE ${room} nlohmann_json::nlohmann_json)
  set(name ${room}.schemaAgreesWithReader)
  if(NODE_PROGRAM)
    add_test(
      NAME ${name}
      COMMAND ${NODE_PROGRAM} ${PROJECT_SOURCE_DIR}/tests/support/schema_verdicts.mjs ${PALPATE_AJV} $<TARGET_FILE:${verdict}>
              ${PROJECT_SOURCE_DIR}/${room}/library ${schema} ${CMAKE_CURRENT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/mutations)
  else()
    add_test(NAME ${name} COMMAND sh -c "echo 'Skipped: needs Node: ./setup --check'; exit 77")
  endif()
  set_tests_properties(${name} PROPERTIES LABELS ${room} TIMEOUT 1200 SKIP_RETURN_CODE 77)
endfunction()
