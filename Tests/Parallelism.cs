using NUnit.Framework;

// Fixtures run in parallel, because most of them wait: for a timeout, for the next attempt, or for another process. A fixture that changes
// the environment of the process, measures allocations or depends on real time is marked NonParallelizable.
// Exception: the fixtures of Pictures/VideoFolder only add programs to PATH that no other parallel test starts, and Pictures/OneAtATime runs them on
// a single thread.
[assembly: Parallelizable(ParallelScope.Fixtures)]
[assembly: LevelOfParallelism(6)]
