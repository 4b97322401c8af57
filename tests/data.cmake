# Tests in Python: pages in a browser; reference values, derived independently of Patina from the papers; the links of
# all pages; and the rows of docs/sources.md and of the lessons.
find_package(Python3 COMPONENTS Interpreter)

# A test that is a Python script; without Python it is skipped with a message.
function(add_python_test name)
  if(Python3_Interpreter_FOUND)
    add_test(NAME ${name} COMMAND Python3::Interpreter -B ${ARGN})
  else()
    message(STATUS "The test ${name} is skipped: there is no Python 3")
    add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -E echo "skipped: there is no Python 3")
    set_tests_properties(${name} PROPERTIES SKIP_REGULAR_EXPRESSION "skipped: there is no Python 3")
  endif()
endfunction()

# The page of `patina snapshot --report` in a headless Chromium, which scripts/setup installs.
add_python_test(report_page ${CMAKE_CURRENT_SOURCE_DIR}/report/report_page_test.py $<TARGET_FILE:patina_cli>)
if(Python3_Interpreter_FOUND)
  set_tests_properties(report_page PROPERTIES SKIP_REGULAR_EXPRESSION "(^|\n)skipped: " TIMEOUT 300)
endif()

# The page of `patina sheet`, in the same browser.
add_python_test(sheet_page ${CMAKE_CURRENT_SOURCE_DIR}/report/sheet_test.py $<TARGET_FILE:patina_cli>)
if(Python3_Interpreter_FOUND)
  set_tests_properties(sheet_page PROPERTIES SKIP_REGULAR_EXPRESSION "(^|\n)skipped: " TIMEOUT 300)
endif()

# The page of `patina watch --render`, in the same browser.
add_python_test(live_page ${CMAKE_CURRENT_SOURCE_DIR}/report/live_page_test.py $<TARGET_FILE:patina_cli>)
if(Python3_Interpreter_FOUND)
  set_tests_properties(live_page PROPERTIES SKIP_REGULAR_EXPRESSION "(^|\n)skipped: " TIMEOUT 300)
endif()

# Sheets of pictures that compare.
add_python_test(looking ${CMAKE_CURRENT_SOURCE_DIR}/report/looking_test.py $<TARGET_FILE:patina_cli>)

# Drawings of graphs.
add_python_test(graph_drawing ${CMAKE_CURRENT_SOURCE_DIR}/report/graph_test.py $<TARGET_FILE:patina_cli>)

# What a team's build server and pre-commit run.
add_python_test(guard ${CMAKE_CURRENT_SOURCE_DIR}/guard/guard_test.py $<TARGET_FILE:patina_cli> ${CMAKE_SOURCE_DIR})

add_python_test(brdf_values ${CMAKE_CURRENT_SOURCE_DIR}/data/derive_brdf_values.py)
add_python_test(noise_values ${CMAKE_CURRENT_SOURCE_DIR}/data/noise_values.py)
add_python_test(sources ${CMAKE_CURRENT_SOURCE_DIR}/docs/sources.py ${CMAKE_SOURCE_DIR})

# The pages of nodes, models and values, which `scripts/reference` makes.
add_python_test(reference_pages ${CMAKE_SOURCE_DIR}/scripts/reference --check $<TARGET_FILE:patina_cli>)
add_python_test(reference_script ${CMAKE_CURRENT_SOURCE_DIR}/docs/reference_test.py ${CMAKE_SOURCE_DIR} $<TARGET_FILE:patina_cli>)

# The links of all pages, and how near each page is.
add_python_test(links ${CMAKE_CURRENT_SOURCE_DIR}/docs/links.py ${CMAKE_SOURCE_DIR})

# The lessons, and what is written in two languages.
add_python_test(languages ${CMAKE_CURRENT_SOURCE_DIR}/docs/languages.py ${CMAKE_SOURCE_DIR})
add_python_test(lessons ${CMAKE_CURRENT_SOURCE_DIR}/docs/lessons.py ${CMAKE_SOURCE_DIR} $<TARGET_FILE:patina_cli>)
add_python_test(lesson_figures ${CMAKE_CURRENT_SOURCE_DIR}/docs/lessons.py ${CMAKE_SOURCE_DIR} $<TARGET_FILE:patina_cli> figures)
set_tests_properties(lesson_figures PROPERTIES LABELS slow)
