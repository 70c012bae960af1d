// Under Node the program's environment is that of the shell.
Module['preRun'] = [() => Object.assign(ENV, process.env)];
