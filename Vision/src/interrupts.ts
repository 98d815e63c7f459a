// Ignores Ctrl-C, which a terminal sends to all of its processes. The parent process ends this one by closing its standard input.
process.on('SIGINT', () => {});
