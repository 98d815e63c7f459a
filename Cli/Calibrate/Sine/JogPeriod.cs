namespace Nowpose.Cli.Calibrate.Sine;

/// <summary>Determines the period of a motion back and forth. A wrong period shows that the times of a recording are wrong.</summary>
static class JogPeriod
{
    /// <summary>Distance from the middle that a position must exceed to be on one side, as a share of the range. Noise does not exceed it.</summary>
    const double Side = 0.125;

    /// <summary>Gets the mean number of instants between two changes from the lower to the upper side; null for fewer than two changes.</summary>
    public static double? Of(double[] positions)
    {
        double min = positions.Min(), range = positions.Max() - min;
        double low = min + (0.5 - Side) * range, high = min + (0.5 + Side) * range;
        var (first, last, changes, isLow) = (0, 0, 0, false);
        for (var i = 0; i < positions.Length; i++)
        {
            if (positions[i] < low) isLow = true;
            if (!isLow || positions[i] <= high) continue;
            if (changes++ == 0) first = i;
            (last, isLow) = (i, false);
        }
        return changes < 2 ? null : (last - first) / (changes - 1.0);
    }
}
