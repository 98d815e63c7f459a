namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>Fits the hologram's position linearly to the robot's position and speed a given number of instants earlier.</summary>
/// <param name="Correlation">Correlation of the two positions.</param>
/// <param name="Shift">Remaining shift of the hologram, in instants.</param>
/// <param name="Deviation">Standard error of the shift, assuming that the residuals are noise.</param>
readonly record struct ShiftFit(double Correlation, double Shift, double Deviation)
{
    const int Parameters = 3;

    /// <param name="speeds">Speed of the robot at each instant, per instant; null for a fit to the position only.</param>
    /// <param name="lag">Number of instants. Between instants, position and speed are interpolated linearly.</param>
    /// <param name="from">First compared instant of the hologram.</param>
    /// <param name="to">End of the compared instants, exclusive.</param>
    public static ShiftFit Of(SineTracks tracks, double[] speeds, double lag, int from, int to)
    {
        var count = to - from;
        double[] robot = Earlier(tracks.Robot, lag, from, to), shown = tracks.Shown[from..to];
        var speed = speeds == null ? new double[count] : Earlier(speeds, lag, from, to);
        Centre(robot);
        Centre(speed);
        Centre(shown);
        double rr = Product(robot, robot), rs = Product(robot, shown), ss = Product(shown, shown);
        if (!(rr > 0 && ss > 0)) return default;
        var correlation = rs / Math.Sqrt(rr * ss);
        double vv = Product(speed, speed), rv = Product(robot, speed), vs = Product(speed, shown);
        var determinant = rr * vv - rv * rv;
        if (!(determinant > 0)) return new(correlation, 0, 0);
        double slope = (rs * vv - vs * rv) / determinant, onSpeed = (vs * rr - rs * rv) / determinant;
        var left = Math.Max(0, ss - slope * rs - onSpeed * vs) / (count - Parameters);
        return new(correlation, -onSpeed / slope, Math.Sqrt(left * rr / determinant) / Math.Abs(slope));
    }

    static double[] Earlier(double[] values, double lag, int from, int to)
    {
        var (whole, share) = ((int)Math.Ceiling(lag), Math.Ceiling(lag) - lag);
        double[] earlier = values[(from - whole)..(to - whole)];
        if (share == 0) return earlier;
        for (var i = 0; i < earlier.Length; i++) earlier[i] += share * (values[from - whole + i + 1] - earlier[i]);
        return earlier;
    }

    static void Centre(double[] values)
    {
        var mean = values.Average();
        for (var i = 0; i < values.Length; i++) values[i] -= mean;
    }

    static double Product(double[] a, double[] b)
    {
        double sum = 0;
        for (var i = 0; i < a.Length; i++) sum += a[i] * b[i];
        return sum;
    }
}
