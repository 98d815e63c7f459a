namespace Nowpose.Cli.Sessions;

/// <summary>What a frame displayed.</summary>
/// <param name="Light">The moment of light; null while the clock was unsynchronised.</param>
/// <param name="Joints">One per joint of the header, rad or m.</param>
sealed record FrameLine(HeadsetTime Start, ControlTime? Light, double[] Joints) : SessionLine;
