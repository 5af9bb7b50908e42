// Nothing: the headers of Trilinos that tests include are read once with it (cmake/voussoir_compiler.cmake).
