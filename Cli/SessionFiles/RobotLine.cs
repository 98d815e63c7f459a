namespace Nowpose.Cli.SessionFiles;

/// <summary>A further robot of a headset's session.</summary>
/// <param name="Joints">Its moving joints, with its namespace.</param>
sealed record RobotLine(IReadOnlyList<SessionHeader.Joint> Joints) : SessionLine;
