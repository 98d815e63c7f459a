using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Reads a code that is constant for a frame. An exposure shows one code, or two consecutive codes.</summary>
static class HeadsetCode
{
    /// <summary>Range of the interval between frames, ms: from a 250 Hz display to several dropped frames at 60 Hz.</summary>
    const int MinStep = 4, MaxStep = 60;

    /// <summary>Minimum contrast of a pair. Below it, the pair is covered, or two codes are equally bright.</summary>
    const double MinContrast = 0.22;

    /// <summary>
    /// Maximum root mean square of the residual, relative to the explained part. Good pictures have less than half of this value. An object
    /// behind the hologram that is as bright as the hologram causes a larger residual, because its edge changes some of the pairs.
    /// </summary>
    const double MaxResidual = 0.15;

    /// <summary>Minimum share of the brighter code in the light of both codes.</summary>
    const double MinShare = 0.6;

    /// <summary>Range of the amplitude, relative to the light of a lit cell. A code with a lower amplitude is too blurred to read.</summary>
    const double MinAmplitude = 0.4, MaxAmplitude = 1.35;

    /// <returns>The time of the brighter code, which was lit at the middle of the exposure.</returns>
    public static Reading Read(CodeContrasts contrasts, int minStep = MinStep)
    {
        if (contrasts.Fault is string fault) return Reading.Not(fault);
        for (var pair = 0; pair < TimestampCode.PairCount; pair++)
            if (Math.Abs(contrasts[pair]) < MinContrast) return Reading.Not(PictureFaults.Undecided);
        var value = CodeWords.ValueOf(contrasts.Word());
        if (value < 0) return Reading.Not(PictureFaults.WrongParity);
        var best = Enumerable.Range(minStep, MaxStep - minStep + 1).SelectMany(step => new[] { step, -step })
            .Select(step => Fit(contrasts, value, value + step)).Append(Fit(contrasts, value, value)).MinBy(fit => fit.Unexplained);
        if (best.Unexplained > MaxResidual * best.Amplitude) return Reading.Not(PictureFaults.Inconsistent);
        if (best.Amplitude is < MinAmplitude or > MaxAmplitude) return Reading.Not(PictureFaults.TooWeak);
        return best.Share < MinShare ? Reading.Not(PictureFaults.Ambiguous) : Reading.Of(value);
    }

    /// <summary>Fits two codes to the pairs. If the exposure shows only one code, both are the same.</summary>
    static (double Unexplained, double Share, double Amplitude) Fit(CodeContrasts contrasts, int first, int second)
    {
        // Pairs that are equal in both codes show the sum of the codes' light; the other pairs show the difference.
        double alike = 0, different = 0, squares = 0;
        int alikes = 0, differents = 0;
        for (var pair = 0; pair < TimestampCode.PairCount; pair++)
        {
            var signed = contrasts[pair] * CodeWords.SignOf(first, pair);
            squares += signed * signed;
            if (CodeWords.SignOf(first, pair) == CodeWords.SignOf(second, pair)) (alike, alikes) = (alike + signed, alikes + 1);
            else (different, differents) = (different + signed, differents + 1);
        }
        var sum = alike / alikes;
        var difference = differents == 0 ? sum : different / differents;
        squares -= sum * alike + (differents == 0 ? 0 : difference * different);
        return (Math.Sqrt(Math.Max(0, squares) / TimestampCode.PairCount), (sum + difference) / (2 * sum), sum);
    }
}
