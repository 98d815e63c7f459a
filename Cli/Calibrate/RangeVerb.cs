using System.CommandLine;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.Options;

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
        var (file, source, conditions) = (parsed.GetValue(Pairs), parsed.GetValue(Source), Shared.Conditions(parsed));
        var kind = DeviceOptions.KindOf(source);
        // The files of millions of pairs take seconds.
        var (pictures, fit) = await Invocation.ReadAsync(() => Read(file, source), cancel);
        var output = Shared.Output(parsed);
        var profile = RangeProfile.Of(fit, conditions, kind);
        var page = RangeProfile.Page("Constant-latency range", profile, fit, pictures, [["Pairs of", file]]);
        Shared.Finish(parsed, output, profile, page, fit.Json);
        return ExitStatus.Done;
    }

    static (IReadOnlyList<MeasuredPicture> Pictures, RangeFitResult Fit) Read(string file, string source)
    {
        var pictures = PairTable.Read(file);
        RequireRise(pictures, file, source);
        return (pictures, InputPlace.In(file, () => RangeFit.Fit([.. pictures.Select(each => new LatencyPair(each.RenderMs.Value, each.VisuMs))])));
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
