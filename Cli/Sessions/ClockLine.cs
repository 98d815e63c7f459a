namespace Nowpose.Cli.Sessions;

/// <summary>The clock model is another one.</summary>
/// <param name="IsNewStart">The session forgot all samples then: their stamps belong to another time line, or were never checked.</param>
sealed record ClockLine(bool IsNewStart) : SessionLine;
