# Runs at every build: asks git for the commit and writes the file only if it changed.
execute_process(
  COMMAND git -C ${PROJECT_SOURCE_DIR} rev-parse --short=12 HEAD
  OUTPUT_VARIABLE BRECCIA_COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(failed)
  set(BRECCIA_COMMIT unknown)
else()
  execute_process(
    COMMAND git -C ${PROJECT_SOURCE_DIR} status --porcelain --untracked-files=no
    OUTPUT_VARIABLE changes OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(changes)
    string(APPEND BRECCIA_COMMIT "+")
  endif()
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
