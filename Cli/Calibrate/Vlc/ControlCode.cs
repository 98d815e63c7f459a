using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Reads a code that changes every millisecond. An exposure shows several consecutive codes (a run).</summary>
static class ControlCode
{
    /// <summary>Minimum contrast at which a pair has the bit of the code in the middle of the exposure.</summary>
    const double Decided = 0.55;

    /// <summary>Maximum number of undecided pairs. The longest run in an exposure leaves this number of pairs undecided.</summary>
    const int MaxUndecided = 9;

    /// <summary>Maximum root mean square of the residual, relative to the explained part.</summary>
    const double MaxResidual = 0.17;

    /// <summary>
    /// Margin: minimum ratio of the second-best residual to the best one. MinResidual: lower limit of the best residual in this ratio.
    /// </summary>
    const double Margin = 1.6, MinResidual = 0.06;

    const double MinAmplitude = 0.4, MaxAmplitude = 1.35;

    /// <summary>
    /// Maximum difference between the middles of two runs that count as the same reading, ms. For long runs, 20 % of the length is used instead.
    /// </summary>
    const double Alike = 2;

    /// <summary>Maximum time for which another code can be visible without being counted, ms.</summary>
    const double Same = 0.05;

    static readonly double[] Lengths = [0.25, 0.5, 1, 1.5, 2, 2.5, 3, 3.5, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 18, 20, 24];

    /// <param name="delaysMs">Exposure delay of each pair relative to the middle of the code, caused by a rolling shutter.</param>
    /// <returns>The time at the middle of the exposure: the mean of the shown codes.</returns>
    public static Reading Read(CodeContrasts contrasts, double[] delaysMs)
    {
        if (contrasts.Fault is string fault) return Reading.Not(fault);
        var mask = 0;
        for (var pair = 0; pair < TimestampCode.PairCount; pair++) mask = mask << 1 | (Math.Abs(contrasts[pair]) > Decided ? 1 : 0);
        if (TimestampCode.PairCount - int.PopCount(mask) > MaxUndecided) return Reading.Not(PictureFaults.Undecided);
        Run best = default, other = default;
        best.Rest = other.Rest = double.MaxValue;
        foreach (var value in CodeWords.Matching(contrasts.Word(), mask))
            for (var middle = value + 0.125; middle < value + 1; middle += 0.25)
                foreach (var length in Lengths)
                {
                    var run = Fit(contrasts, delaysMs, middle, length);
                    if (run.Rest < best.Rest)
                    {
                        if (!IsSame(run, best)) other = best;
                        best = run;
                    }
                    else if (run.Rest < other.Rest && !IsSame(run, best)) other = run;
                }
        if (best.Rest == double.MaxValue) return Reading.Not(PictureFaults.WrongParity);
        if (best.Rest > MaxResidual * best.Amplitude) return Reading.Not(PictureFaults.Inconsistent);
        if (best.Amplitude is < MinAmplitude or > MaxAmplitude) return Reading.Not(PictureFaults.TooWeak);
        if (other.Rest < Margin * Math.Max(best.Rest, MinResidual)) return Reading.Not(PictureFaults.AmbiguousTime);
        // Value v is shown from v to v + 1, so the mean of the values is half a millisecond below the mean time.
        return Reading.Of(Wrap(MiddleOf(Refined(contrasts, delaysMs, best)) - 0.5));
    }

    /// <summary>
    /// Gets the middle of the time for which a run of codes was visible. If only one code was visible, returns the middle of its
    /// millisecond, which minimises the error.
    /// </summary>
    static double MiddleOf(Run run)
    {
        double first = Math.Floor(run.Middle - run.Length / 2), last = Math.Floor(run.Middle + run.Length / 2 - Same);
        return first == last ? first + 0.5 : run.Middle;
    }

    static Run Refined(CodeContrasts contrasts, double[] delaysMs, Run best)
    {
        foreach (var step in new[] { 0.12, 0.06, 0.03 })
            foreach (var (middle, length) in new[] { (step, 0.0), (-step, 0.0), (0.0, step), (0.0, -step), (step, 0.0), (-step, 0.0) })
            {
                var tried = Fit(contrasts, delaysMs, best.Middle + middle, Math.Max(0.1, best.Length + length));
                if (tried.Rest < best.Rest) best = tried;
            }
        return best;
    }

    static Run Fit(CodeContrasts contrasts, double[] delaysMs, double middle, double length)
    {
        double squares = 0, products = 0, models = 0;
        for (var pair = 0; pair < TimestampCode.PairCount; pair++)
        {
            var model = CodeWords.MeanSign(pair, middle - length / 2 + delaysMs[pair], length);
            squares += contrasts[pair] * contrasts[pair];
            products += contrasts[pair] * model;
            models += model * model;
        }
        var amplitude = products / models;
        return new Run { Middle = middle, Length = length, Amplitude = amplitude, Rest = Math.Sqrt(Math.Max(0, squares - amplitude * products) / TimestampCode.PairCount) };
    }

    static bool IsSame(Run a, Run b) =>
        Math.Abs(Math.IEEERemainder(a.Middle - b.Middle, TimestampCode.PeriodMs)) < Math.Max(Alike, 0.2 * Math.Max(a.Length, b.Length));

    static double Wrap(double ms) => ms < 0 ? ms + TimestampCode.PeriodMs : ms;

    struct Run
    {
        public double Middle, Length, Amplitude, Rest;
    }
}
