namespace Nowpose.Cli.SessionFiles;

/// <summary>A change of the clock model.</summary>
/// <param name="IsNewStart">
/// Whether the session discarded all samples, because their time stamps precede a clock step or were never checked.
/// </param>
sealed record ClockChangeLine(bool IsNewStart) : SessionLine;
