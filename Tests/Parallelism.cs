using NUnit.Framework;

// Fixtures run in parallel, because most of them wait: for a timeout, for the next attempt, or for another process. A fixture that changes
// the environment of the process, measures allocations or depends on real time is marked NonParallelizable.
[assembly: Parallelizable(ParallelScope.Fixtures)]
[assembly: LevelOfParallelism(6)]
