namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>The hologram's place as a straight line over the robot's place and speed, so many instants before.</summary>
/// <param name="Correlation">Of the two places.</param>
/// <param name="Shift">How many instants later than that the hologram is; small.</param>
/// <param name="Deviation">Standard error of the shift, as far as what the fit leaves is noise.</param>
readonly record struct ShiftFit(double Correlation, double Shift, double Deviation)
{
    const int Parameters = 3;

    /// <param name="from">The hologram's instants that are compared: from here.</param>
    /// <param name="to">To here, excluded.</param>
    /// <param name="speedSpan">Instants to either side between which the speed is taken; 0 to find the correlation only.</param>
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
