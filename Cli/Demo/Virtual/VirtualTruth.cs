using Nowpose.Motion;
using Nowpose.Simulation;

namespace Nowpose.Cli.Demo.Virtual;

/// <summary>The true values of a virtual cell, whose motion starts together with the run.</summary>
/// <param name="control">The control clock.</param>
/// <param name="start">Headset time at the start of the run.</param>
/// <param name="skew">Skew of the control clock.</param>
sealed class VirtualTruth(IMotion motion, VirtualClock control, HeadsetTime start, double skew) : IDemoTruth
{
    public ControlTime ControlAt(HeadsetTime t) => control.At(t);

    // The cell's motion is a function of headset time. The skew causes an error of less than 0.1 µs.
    public void JointsAt(ControlTime t, Span<double> positions) => motion.At(MotionSecondsAt(t), positions);

    public double MotionSecondsAt(ControlTime t) => (t - control.At(start)).TotalSeconds / (1 + skew);

    public int CycleAt(ControlTime t) => (int)(MotionSecondsAt(t) / motion.CycleSeconds);
}
