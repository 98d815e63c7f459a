namespace Nowpose.Cli.Sessions;

/// <summary>One line of a session file below its header. Unused kinds of lines have no type.</summary>
abstract record SessionLine;
