using NUnit.Framework;

// Fixtures run in parallel, because most of them wait: for a timeout, for the next attempt, or for another process. A fixture is marked
// NonParallelizable if it counts something of the whole process, such as its memory, threads or files, if it requires that code allocates nothing, or
// if it changes an environment variable that another test reads. Fixtures that add programs to PATH or set the variable of a plant that no other test
// has run in parallel, and so do those that depend on real time: their limits hold on a busy machine.
[assembly: Parallelizable(ParallelScope.Fixtures)]
[assembly: LevelOfParallelism(6)]
