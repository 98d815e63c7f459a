using System.Globalization;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Latency.Sweep;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Computes a profile and a page from the L_visu of the pictures. If there is a sweep, also determines a render time limit.</summary>
sealed class VlcEvaluation
{
    /// <summary>Minimum share of pictures found in the sweep. Some codes match the log of another recording by chance.</summary>
    const double MinShareJoined = 0.2;

    /// <summary>Minimum share if the order of the pictures is needed but unknown. In a wrong order, most pictures do not match.</summary>
    const double MinShareJoinedInUnknownOrder = 0.9;

    /// <summary>Minimum share of pictures near the median. At one load, only a few frames wait behind a slow one.</summary>
    const double MinShareNear = 0.9;

    /// <summary>Number of pictures below which the page warns. Fewer do not show how much L_visu scatters and how accurate its mean is.</summary>
    const int FewPictures = 10;

    readonly VlcResult _result;
    readonly List<string> _warnings = [];

    /// <param name="sweep">The sweep, or null for none.</param>
    /// <param name="earlier">The earlier profile, whose limit is kept if no limit is found.</param>
    /// <exception cref="InputException">The sweep belongs to another recording.</exception>
    public VlcEvaluation(VlcResult result, IReadOnlyList<SweepRow> sweep, EarlierProfile earlier)
    {
        _result = result;
        // Without a picture that was read, the sweep is not evaluated.
        if (result.Read.Count == 0) sweep = null;
        var sensitivity = sweep == null ? null : LoadSensitivity.Judge(sweep);
        if (sweep != null) Pictures = Joined(sweep, sensitivity.Source);
        var fit = sensitivity == null ? null : FitOf(sensitivity);
        Profile = fit != null
            ? RangeProfile.Of(fit, earlier.Conditions, sensitivity.Source, earlier.Profile?.HeadMotion)
            : WithoutRange(sweep != null, earlier);
        Page = earlier.WithWarnings(fit != null ? RangeProfile.Page("Visible light", Profile, fit, Pictures, Facts(), _warnings) : PlainPage());
    }

    /// <summary>The pictures with the values of their frames in the sweep; empty if there is no sweep.</summary>
    public IReadOnlyList<MeasuredPicture> Pictures { get; } = [];

    /// <summary>The profile, or null if there are too few pictures.</summary>
    public LatencyProfile Profile { get; }

    public CalibrationPageData Page { get; }

    IReadOnlyList<MeasuredPicture> Joined(IReadOnlyList<SweepRow> sweep, RenderTimeSourceKind source)
    {
        var join = new SweepJoin(sweep, source);
        var joined = join.Join(_result.Pictures);
        var isOrderUnknown = join.NeedsOrder && !TimeOrder.Of(_result.Pictures).IsGivenOrder;
        if (joined.Count < (isOrderUnknown ? MinShareJoinedInUnknownOrder : MinShareJoined) * _result.Read.Count)
            throw new InputException($"--sweep: the log has the frames of only {joined.Count} of {_result.Read.Count} pictures; {ReasonOf(isOrderUnknown)}");
        if (joined.Count < _result.Read.Count)
            _warnings.Add($"{_result.Read.Count - joined.Count} of {_result.Read.Count} pictures show a frame that is not in the sweep log");
        var (measured, others) = (sweep.Count(row => row.RenderMs.HasValue), sweep.Count(row => row.RenderMs.HasValue && row.Source != source));
        if (others > 0)
            _warnings.Add($"{others} of {measured} render times of the sweep were measured with a source other than "
                + $"{RenderTimeSourceNames.NameOf(source)} and are not used");
        return joined;
    }

    static string ReasonOf(bool isOrderUnknown) => isOrderUnknown
        ? FormattableString.Invariant($"codes repeat after {TimestampCode.PeriodMs / 1000.0:0.0} s, the sweep is longer, and the pictures are not in the order in which ")
            + "they were taken: name the files so that they sort in that order"
        : "use the log of the sweep that the pictures show";

    // Returns null if no range can be determined. Adds the reason to the warnings.
    RangeFitResult FitOf(LoadSensitivity sensitivity)
    {
        if (sensitivity.Sight != LoadSight.Seen)
        {
            _warnings.Add(sensitivity.Words);
            return null;
        }
        try
        {
            var measured = Pictures.Where(each => each.RenderMs.HasValue);
            return RangeFit.Fit([.. measured.Select(each => new LatencyPair(each.RenderMs.Value, each.VisuMs))]);
        }
        catch (InputException bad)
        {
            _warnings.Add(bad.Message);
            return null;
        }
    }

    // Returns null if there are too few pictures. Adds the reason to the warnings.
    LatencyProfile WithoutRange(bool hasSweep, EarlierProfile earlier)
    {
        if (_result.Read.Count == 0)
        {
            _warnings.Add(_result.NothingRead());
            return null;
        }
        var plateau = hasSweep && Pictures.Any(each => each.Vertices != Pictures[0].Vertices)
            ? Plateau.OfSweep(Pictures)
            : Plateau.OfOneLoad([.. _result.Read.Select(picture => picture.VisuMs)]);
        if (!hasSweep && plateau?.Count < MinShareNear * _result.Read.Count)
            _warnings.Add($"{_result.Read.Count - plateau.Count} of {_result.Read.Count} pictures are late and were not used. "
                + "If they were taken at several loads, add the sweep's log with --sweep");
        if (plateau?.Count < FewPictures) _warnings.Add($"L_visu was computed from {plateau.Count} pictures only and may be wrong by some ms: take 30 or more");
        if (plateau != null) return earlier.With(plateau.VisuMs, plateau.SpreadMs, CalibrationMethod.VisibleLight, plateau.Count);
        _warnings.Add(hasSweep
            ? $"L_visu cannot be determined from these {Pictures.Count} pictures of the sweep; no profile was written"
            : _result.Read.Count < 2
                ? "one picture is not enough for a profile; none was written"
                : FormattableString.Invariant($"L_visu scatters by {_result.Deviation:0.0} ms, too much for a constant. ")
                    + "If the pictures were taken at several loads, add the sweep's log with --sweep. No profile was written");
        return null;
    }

    CalibrationPageData PlainPage() => new(
        "Visible light",
        Profile == null
            ? string.Create(CultureInfo.InvariantCulture, $"L_visu cannot be determined; pictures read: {_result.Read.Count}.")
            : string.Create(CultureInfo.InvariantCulture,
                $"L_visu is {Profile.Visualisation.Length.TotalMilliseconds:0.0} ms ± {Profile.Spread.TotalMilliseconds:0.0} ms, from {Profile.Measurements} pictures."),
        [.. Profile == null ? [] : ProfileFacts.Of(Profile), .. Facts()])
    {
        Warnings = _warnings,
        Sections = [VlcPage.OverPictures(_result), .. RangePage.Sections(Pictures, null)],
    };

    IEnumerable<string[]> Facts()
    {
        yield return ["Pictures", _result.Pictures.Count.ToString(CultureInfo.InvariantCulture)];
        yield return ["Rejected", _result.Rejected.ToString(CultureInfo.InvariantCulture)];
        foreach (var (fault, files) in _result.Faults()) yield return [$"– {fault}", string.Create(CultureInfo.InvariantCulture, $"{files.Count}: {string.Join(", ", files.Select(Path.GetFileName))}")];
    }
}
