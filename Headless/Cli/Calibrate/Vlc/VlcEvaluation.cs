using System.Globalization;
using Nowpose.Cli.Calibrate.Page;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>From the pictures' L_visu to a profile and a page: with a sweep also the range, without one L_visu alone.</summary>
sealed class VlcEvaluation
{
    readonly VlcResult _result;
    readonly List<string> _warnings = [];

    /// <param name="sweep">Null for none.</param>
    /// <param name="device">Null for the sweep's own, as <paramref name="displayHz"/>.</param>
    public VlcEvaluation(VlcResult result, IReadOnlyList<SweepRow> sweep, string device, double? displayHz)
    {
        _result = result;
        if (sweep != null) Pictures = Joined(sweep);
        var sensitivity = sweep == null ? null : LoadSensitivity.Judge(sweep);
        var fit = sensitivity == null ? null : FitOf(sensitivity);
        device ??= sweep?[0].Device is { Length: > 0 } logged ? logged : DeviceOptions.Standard;
        var rate = displayHz ?? (sweep?[0].DisplayHz is > 0 and double loggedHz ? loggedHz : DeviceOptions.StandardHz);
        Profile = fit != null
            ? RangeProfile.Of(fit, device, rate, sensitivity.Source)
            : result.Deviation is double deviation
                ? new LatencyProfile(result.Mean.Value, deviation, device, rate, DateTime.UtcNow, CalibrationMethod.VisibleLight, result.Read.Count)
                : null;
        if (Profile == null) _warnings.Add("one picture is too few for a profile; none was written");
        Page = fit != null ? RangeProfile.Page("Visible light", Profile, fit, Pictures, Facts(), _warnings) : PlainPage();
    }

    /// <summary>Joined with the sweep; empty without one.</summary>
    public IReadOnlyList<MeasuredPicture> Pictures { get; } = [];

    /// <summary>Null when there is too little to make one.</summary>
    public LatencyProfile Profile { get; }

    public CalibrationPageData Page { get; }

    IReadOnlyList<MeasuredPicture> Joined(IReadOnlyList<SweepRow> sweep)
    {
        var joined = new SweepJoin(sweep).Join(_result.Pictures);
        if (joined.Count < _result.Read.Count)
            _warnings.Add($"{_result.Read.Count - joined.Count} of {_result.Read.Count} pictures show a frame that the sweep log does not have");
        return joined;
    }

    // Null when no range can be told; why is said.
    RangeFitResult FitOf(LoadSensitivity sensitivity)
    {
        if (sensitivity.Sight != LoadSight.Seen)
        {
            _warnings.Add(sensitivity.Words);
            return null;
        }
        try
        {
            return RangeFit.Fit([.. Pictures.Where(each => each.RenderMs.HasValue).Select(each => new LatencyPair(each.RenderMs.Value, each.VisuMs))]);
        }
        catch (InputException bad)
        {
            _warnings.Add(bad.Message);
            return null;
        }
    }

    CalibrationPageData PlainPage() => new(
        "Visible light",
        string.Create(CultureInfo.InvariantCulture, $"L_visu is {_result.Mean:0.0} ms ± {_result.Deviation ?? 0:0.0} ms, of {_result.Read.Count} pictures."),
        [.. Profile == null ? [] : ProfileFacts.Of(Profile), .. Facts()])
    {
        Warnings = _warnings,
        Sections = [VlcPage.OverPictures(_result), .. RangePage.Sections(Pictures, null)],
    };

    IEnumerable<string[]> Facts()
    {
        yield return ["Pictures", _result.Pictures.Count.ToString(CultureInfo.InvariantCulture)];
        yield return ["Rejected", _result.Rejected.ToString(CultureInfo.InvariantCulture)];
        foreach (var (fault, count) in _result.Faults()) yield return [$"– {fault}", count.ToString(CultureInfo.InvariantCulture)];
    }
}
