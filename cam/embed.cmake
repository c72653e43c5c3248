# Writes the texts of FILES into a C++ file: machine_files().
set(code "// Made by embed.cmake from cam/machine/*.toml.\n#include \"fieldfab/cam/machine/machine.h\"\n\nnamespace fieldfab::cam {\n\nconst std::map<std::string, std::string>& machine_files() {\n  static const std::map<std::string, std::string> files{\n")
foreach(file ${FILES})
  get_filename_component(id ${file} NAME_WE)
  file(READ ${file} text)
  string(APPEND code "      {\"${id}\", R\"toml(${text})toml\"},\n")
endforeach()
string(APPEND code "  };\n  return files;\n}\n\n}  // namespace fieldfab::cam\n")
file(WRITE ${OUTPUT} "${code}")
