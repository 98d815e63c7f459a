using Nowpose.Motion;
using Nowpose.Simulation;

namespace Nowpose.Cli.Demo.Virtual;

/// <summary>The truth of a virtual cell, whose motion begins with the run.</summary>
/// <param name="control">The control clock.</param>
/// <param name="start">Headset time of the run's start.</param>
/// <param name="skew">Skew of the control clock.</param>
sealed class VirtualTruth(IMotion motion, VirtualClock control, HeadsetTime start, double skew) : IDemoTruth
{
    public ControlTime ControlAt(HeadsetTime t) => control.At(t);

    // The cell takes headset time. The skew makes an error of less than 0.1 µs.
    public void JointsAt(ControlTime t, Span<double> positions) => motion.At(MotionSecondsAt(t), positions);

    public double MotionSecondsAt(ControlTime t) => (t - control.At(start)).TotalSeconds / (1 + skew);

    public int CycleAt(ControlTime t) => (int)(MotionSecondsAt(t) / motion.CycleSeconds);
}
