namespace Nowpose.Cli.Replay;

/// <summary>Rounds times to 100 ns, as the time types do. Used to order events, not to compute values.</summary>
static class Ticks
{
    public static long Of(double seconds) => (long)Math.Round(seconds * TimeSpan.TicksPerSecond);
}
