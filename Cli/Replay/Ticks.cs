namespace Nowpose.Cli.Replay;

/// <summary>Rounding to the 100 ns of the time types, which decides what comes first; nothing is computed with it.</summary>
static class Ticks
{
    public static long Of(double seconds) => (long)Math.Round(seconds * TimeSpan.TicksPerSecond);
}
