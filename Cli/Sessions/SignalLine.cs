namespace Nowpose.Cli.Sessions;

/// <summary>A received value of a signal.</summary>
/// <param name="Stamp">Control cycle from which the signal has the value.</param>
/// <param name="Dropped">The reason why the session dropped it; null if it was used.</param>
sealed record SignalLine(ControlTime Stamp, string Name, double Value, string Dropped) : SessionLine;
