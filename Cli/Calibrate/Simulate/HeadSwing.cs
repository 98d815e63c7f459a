namespace Nowpose.Cli.Calibrate.Simulate;

/// <summary>Computes where a headset that turns left and right sees a fixed point in the room, in px from the middle of the picture.</summary>
/// <remarks>
/// The horizontal amplitude is an eighth of the picture's width, and the period is 3 s. If the picture is 43° wide, like the display of a
/// HoloLens 2, the maximum speed is 12°/s.
/// </remarks>
static class HeadSwing
{
    const double AmplitudePx = 160, Rise = 0.3, PeriodSeconds = 3;

    public static (double X, double Y) PlaceAt(ControlTime time) => Scaled(AmplitudePx * Math.Sin(PhaseAt(time)));

    /// <summary>Gets the speed of the point, px/s.</summary>
    public static (double X, double Y) SpeedAt(ControlTime time) => Scaled(AmplitudePx * 2 * Math.PI / PeriodSeconds * Math.Cos(PhaseAt(time)));

    static double PhaseAt(ControlTime time) => 2 * Math.PI * (time.SinceEpoch.TotalSeconds % PeriodSeconds) / PeriodSeconds;

    static (double X, double Y) Scaled(double along) => (along, Rise * along);
}
