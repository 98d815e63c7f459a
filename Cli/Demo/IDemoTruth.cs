namespace Nowpose.Cli.Demo;

/// <summary>What only the simulation knows: how the two clocks stand, and where the robot is.</summary>
interface IDemoTruth
{
    /// <summary>The control time of a moment on the headset clock, exactly.</summary>
    ControlTime ControlAt(HeadsetTime t);

    /// <summary>Φ, exactly.</summary>
    ClockOffset OffsetAt(HeadsetTime t) => new(t.SinceEpoch - ControlAt(t).SinceEpoch);

    /// <summary>Joint positions of the real robot at a control time, past or future, one per moving joint.</summary>
    void JointsAt(ControlTime t, Span<double> positions);

    /// <summary>Which cycle of its motion the robot is in, from 0.</summary>
    int CycleAt(ControlTime t);
}
