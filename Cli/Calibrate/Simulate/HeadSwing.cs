namespace Nowpose.Cli.Calibrate.Simulate;

/// <summary>Where a point that is fixed in the room is in the pictures of a headset that is turned to and fro, px from the middle.</summary>
/// <remarks>A quarter of the picture's width in 3 s: with the 43° of a HoloLens 2 across the picture, up to 11°/s.</remarks>
static class HeadSwing
{
    const double AmplitudePx = 160, Rise = 0.3, PeriodSeconds = 3;

    public static (double X, double Y) PlaceAt(ControlTime time) => Scaled(AmplitudePx * Math.Sin(PhaseAt(time)));

    /// <summary>px/s.</summary>
    public static (double X, double Y) SpeedAt(ControlTime time) => Scaled(AmplitudePx * 2 * Math.PI / PeriodSeconds * Math.Cos(PhaseAt(time)));

    static double PhaseAt(ControlTime time) => 2 * Math.PI * (time.SinceEpoch.TotalSeconds % PeriodSeconds) / PeriodSeconds;

    static (double X, double Y) Scaled(double along) => (along, Rise * along);
}
