namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>Fits the hologram's position linearly to the robot's position and speed a given number of instants earlier.</summary>
/// <param name="Correlation">Correlation of the two positions.</param>
/// <param name="Shift">Remaining shift of the hologram, in instants. Small compared with the lag.</param>
/// <param name="Deviation">Standard error of the shift, assuming that the residuals are noise.</param>
readonly record struct ShiftFit(double Correlation, double Shift, double Deviation)
{
    const int Parameters = 3;

    /// <param name="from">First compared instant of the hologram.</param>
    /// <param name="to">End of the compared instants, exclusive.</param>
    /// <param name="speedSpan">The speed is computed from the positions this number of instants before and after; 0 for no speed.</param>
    public static ShiftFit Of(SineTracks tracks, int lag, int from, int to, int speedSpan)
    {
        var count = to - from;
        double[] robot = new double[count], speed = new double[count], shown = tracks.Shown[from..to];
        for (var i = 0; i < count; i++)
        {
            var at = from + i - lag;
            robot[i] = tracks.Robot[at];
            int before = Math.Max(0, at - speedSpan), after = Math.Min(tracks.Robot.Length - 1, at + speedSpan);
            if (after > before) speed[i] = (tracks.Robot[after] - tracks.Robot[before]) / (after - before);
        }
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
