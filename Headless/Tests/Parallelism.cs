using NUnit.Framework;

// Fixtures marked so run side by side: most of them wait, for a time-out, for the next attempt, for another process. What shares Unity's
// scene, the process' environment or a moment of real time runs alone.
[assembly: LevelOfParallelism(4)]
