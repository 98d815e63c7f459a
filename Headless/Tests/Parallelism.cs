using NUnit.Framework;

// Those that run side by side wait, mostly: for a time-out, for the next attempt, for another process. Who needs the processor runs alone.
[assembly: LevelOfParallelism(4)]
