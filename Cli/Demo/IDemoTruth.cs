namespace Nowpose.Cli.Demo;

/// <summary>The true values of the simulation: the offset between the clocks, and the robot's position.</summary>
interface IDemoTruth
{
    /// <summary>Gets the exact control time for a headset time.</summary>
    ControlTime ControlAt(HeadsetTime t);

    /// <summary>Gets the exact offset Φ.</summary>
    ClockOffset OffsetAt(HeadsetTime t) => new(t.SinceEpoch - ControlAt(t).SinceEpoch);

    /// <summary>Gets the joint positions of the real robot at a past or future control time, one per moving joint.</summary>
    void JointsAt(ControlTime t, Span<double> positions);

    /// <summary>Gets the time since the start of the motion, s.</summary>
    double MotionSecondsAt(ControlTime t);

    /// <summary>Gets the index of the motion cycle, from 0.</summary>
    int CycleAt(ControlTime t);
}
