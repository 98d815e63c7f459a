namespace Nowpose.Cli.SessionFiles;

/// <summary>A received value of a signal.</summary>
/// <param name="Stamp">Time of the control cycle in which the signal took this value.</param>
/// <param name="Dropped">Reason why the session dropped the value; null if it was used.</param>
sealed record SignalLine(ControlTime Stamp, string Name, double Value, string Dropped) : SessionLine;
