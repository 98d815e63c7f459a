namespace Nowpose.Cli.Sessions;

/// <summary>One line of a session file below its header; kinds nobody here has use for are not made into one.</summary>
abstract record SessionLine;
