using NUnit.Framework;

// Fixtures run side by side: most of them wait, for a time-out, for the next attempt, for another process. What shares the process'
// environment, counts garbage or watches a moment of real time says NonParallelizable.
[assembly: Parallelizable(ParallelScope.Fixtures)]
[assembly: LevelOfParallelism(8)]
