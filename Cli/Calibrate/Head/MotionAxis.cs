namespace Nowpose.Cli.Calibrate.Head;

/// <summary>The direction in the picture along which positions vary most.</summary>
readonly struct MotionAxis
{
    readonly (double X, double Y) _mean, _direction;

    MotionAxis((double X, double Y) mean, (double X, double Y) direction) => (_mean, _direction) = (mean, direction);

    /// <param name="places">At least one position.</param>
    public static MotionAxis Of(IReadOnlyList<(double X, double Y)> places)
    {
        (double X, double Y) mean = (places.Average(place => place.X), places.Average(place => place.Y));
        double xx = 0, xy = 0, yy = 0;
        foreach (var (x, y) in places)
        {
            xx += (x - mean.X) * (x - mean.X);
            xy += (x - mean.X) * (y - mean.Y);
            yy += (y - mean.Y) * (y - mean.Y);
        }
        var angle = Math.Atan2(2 * xy, xx - yy) / 2;
        return new(mean, (Math.Cos(angle), Math.Sin(angle)));
    }

    /// <summary>Gets a position along the direction, relative to the mean of all positions.</summary>
    public double PlaceOf((double X, double Y) place) => LengthOf(place, _mean);

    /// <summary>Gets the distance along the direction from one position to another.</summary>
    public double LengthOf((double X, double Y) to, (double X, double Y) from) => (to.X - from.X) * _direction.X + (to.Y - from.Y) * _direction.Y;
}
