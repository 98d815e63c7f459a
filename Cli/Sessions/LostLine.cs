namespace Nowpose.Cli.Sessions;

/// <summary>Number of lines missing here, because the recording could not keep up.</summary>
sealed record LostLine(long Count) : SessionLine;
