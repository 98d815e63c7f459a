namespace Nowpose.Cli.Sessions;

/// <summary>So many lines are missing here: the recording could not keep up.</summary>
sealed record LostLine(long Count) : SessionLine;
