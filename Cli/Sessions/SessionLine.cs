namespace Nowpose.Cli.Sessions;

/// <summary>A line of a session file below the header. Kinds that no command uses have no derived type.</summary>
abstract record SessionLine;
