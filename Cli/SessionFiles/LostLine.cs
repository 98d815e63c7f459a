namespace Nowpose.Cli.SessionFiles;

/// <summary>States how many lines are missing at this point because the recording could not keep up.</summary>
sealed record LostLine(long Count) : SessionLine;
