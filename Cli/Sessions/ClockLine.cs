namespace Nowpose.Cli.Sessions;

/// <summary>The clock model has changed.</summary>
/// <param name="IsNewStart">Whether the session discarded all samples: their stamps belong to another time line, or were never checked.</param>
sealed record ClockLine(bool IsNewStart) : SessionLine;
