using MathNet.Numerics.LinearRegression;

namespace Nowpose.Cli.Calibrate.Head;

/// <summary>Estimates the latency for head motion from the distance between both codes, which changes with the speed of the head.</summary>
/// <remarks>
/// At time t, the hologram appears where the control code was at t − L: h(t) = a + (1 + b) c(t − L). Here L is the latency, a is the
/// distance between the codes, and b is not 0 if the codes have different distances to the camera. With the speed v of c:
/// h − c = a + b c + k c² − (1 + b) L v.
/// The term k c² models the distortion of lens and display. Over a back-and-forth motion, v and c are uncorrelated.
/// </remarks>
static class HeadMotionFit
{
    const int MinPictures = 60;

    /// <summary>Minimum number of changes of direction: two periods of a back-and-forth motion.</summary>
    const int MinTurns = 3;

    /// <summary>Maximum share of pictures in which the head moves in the same direction.</summary>
    const double MaxShareOfDirection = 0.8;

    /// <summary>A picture is an outlier if it deviates from the fit by more than this number of standard deviations.</summary>
    const double MaxDeviations = 4;

    /// <summary>Minimum root mean square of the speed, px/s. At lower speeds, 1 px of noise is as large as the effect of the latency.</summary>
    const double MinSpeed = 60;

    /// <summary>
    /// Allowed range of the hologram's motion divided by the control code's motion. The ratio is 0 for a hologram that is fixed to the display.
    /// </summary>
    const double MinScale = 0.7, MaxScale = 1.4;

    /// <summary>
    /// Number of parts into which the pictures are divided. The uncertainty is computed from fits that each omit one part (jackknife).
    /// </summary>
    const int Parts = 10;

    /// <summary>Quantile of Student's distribution with 9 degrees of freedom, for 95 % confidence.</summary>
    const double Coverage = 2.26;

    const int Place = 1, Speed = 3;

    /// <exception cref="InputException">There is too little motion, or there are too few pictures of it.</exception>
    public static (double LatencyMs, double UncertaintyMs, IReadOnlyList<HeadPicture> Used) Of(IReadOnlyList<HeadPicture> pictures)
    {
        RequireMotion(pictures);
        var used = WithoutStrays(pictures);
        RequireWorldLocked(1 + Fit(used)[Place]);
        var latency = LatencyOf(used);
        double[] parts = [.. Enumerable.Range(0, Parts).Select(part => LatencyOf([.. used.Where((_, i) => i * Parts / used.Count != part)]))];
        var mean = parts.Average();
        var deviation = Math.Sqrt((Parts - 1.0) / Parts * parts.Sum(each => (each - mean) * (each - mean)));
        return (1000 * latency, 1000 * Coverage * deviation, used);
    }

    static void RequireMotion(IReadOnlyList<HeadPicture> pictures)
    {
        if (pictures.Count < MinPictures)
            throw new InputException(HeadMotionMessages.TooFewPictures(pictures.Count, MinPictures));
        var speed = Math.Sqrt(pictures.Average(picture => picture.Speed * picture.Speed));
        if (speed < MinSpeed)
            throw new InputException(HeadMotionMessages.TooSlow(speed, MinSpeed));
        HeadPicture[] fast = [.. pictures.Where(picture => Math.Abs(picture.Speed) > speed / 2)];
        var forward = fast.Count(picture => picture.Speed > 0) / (double)fast.Length;
        var turns = fast.Zip(fast.Skip(1)).Count(pair => Math.Sign(pair.First.Speed) != Math.Sign(pair.Second.Speed));
        if (turns < MinTurns || forward > MaxShareOfDirection || forward < 1 - MaxShareOfDirection)
            throw new InputException(HeadMotionMessages.TooFewTurns(turns, 100 * Math.Max(forward, 1 - forward), 100 * MaxShareOfDirection));
    }

    static void RequireWorldLocked(double scale)
    {
        if (scale is >= MinScale and <= MaxScale) return;
        throw new InputException(HeadMotionMessages.NotWorldLocked(scale));
    }

    static List<HeadPicture> WithoutStrays(IReadOnlyList<HeadPicture> pictures)
    {
        var fit = Fit(pictures);
        double[] rests = [.. pictures.Select(picture => picture.Offset - TermsOf(picture).Zip(fit).Sum(term => term.First * term.Second))];
        var limit = MaxDeviations * Quantile.DeviationOf(rests);
        return [.. pictures.Where((_, i) => Math.Abs(rests[i]) <= limit)];
    }

    static double LatencyOf(IReadOnlyList<HeadPicture> pictures)
    {
        var fit = Fit(pictures);
        return -fit[Speed] / (1 + fit[Place]);
    }

    static double[] Fit(IReadOnlyList<HeadPicture> pictures) =>
        MultipleRegression.QR([.. pictures.Select(TermsOf)], [.. pictures.Select(picture => picture.Offset)]);

    static double[] TermsOf(HeadPicture picture) => [1, picture.Place, picture.Place * picture.Place, picture.Speed];
}
