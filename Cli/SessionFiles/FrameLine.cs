namespace Nowpose.Cli.SessionFiles;

/// <summary>A displayed frame.</summary>
/// <param name="Light">Display time; null while the clock was unsynchronised.</param>
/// <param name="Joints">Displayed position of each joint of the header, rad or m.</param>
sealed record FrameLine(HeadsetTime Start, ControlTime? Light, double[] Joints) : SessionLine;
