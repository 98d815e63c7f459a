using System.Globalization;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;
using Nowpose.Latency.Sweep;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>
/// Computes a latency profile and the calibration page from the L_visu values of the pictures; with a sweep, also a render time limit.
/// </summary>
sealed class VlcEvaluation
{
    /// <summary>Minimum share of pictures found in the sweep. Some codes match the log of another recording by chance.</summary>
    const double MinShareJoined = 0.2;

    /// <summary>Minimum share of pictures near the median. At one load, only a few frames wait behind a slow one.</summary>
    const double MinShareNear = 0.9;

    /// <summary>Number of pictures below which the page warns: the scatter of L_visu and the accuracy of its mean are then uncertain.</summary>
    const int FewPictures = 10;

    readonly VlcResult _result;
    readonly List<string> _warnings = [];

    /// <param name="sweep">Rows of the sweep's log; null if there is none.</param>
    /// <param name="earlier">The earlier profile, whose limit is kept if no limit is found.</param>
    /// <exception cref="InputException">The sweep belongs to another recording.</exception>
    public VlcEvaluation(VlcResult result, IReadOnlyList<SweepRow> sweep, EarlierProfile earlier)
    {
        _result = result;
        // If no picture could be read, the sweep is not evaluated.
        if (result.Read.Count == 0) sweep = null;
        var sensitivity = sweep == null ? null : LoadSensitivity.Judge(sweep);
        if (sweep != null) (Source, Pictures) = (sensitivity.Source, Joined(sweep, sensitivity.Source));
        var fit = sensitivity == null ? null : FitOf(sensitivity, earlier.Conditions);
        Profile = fit != null
            ? RangeProfile.Of(fit, earlier.Conditions, sensitivity.Source, earlier.Profile?.HeadMotion)
            : WithoutRange(sweep != null, earlier);
        var span = ExposureSpan.Of(result, Profile?.Spread.TotalMilliseconds, earlier.Conditions.DisplayHz);
        if (span.IsNarrow) _warnings.Add(VlcMessages.NarrowExposures(span.Ms, span.MaxErrorMs));
        Page = earlier.WithWarnings(fit != null ? RangeProfile.Page("Visible light", Profile, fit, Pictures, Facts(), _warnings) : PlainPage());
    }

    /// <summary>The pictures with the values of their frames in the sweep; empty without a sweep.</summary>
    public IReadOnlyList<MeasuredPicture> Pictures { get; } = [];

    /// <summary>Source of the render times of the pictures; <see cref="RenderTimeSourceKind.None"/> without a sweep.</summary>
    public RenderTimeSourceKind Source { get; }

    /// <summary>The profile, or null if there are too few pictures.</summary>
    public LatencyProfile Profile { get; }

    public CalibrationPageData Page { get; }

    IReadOnlyList<MeasuredPicture> Joined(IReadOnlyList<SweepRow> sweep, RenderTimeSourceKind source)
    {
        var join = new SweepJoin(sweep, source);
        if (join.NeedsOrder && !TimeOrder.IsOrderOfNames(_result.Pictures)) throw new InputException(VlcMessages.OrderUnknown(TimestampCode.PeriodMs / 1000.0));
        var joined = join.Join(_result.Pictures);
        if (joined.Count < MinShareJoined * _result.Read.Count) throw new InputException(VlcMessages.OtherSweep(joined.Count, _result.Read.Count));
        if (joined.Count < _result.Read.Count)
            _warnings.Add(VlcMessages.NotInSweep(_result.Read.Count - joined.Count, _result.Read.Count));
        var (measured, others) = (sweep.Count(row => row.RenderMs.HasValue), sweep.Count(row => row.RenderMs.HasValue && row.Source != source));
        if (others > 0)
            _warnings.Add(VlcMessages.OtherSource(others, measured, LatencyNames.RenderTimeSource.NameOf(source)));
        return joined;
    }

    // Returns null if no range can be determined. Adds the reason to the warnings.
    RangeFitResult FitOf(LoadSensitivity sensitivity, DisplayConditions conditions)
    {
        if (sensitivity.Sight != LoadSight.Seen)
        {
            _warnings.Add(sensitivity.Words);
            return null;
        }
        try
        {
            return RangeFit.Fit(Pictures.Where(each => each.RenderMs.HasValue), new PairOrigin(sensitivity.Source, conditions));
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
            _warnings.Add(VlcMessages.LatePictures(_result.Read.Count - plateau.Count, _result.Read.Count));
        if (plateau?.Count < FewPictures) _warnings.Add(VlcMessages.FewPictures(plateau.Count));
        if (plateau != null) return earlier.With(plateau.VisuMs, plateau.SpreadMs, CalibrationMethod.VisibleLight, plateau.Count);
        _warnings.Add(hasSweep
            ? VlcMessages.NoVisuInSweep(Pictures.Count)
            : _result.Read.Count < 2
                ? VlcMessages.OnePicture
                : VlcMessages.Scatters(_result.Deviation));
        return null;
    }

    CalibrationPageData PlainPage() => new(
        "Visible light",
        Profile == null
            ? VlcMessages.NoVisu(_result.Read.Count)
            : VlcMessages.Result(Profile.Visualisation.Length.TotalMilliseconds, Profile.Spread.TotalMilliseconds, Profile.Measurements),
        [.. Profile == null ? [] : ProfileFacts.Of(Profile), .. Facts()])
    {
        Warnings = _warnings,
        Sections = [VlcSection.OverPictures(_result), .. RangePage.Sections(Pictures, null)],
    };

    IEnumerable<string[]> Facts()
    {
        yield return ["Pictures", _result.Pictures.Count.ToString(CultureInfo.InvariantCulture)];
        yield return ["Rejected", _result.Rejected.ToString(CultureInfo.InvariantCulture)];
        foreach (var (fault, files) in _result.Faults()) yield return [$"– {fault}", string.Create(CultureInfo.InvariantCulture, $"{files.Count}: {string.Join(", ", files.Select(Path.GetFileName))}")];
    }
}
