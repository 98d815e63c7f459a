using System.Globalization;
using Nowpose.Cli.Demo.Paper;

namespace Nowpose.Unity.Tests.Demo.Paper;

/// <summary>
/// Computes the number of each claim only from <c>frames.csv</c> and <c>exchanges.csv</c>, independently of the product's code: it uses positions
/// where the product uses angles, and computes the velocity of its own seven-phase motion profile (0.1 s of jerk, 0.1 s of constant acceleration).
/// </summary>
sealed class WrittenNumbers
{
    const double Settled = 10, Before = 0.2, JerkTime = 0.1, RampTime = 0.3, Dwell = 0.5, Span = 0.25, Shown = 1.5;

    /// <summary>Time in s for a quarter turn at the maximum velocity, which is 90 % of the youBot's 1.5708 rad/s.</summary>
    const double CruiseTime = 1 / 0.9;

    const double MoveTime = CruiseTime + RampTime;

    readonly List<Dictionary<string, double>> _frames, _settled, _exchanges;
    readonly List<List<Dictionary<string, double>>> _swings;
    readonly WrittenClock _clock;

    public WrittenNumbers(PaperRun run)
    {
        _frames = Read(writer => PaperOutput.WriteFrames(writer, [run]));
        _exchanges = Read(writer => PaperOutput.WriteExchanges(writer, [run]));
        _clock = new WrittenClock(_exchanges);
        _settled = [.. _frames.Where(frame => frame["elapsed_s"] >= Settled)];
        // A swing counts if its frames cover the time from 0.2 s before its start to 0.4 s after the move back.
        _swings = [.. _settled.GroupBy(frame => frame["swing"])
            .Where(swing => swing.First()["swing_s"] <= -Before && swing.Last()["swing_s"] >= 2 * MoveTime + Dwell + 0.4)
            .Select(swing => swing.Where(frame => frame["swing_s"] >= -Before).ToList())];
    }

    IEnumerable<Dictionary<string, double>> Swung => _swings.SelectMany(swing => swing);

    IEnumerable<Dictionary<string, double>> Early => Swung.Where(frame => frame["swing_s"] is >= 0 and < Shown);

    /// <summary>ε_i of the exchanges from 10 s on, ms: with the fit of <see cref="WrittenClock"/>, and with the written γ₂ and Θ₂.</summary>
    public IEnumerable<(double Own, double Written)> FitErrors => _clock.OwnFitErrorsMs.Zip(_clock.FitErrorsMs, _exchanges)
        .Where(each => each.Third["time_s"] >= Settled).Select(each => (each.First, each.Second));

    public IEnumerable<double> InOrderOfTheClaims()
    {
        yield return FitErrors.Average(errors => Math.Abs(errors.Written) < 1 ? 1.0 : 0);
        yield return Quantile(_settled.Select(frame => Math.Abs(frame["offset_error_us"]) / 1000), 0.95);
        yield return SkewRatio();
        yield return RoundTripRatio();
        yield return Rms(Swung, "shown") / Rms(Swung, "held");
        yield return Rms(Swung.Where(IsSteady), "shown") / Rms(Swung.Where(frame => Speed(frame) > 0 && !IsSteady(frame)), "shown");
        // Full speed counts as reached when 0.1 % of it is missing. In the last time t of the ramp, the jerk adds the fraction
        // t² / (2 · 0.2 s · 0.1 s) of the full speed.
        yield return GapRatio(swing => swing.First(frame => frame["swing_s"] >= RampTime - Math.Sqrt(0.001 * 2 * 0.2 * JerkTime)));
        yield return GapRatio(swing => swing.First(frame => frame["swing_s"] >= MoveTime / 2));
        yield return GapRatio(swing => swing.Last(frame => frame["swing_s"] <= MoveTime - RampTime / 2));
        yield return Quantile(_settled.Select(frame => Math.Abs(frame["assumed_light_s"] - frame["true_light_s"]) * 1000), 0.95);
        yield return 1 - Rms(Early, "shown") / Rms(Early, "held");
        yield return Latency("shown") / Latency("held");
    }

    double SkewRatio()
    {
        var (first, last) = (_exchanges[0], _exchanges[^1]);
        var truth = 1000 * (last["true_offset_ms"] - first["true_offset_ms"]) / (last["time_s"] - first["time_s"]);
        var end = _frames[^1]["elapsed_s"];
        double RmsOf(double from, double to) => Math.Sqrt(_frames.Where(frame => frame["elapsed_s"] >= from && frame["elapsed_s"] <= to)
            .Average(frame => Math.Pow(frame["skew_ppm"] - truth, 2)));
        return RmsOf(0.75 * end, end) / RmsOf(2, Settled);
    }

    double RoundTripRatio()
    {
        var errors = _clock.RoundTripsMs.Zip(_clock.OffsetsMs, _exchanges).OrderBy(each => each.First)
            .Select(each => Math.Abs(each.Second - each.Third["true_offset_ms"])).ToList();
        var quarter = errors.Count / 4;
        return Quantile(errors.Take(quarter), 0.95) / Quantile(errors.TakeLast(quarter), 0.95);
    }

    double GapRatio(Func<List<Dictionary<string, double>>, Dictionary<string, double>> momentOf)
    {
        var moments = _swings.Select(momentOf).ToList();
        return Rms(moments, "shown") / Rms(moments, "held");
    }

    double Latency(string shown) => Quantile(Early.Where(frame => Speed(frame) >= 0.05).Select(frame => Gap(frame, shown) / Speed(frame)), 0.5);

    /// <summary>Returns whether the velocity has been constant for the time span of a prediction.</summary>
    static bool IsSteady(Dictionary<string, double> frame) =>
        SinceMove(frame) is var t && t - Span >= RampTime && t <= MoveTime - RampTime;

    /// <summary>Returns the speed as a fraction of the maximum speed.</summary>
    static double Speed(Dictionary<string, double> frame)
    {
        var t = SinceMove(frame);
        return Ramp(Math.Min(t, MoveTime - t));
    }

    static double Ramp(double t) => t <= 0 ? 0 : t < JerkTime ? 25 * t * t
        : t < RampTime - JerkTime ? 25 * JerkTime * JerkTime + 5 * (t - JerkTime)
        : t < RampTime ? 1 - 25 * (RampTime - t) * (RampTime - t) : 1;

    /// <summary>Returns the time in s since the start of the current move (there or back).</summary>
    static double SinceMove(Dictionary<string, double> frame) =>
        frame["swing_s"] < MoveTime + Dwell ? frame["swing_s"] : frame["swing_s"] - MoveTime - Dwell;

    static double Rms(IEnumerable<Dictionary<string, double>> frames, string shown) => Math.Sqrt(frames.Average(frame => Math.Pow(Gap(frame, shown), 2)));

    static double Gap(Dictionary<string, double> frame, string shown) => Math.Sqrt(
        new[] { "x", "y", "z" }.Sum(axis => Math.Pow(frame[$"{shown}_{axis}_m"] - frame[$"true_{axis}_m"], 2)));

    static List<Dictionary<string, double>> Read(Action<TextWriter> write)
    {
        using var text = new StringWriter();
        write(text);
        var lines = text.ToString().TrimEnd().Split('\n');
        var names = lines[0].Split(',');
        // Reads times relative to the first time of the same clock, because a double has too few digits for a time since the epoch.
        var firsts = names.Zip(lines[1].Split(',')).ToDictionary(each => each.First, each => each.Second);
        double Since(string cell, string first) =>
            (double)(decimal.Parse(cell, CultureInfo.InvariantCulture) - decimal.Parse(firsts[first], CultureInfo.InvariantCulture));
        double Value(string name, string cell) => name switch
        {
            _ when cell.Length == 0 => double.NaN,
            "true_light_s" or "assumed_light_s" => Since(cell, "true_light_s"),
            "t1_ns" or "t4_ns" => Since(cell, "t1_ns"),
            "t2_ns" or "t3_ns" => Since(cell, "t2_ns"),
            _ => double.Parse(cell, CultureInfo.InvariantCulture),
        };
        return [.. lines.Skip(1).Select(line => names.Zip(line.Split(',')).ToDictionary(each => each.First, each => Value(each.First, each.Second)))];
    }

    static double Quantile(IEnumerable<double> values, double share)
    {
        var sorted = values.Order().ToArray();
        var place = share * (sorted.Length - 1);
        var low = (int)place;
        return low + 1 == sorted.Length ? sorted[low] : sorted[low] + (place - low) * (sorted[low + 1] - sorted[low]);
    }
}
