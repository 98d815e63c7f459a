using System.CommandLine;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Gateway.Options;
using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate;

/// <summary><c>calibrate range FILE.csv</c>: finds the constant-latency range from pairs of render time and L_visu.</summary>
static class RangeVerb
{
    static readonly Argument<string> Pairs = new("FILE")
    {
        Description = "Pairs: columns render_ms and visu_ms, optionally vertices; .csv or .csv.gz.",
    };
    static readonly Option<string> Source = DeviceOptions.Source();
    static readonly CalibrationOptions Shared = new();

    public static Command Create()
    {
        var verb = new Command("range", "Estimate L_visu and the render time up to which it is constant.") { Pairs, Source };
        Shared.AddTo(verb);
        verb.SetAction(RunAsync);
        return verb;
    }

    internal static async Task<int> RunAsync(ParseResult parsed, CancellationToken cancel)
    {
        var (file, given) = (parsed.GetValue(Pairs), Shared.Conditions(parsed));
        // The files of millions of pairs take seconds.
        var (pictures, origin, fit) = await Invocation.ReadAsync(() => Read(parsed, file), cancel);
        var output = Shared.Output(parsed);
        var profile = InputPlace.In(file, () => RangeProfile.Of(fit, given.Or(origin.Conditions), origin.Source));
        var warnings = origin.Conditions.MismatchesWith(given)
            .Select(each => PairFileMessages.OtherCondition(file, each.Label, each.Calibrated, each.Actual));
        var page = RangeProfile.Page("Constant-latency range", profile, fit, pictures, [["Pairs of", file]], warnings);
        Shared.Finish(parsed, output, profile, page, fit.Json);
        return ExitStatus.Done;
    }

    static (IReadOnlyList<MeasuredPicture> Pictures, PairOrigin Origin, RangeFitResult Fit) Read(ParseResult parsed, string file)
    {
        var (pictures, origin) = PairTable.Read(file);
        origin = origin with { Source = SourceOf(parsed, file, origin.Source) };
        RequireRise(pictures, file, LatencyNames.RenderTimeSource.NameOf(origin.Source));
        var conditions = Shared.Conditions(parsed).Or(origin.Conditions);
        return (pictures, origin, InputPlace.In(file, () => RangeFit.Fit(pictures, origin with { Conditions = conditions })));
    }

    // A source in the table takes precedence over the default of the option. The option must not contradict it.
    static RenderTimeSourceKind SourceOf(ParseResult parsed, string file, RenderTimeSourceKind recorded)
    {
        var option = DeviceOptions.KindOf(parsed.GetValue(Source));
        if (recorded == RenderTimeSourceKind.None || recorded == option) return option;
        if (!parsed.IsGiven(Source)) return recorded;
        throw new InputException(PairFileMessages.OtherSource(file, parsed.GetValue(Source), LatencyNames.RenderTimeSource.NameOf(recorded)));
    }

    // Throws if the render time does not increase with the load, because no limit can then be found or monitored. Skipped for fewer than three loads.
    static void RequireRise(IReadOnlyList<MeasuredPicture> pictures, string file, string source)
    {
        const double MinRise = 0.1;
        var loads = pictures.Where(each => each.Vertices.HasValue).GroupBy(each => each.Vertices.Value).OrderBy(load => load.Key)
            .Select(load => Quantile.Of(load.Select(each => each.RenderMs.Value), 0.5)).ToArray();
        var third = loads.Length / 3;
        if (third == 0) return;
        double low = loads[..third].Average(), high = loads[^third..].Average();
        if (high - low >= MinRise * low) return;
        throw new InputException(RangeMessages.SourceDoesNotRespond(file, source, low, high));
    }
}
