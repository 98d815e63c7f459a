namespace Nowpose.Cli.Replay;

/// <summary>Rounds to the 100 ns of the time types, to decide the order of events. Not used for computations.</summary>
static class Ticks
{
    public static long Of(double seconds) => (long)Math.Round(seconds * TimeSpan.TicksPerSecond);
}
