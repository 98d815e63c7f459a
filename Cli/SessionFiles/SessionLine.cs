namespace Nowpose.Cli.SessionFiles;

/// <summary>A line of a session file below the header. Kinds that no command uses have no derived type.</summary>
abstract record SessionLine;
