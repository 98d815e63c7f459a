using Nowpose.Motion;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>The swing as a motion of all joints of a simulated robot, repeated endlessly.</summary>
sealed class SwingMotion(YoubotSwing swing) : IMotion
{
    public IReadOnlyList<string> JointNames { get; } = [.. swing.Robot.MovingJoints.Select(joint => joint.Name)];

    public double CycleSeconds => swing.Motion.Seconds;

    public void At(double seconds, Span<double> positions) => swing.PositionsAt(Math.Max(seconds, 0) % CycleSeconds, positions);
}
