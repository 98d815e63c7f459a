// Ctrl-C in a terminal reaches all of its programs. The process that started this one ends it by closing its standard input.
process.on('SIGINT', () => {});
