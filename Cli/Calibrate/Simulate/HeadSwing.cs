namespace Nowpose.Cli.Calibrate.Simulate;

/// <summary>Position, in the pictures of a headset that is turned to and fro, of a point that is fixed in the room, px from the middle.</summary>
/// <remarks>The amplitude is a quarter of the picture's width, the period 3 s. With the 43° wide picture of a HoloLens 2: up to 11°/s.</remarks>
static class HeadSwing
{
    const double AmplitudePx = 160, Rise = 0.3, PeriodSeconds = 3;

    public static (double X, double Y) PlaceAt(ControlTime time) => Scaled(AmplitudePx * Math.Sin(PhaseAt(time)));

    /// <summary>Gets the speed of the point, px/s.</summary>
    public static (double X, double Y) SpeedAt(ControlTime time) => Scaled(AmplitudePx * 2 * Math.PI / PeriodSeconds * Math.Cos(PhaseAt(time)));

    static double PhaseAt(ControlTime time) => 2 * Math.PI * (time.SinceEpoch.TotalSeconds % PeriodSeconds) / PeriodSeconds;

    static (double X, double Y) Scaled(double along) => (along, Rise * along);
}
