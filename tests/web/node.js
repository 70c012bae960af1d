// Under Node the program's environment is the shell's.
Module['preRun'] = [() => Object.assign(ENV, process.env)];
