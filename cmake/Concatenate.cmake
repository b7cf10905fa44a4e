# Writes the files of INPUTS (separated by |) one after the other into OUTPUT:
#   cmake -D OUTPUT=... -D INPUTS=a|b -P Concatenate.cmake
string(REPLACE "|" ";" inputs "${INPUTS}")
execute_process(COMMAND ${CMAKE_COMMAND} -E cat ${inputs} OUTPUT_FILE "${OUTPUT}.part" COMMAND_ERROR_IS_FATAL ANY)
file(RENAME "${OUTPUT}.part" "${OUTPUT}")
