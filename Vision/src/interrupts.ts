// Ctrl-C in a terminal reaches all of its programs. Who started this one decides when it ends: by closing its standard input.
process.on('SIGINT', () => { });
