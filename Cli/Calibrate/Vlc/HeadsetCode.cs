using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Reads a code that stays for a frame: an exposure shows one, or one and its successor.</summary>
static class HeadsetCode
{
    /// <summary>From one frame to the next, ms: displays of 250 Hz, and several frames of 60 Hz left out.</summary>
    const int LeastStep = 4, GreatestStep = 60;

    /// <summary>A pair that says less than this is covered, or two codes are as bright as each other.</summary>
    const double LeastContrast = 0.22;

    /// <summary>
    /// Root mean square of what the codes do not explain, of what they do. Good pictures leave less than half of it; where an edge
    /// behind the hologram is as bright as its light, pairs turn over, and others are off as well.
    /// </summary>
    const double GreatestRest = 0.15;

    /// <summary>The brighter code's share of the light.</summary>
    const double LeastShare = 0.6;

    /// <summary>Of the light of a lit cell: a code that is weaker is blurred beyond reading.</summary>
    const double LeastAmplitude = 0.4, GreatestAmplitude = 1.35;

    /// <returns>The time of the brighter code, which is the one that was lit in the middle of the exposure.</returns>
    public static Reading Read(CodeContrasts contrasts, int leastStep = LeastStep)
    {
        if (contrasts.Covered > 0) return Reading.Not("partly covered");
        for (var pair = 0; pair < TimestampCode.PairCount; pair++)
            if (Math.Abs(contrasts[pair]) < LeastContrast) return Reading.Not("undecided");
        var value = CodeWords.ValueOf(contrasts.Word());
        if (value < 0) return Reading.Not("wrong parity");
        var best = Enumerable.Range(leastStep, GreatestStep - leastStep + 1).SelectMany(step => new[] { step, -step })
            .Select(step => Fit(contrasts, value, value + step)).Append(Fit(contrasts, value, value)).MinBy(fit => fit.Unexplained);
        if (best.Unexplained > GreatestRest * best.Amplitude) return Reading.Not("inconsistent");
        if (best.Amplitude is < LeastAmplitude or > GreatestAmplitude) return Reading.Not("too weak");
        return best.Share < LeastShare ? Reading.Not("two codes alike") : Reading.Of(value);
    }

    /// <summary>Explains the pairs by two codes; the same twice for one.</summary>
    static (double Unexplained, double Share, double Amplitude) Fit(CodeContrasts contrasts, int first, int second)
    {
        // In pairs in which they agree the sum of both lights shows, in the others the difference.
        double alike = 0, different = 0, squares = 0;
        int alikes = 0, differents = 0;
        for (var pair = 0; pair < TimestampCode.PairCount; pair++)
        {
            var said = contrasts[pair] * CodeWords.SignOf(first, pair);
            squares += said * said;
            if (CodeWords.SignOf(first, pair) == CodeWords.SignOf(second, pair)) (alike, alikes) = (alike + said, alikes + 1);
            else (different, differents) = (different + said, differents + 1);
        }
        var sum = alike / alikes;
        var difference = differents == 0 ? sum : different / differents;
        squares -= sum * alike + (differents == 0 ? 0 : difference * different);
        return (Math.Sqrt(Math.Max(0, squares) / TimestampCode.PairCount), (sum + difference) / (2 * sum), sum);
    }
}
