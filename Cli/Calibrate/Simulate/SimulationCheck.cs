using System.Globalization;
using Nowpose.Cli.Calibrate.Vlc;
using Nowpose.Vision;

namespace Nowpose.Cli.Calibrate.Simulate;

/// <summary>Reads pictures with known true values and measures the error.</summary>
sealed class SimulationCheck
{
    /// <summary>Minimum error of a misread picture, ms. The 1 ms resolution of the codes causes errors of about half of this value.</summary>
    public const double MisreadMs = 2.5;

    readonly SortedDictionary<int, Checked> _pictures = [];

    /// <summary>Creates the pictures in memory and reads them.</summary>
    public static SimulationCheck Run(SimulationSettings settings, CancellationToken cancellation)
    {
        var check = new SimulationCheck();
        var sweep = new SimulatedSweep(settings);
        var camera = new SimulatedCamera(settings, sweep);
        var reader = new PictureReader(settings.ReadoutMs, 0);
        var defects = new string[settings.Pictures];
        using var pool = new VisionPool();
        ConsoleProgress.Run("reading pictures", "pictures", settings.Pictures, report => pool.Look(
            Enumerable.Range(0, settings.Pictures).Select(i => PictureRequest.Made(camera.Take(i, out defects[i]))),
            (place, seen) =>
            {
                var result = reader.Read(FormattableString.Invariant($"{place}"), seen);
                check._pictures[place] = new(result, result.VisuMs - sweep.VisuMsOf(sweep.Moments[place]), defects[place]);
                report(check._pictures.Count);
            },
            cancellation));
        check.RejectOutliers();
        return check;
    }

    public int Pictures => _pictures.Count;

    public int Read => _pictures.Values.Count(picture => picture.Result.IsRead);

    public int Misread => Wrong().Count();

    /// <summary>Share of the pictures without a defect that were read; null if all have one.</summary>
    public double? ReadOfGood =>
        _pictures.Values.Where(picture => picture.Defect.Length == 0).Average(picture => picture.Result.IsRead ? 1.0 : (double?)0);

    /// <summary>Mean error of all pictures that were read, ms.</summary>
    public double MeanErrorMs => Errors().DefaultIfEmpty(double.NaN).Average();

    /// <summary>95th percentile of the absolute error, ms.</summary>
    public double ErrorP95Ms => Read == 0 ? double.NaN : Quantile.Of(Errors().Select(Math.Abs), 0.95);

    /// <summary>Gets the result as lines of text.</summary>
    public IEnumerable<string> Lines()
    {
        yield return SimulationMessages.Read(Pictures, Read, 100 * ReadOfGood, Misread, MisreadMs);
        if (Read > 0) yield return SimulationMessages.Error(MeanErrorMs, ErrorP95Ms);
        foreach (var group in _pictures.Values.GroupBy(picture => picture.Defect).OrderBy(group => group.Key, StringComparer.Ordinal))
            yield return Text($"{(group.Key.Length == 0 ? "no defect" : group.Key)}: {group.Count()} pictures, {group.Count(picture => picture.Result.IsRead)} read");
        foreach (var fault in _pictures.Values.Where(picture => !picture.Result.IsRead).GroupBy(picture => picture.Result.Fault).OrderByDescending(fault => fault.Count()))
            yield return Text($"rejected: {fault.Key}: {fault.Count()}");
        foreach (var (result, error, defect) in Wrong().Take(20)) yield return Text($"misread: picture {result.File} by {error:0.0} ms{(defect.Length == 0 ? "" : ", " + defect)}");
    }

    void RejectOutliers()
    {
        int[] places = [.. _pictures.Keys];
        var results = Outliers.Rejected([.. places.Select(place => _pictures[place].Result)]);
        for (var i = 0; i < places.Length; i++) _pictures[places[i]] = _pictures[places[i]] with { Result = results[i] };
    }

    IEnumerable<double> Errors() => _pictures.Values.Where(picture => picture.Result.IsRead).Select(picture => picture.ErrorMs);

    IEnumerable<Checked> Wrong() =>
        _pictures.Values.Where(picture => picture.Result.IsRead && !(Math.Abs(picture.ErrorMs) <= MisreadMs));

    static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);

    readonly record struct Checked(PictureResult Result, double ErrorMs, string Defect);
}
